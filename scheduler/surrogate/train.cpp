#include <algorithm>
#include <iterator>

#include "scheduler/surrogate/curves.h"
#include "scheduler/surrogate/fit.h"
#include "scheduler/surrogate/model_json.h"
#include "vocab/stage.h"

namespace regolab::surrogate {
namespace {

Error stopped() { return {Code::kCancelled, "the training was stopped (the caller has gone) nothing was stored"}; }

}  // namespace

Result<Model> train(const std::string& name, Dataset data, const OnProgress& on_progress) {
  std::vector<Family> families = families_of(data);
  if (families.empty()) {
    return Error{Code::kFailedPrecondition, "no response has " + std::to_string(kFewestRows) +
                                                " points with different numbers (there is nothing to learn) run more points"};
  }
  Model model{.name = name, .physics_version = kPhysicsVersion, .data = std::move(data), .responses = {}, .curves = {}};
  const int of = static_cast<int>(families.size()) + 1;
  for (std::size_t f = 0; f < families.size(); ++f) {
    if (on_progress && !on_progress(families[f].name, static_cast<int>(f), of)) return stopped();
    families[f].scatter = scatter_of(model.data, families[f]);
    std::vector<Hyperparameters> fitted;
    for (std::size_t k = 0; k < families[f].members.size(); ++k) fitted.push_back(fit_hyperparameters(observations_of(model.data, families[f], k)));
    auto members = response_models(model.data, families[f], fitted);
    judge(model.data, families[f], members);
    std::ranges::move(members, std::back_inserter(model.responses));
  }
  if (on_progress && !on_progress("stress-strain curves", of - 1, of)) return stopped();
  const auto strength = std::ranges::find(families, kStrengthFamily, &Family::name);
  model.curves = curve_model(model.data, strength == families.end() ? Scatter{} : strength->scatter, [](Observations o, std::size_t) {
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
  out.responses.clear();
  for (Family& family : families_of(out.data)) {
    std::vector<Hyperparameters> kept;
    const ResponseModel* before = model.find(family.members.front());
    if (!before || before->family != family.name) continue;
    family.scatter = before->scatter;
    for (const auto& process : before->processes) kept.push_back(process->hyperparameters());
    for (ResponseModel& response : response_models(out.data, family, kept)) {
      const ResponseModel& old = *model.find(response.id);
      response.inflation = old.inflation, response.noise = old.noise, response.skill = old.skill;  // of points spread over the box; the new ones crowd around one material
      out.responses.push_back(std::move(response));
    }
  }
  out.id = id_of(out);
  return out;
}

}  // namespace regolab::surrogate
