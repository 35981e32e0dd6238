#include <algorithm>

#include "scheduler/surrogate/curves.h"
#include "scheduler/surrogate/fit.h"
#include "scheduler/surrogate/model_json.h"
#include "vocab/stage.h"

namespace regolab::surrogate {
namespace {

bool varies(const Observations& o) { return o.y.size() > 0 && o.y.maxCoeff() > o.y.minCoeff(); }

Error stopped() { return {Code::kCancelled, "the training was stopped (the caller has gone) nothing was stored"}; }

}  // namespace

Result<Model> train(const std::string& name, Dataset data, const OnProgress& on_progress) {
  std::vector<std::string> wanted;
  for (const auto& [id, unit] : data.unit) {
    std::vector<std::size_t> rows;
    if (is_modelled(id) && varies(observations_of(data, id, rows)) && rows.size() >= kFewestRows) wanted.push_back(id);
  }
  if (wanted.empty()) {
    return Error{Code::kFailedPrecondition, "no response has " + std::to_string(kFewestRows) +
                                                " points with different numbers (there is nothing to learn) run more points"};
  }
  Model model{.name = name, .physics_version = kPhysicsVersion, .data = std::move(data), .responses = {}, .curves = {}};
  const int of = static_cast<int>(wanted.size()) + 1;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (on_progress && !on_progress(wanted[k], static_cast<int>(k), of)) return stopped();
    std::vector<std::size_t> rows;
    const auto fitted = fit_hyperparameters(observations_of(model.data, wanted[k], rows));
    model.responses.push_back(response_model(model.data, wanted[k], fitted));
  }
  if (on_progress && !on_progress("stress-strain curves", of - 1, of)) return stopped();
  model.curves = curve_model(model.data, [](Observations o, std::size_t) {
    const Hyperparameters fitted = fit_hyperparameters(o);
    return GaussianProcess(std::move(o), fitted);
  });
  model.id = id_of(model);
  return model;
}

Result<Model> with_rows(const Model& model, const std::vector<Source>& sources) {
  Model out = model;
  for (const Source& source : sources) {
    auto rows = rows_of(source, model.data.columns);
    if (!rows.ok()) return rows.error();
    out.data.rows.insert(out.data.rows.end(), rows->begin(), rows->end());
  }
  for (ResponseModel& response : out.responses) {
    const double inflation = response.inflation;  // of the points spread over the box; the new ones crowd around one material
    response = response_model(out.data, response.id, response.process.hyperparameters());
    response.inflation = inflation;
  }
  out.id = id_of(out);
  return out;
}

}  // namespace regolab::surrogate
