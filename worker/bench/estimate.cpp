#include "worker/bench/estimate.h"

namespace regolab::bench {
namespace {

// Steps over the article's 32 materials, one seed. `quick`: counted. `standard` and `article` follow from the quick runs:
// shear takes (strain + ramp) / rate / step; settling and repose the time simulated there, longer with the root of the bed's
// height; what comes before shear the same time. Checked on stages of two materials of `standard`: within 6 %, but for one
// slope that took 47 % more; and on one settling of `article`: 19 % fewer.
constexpr ProfileSteps kProfiles[] = {
    {"quick",
     "as counted when the article's 32 materials were run",
     {{{StageKind::kSettle, 1, {51, 24, 86}},
       {StageKind::kRepose, 1, {75, 24, 160}},
       {StageKind::kStress, 4, {54, 25, 114}}}},
     {341, 187, 693}},
    {"standard",
     "computed from the quick runs of the article's 32 materials, and checked on two",
     {{{StageKind::kSettle, 1, {53, 25, 90}},
       {StageKind::kRepose, 1, {79, 25, 168}},
       {StageKind::kStress, 4, {177, 40, 733}}}},
     {841, 347, 2080}},
    {"article",
     "computed from the quick runs of the article's 32 materials, hardly checked: take it for the order of magnitude",
     {{{StageKind::kSettle, 1, {6000, 960, 24000}},
       {StageKind::kRepose, 1, {9600, 780, 57000}},
       {StageKind::kStress, 4, {5800, 810, 32000}}}},
     {39000, 8200, 163000}},
};

Range scaled(const Range& range, double factor) { return {factor * range.mean, factor * range.least, factor * range.most}; }

}  // namespace

std::optional<ProfileSteps> steps_of_profile(std::string_view profile) {
  for (const ProfileSteps& known : kProfiles) {
    if (known.profile == profile) return known;
  }
  return std::nullopt;
}

double load_of(StageKind kind) { return kind == StageKind::kSettle ? 1.4 : kind == StageKind::kRepose ? 0.9 : 1.4; }

Estimate estimate(const ProfileSteps& profile, int clusters, double us_per_cluster_step) {
  const double second_per_thousand = 1e3 * clusters * us_per_cluster_step * 1e-6;
  Estimate out;
  double steps = 0;
  for (std::size_t k = 0; k < profile.stages.size(); ++k) {
    const StageSteps& stage = profile.stages[k];
    out.stage_s[k] = scaled(stage.thousands, load_of(stage.kind) * second_per_thousand);
    out.material_s.mean += stage.per_material * out.stage_s[k].mean;
    steps += stage.per_material * stage.thousands.mean;
  }
  // the cheapest and the dearest material, at the mean load
  const double per_thousand = out.material_s.mean / steps;
  out.material_s.least = per_thousand * profile.material.least;
  out.material_s.most = per_thousand * profile.material.most;
  return out;
}

}  // namespace regolab::bench
