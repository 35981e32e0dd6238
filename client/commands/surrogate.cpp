#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/csv_write.h"
#include "client/file_write.h"
#include "client/json_view.h"
#include "client/materials.h"
#include "client/number_text.h"
#include "client/session.h"
#include "client/surrogate_json.h"
#include "client/views/surrogate_text.h"
#include "vocab/units.h"

namespace regolab::client {
namespace {

/// A line per material and response, then the curves' points.
std::string predictions_csv(const pb::PredictReply& reply) {
  std::string text = csv_line({"material", "response", "axial_strain", "unit", "value", "low_90", "high_90", "mean_low_90", "mean_high_90", "outside_the_data"});
  for (int m = 0; m < reply.predictions_size(); ++m) {
    const auto& p = reply.predictions(m);
    const std::string outside = fmt::format("{}", fmt::join(p.outside().begin(), p.outside().end(), "; "));
    const auto line = [&](const pb::Estimate& e, const std::string& response, const std::string& strain) {
      text += csv_line({std::to_string(m + 1), response, strain, e.unit(), shortest(e.value()), shortest(e.low()), shortest(e.high()), shortest(e.mean_low()),
                        shortest(e.mean_high()), outside});
    };
    for (const auto& e : p.estimates()) line(e, e.response(), "");
    for (const auto& c : p.curves()) {
      for (int k = 0; k < c.sigma1_size(); ++k) {
        line(c.sigma1(k), "sigma1_at_sigma3_" + shortest(c.sigma3_pa() / 1000) + "kPa", shortest(c.axial_strain(k)));
      }
    }
  }
  return text;
}

std::string predictions_text(const pb::PredictReply& reply) {
  std::string text = fmt::format("model {} ({})\n", reply.model(), reply.model_name());
  for (int m = 0; m < reply.predictions_size(); ++m) {
    if (reply.predictions_size() > 1) text += fmt::format("\nmaterial {}\n", m + 1);
    text += prediction_text(reply.predictions(m));
    for (const auto& curve : reply.predictions(m).curves()) text += curve_text(curve);
  }
  return text;
}

Outcome give_out(const Arguments& arguments, Console& console, const std::string& text) {
  if (!arguments.output.empty()) return write_file(arguments.output, text);
  console.out << text << std::flush;
  return done();
}

}  // namespace

Outcome train(const Arguments& arguments, Console& console) {
  Session session;
  if (auto opened = open_session(arguments, Need::kStored, session); !opened.ok()) return opened;
  pb::TrainRequest request;
  request.set_name(arguments.name);
  request.set_want_file(!arguments.output.empty());
  if (auto found = resolve_experiments(*session.lab, arguments, console, *request.mutable_experiments()); !found.ok()) return session.explain(found);
  pb::TrainEvent last;
  const auto show = [&](const pb::TrainEvent& event) {
    console.err << fmt::format("training {}/{}: {}\n", event.done() + 1, event.of(), event.response()) << std::flush;
  };
  if (auto trained = session.lab->train(request, show, last); !trained.ok()) return session.explain(trained);
  if (!arguments.output.empty()) {
    if (auto written = write_file(arguments.output, last.file()); !written.ok()) return written;
  }
  if (arguments.json) {
    Json out = document("train");
    out["model"] = json_of(last.model());
    console.out << text_of(out);
    return done();
  }
  console.out << model_text(last.model()) << std::flush;
  hint(arguments, console, "predict --set theta_F=40degree ...");
  return done();
}

Outcome models(const Arguments& arguments, Console& console) {
  Session session;
  if (auto opened = open_session(arguments, Need::kStoredOrScratch, session); !opened.ok()) return opened;
  pb::ListModelsReply reply;
  if (auto got = session.lab->models(reply); !got.ok()) return session.explain(got);
  if (arguments.json) {
    Json out = document("models");
    out["models"] = Json::array();
    for (const auto& model : reply.models()) out["models"].push_back(json_of(model));
    console.out << text_of(out);
    return done();
  }
  if (reply.models().empty()) console.err << "no model here (this build ships none) train one: regolab train EXPERIMENT\n";
  for (const auto& model : reply.models()) console.out << model_text(model) << "\n";
  console.out.flush();
  return done();
}

Outcome predict(const Arguments& arguments, Console& console) {
  pb::PredictRequest request;
  request.set_model(arguments.model);
  if (auto read = read_materials(arguments, request); !read.ok()) return read;
  std::vector<double> stresses;
  if (auto read = read_stresses(arguments, stresses); !read.ok()) return read;
  if (arguments.curves && stresses.empty()) return failed(Exit::kUsage, "--curves needs a confining stress (curves belong to one) add --sigma3 5kPa");
  for (const double stress : stresses) arguments.curves ? request.add_curves_at_pa(stress) : request.add_sigma3_pa(stress);
  Session session;
  if (auto opened = open_session(arguments, Need::kStoredOrScratch, session); !opened.ok()) return opened;
  pb::PredictReply reply;
  if (auto got = session.lab->predict(request, reply); !got.ok()) return session.explain(got);
  if (!arguments.json) return give_out(arguments, console, arguments.csv ? predictions_csv(reply) : predictions_text(reply));
  Json out = document("predict");
  add_predictions(reply, out);
  return give_out(arguments, console, text_of(out));
}

}  // namespace regolab::client
