#include "worker/bench/report.h"

#include <algorithm>
#include <cstdio>

#include "vocab/profile.h"
#include "worker/bench/estimate.h"

namespace regolab::bench {
namespace {

template <class... Numbers>
std::string text(const char* format, Numbers... numbers) {
  char out[256];
  std::snprintf(out, sizeof out, format, numbers...);
  return out;
}

/// "0.8 s", "14 min", "3.2 h", "5.1 days": two digits, as the estimate is not better.
std::string duration(double seconds) {
  if (seconds < 90) return text("%.2g s", seconds);
  if (seconds < 90 * 60.0) return text("%.2g min", seconds / 60);
  if (seconds < 48 * 3600.0) return text("%.2g h", seconds / 3600);
  return text("%.2g days", seconds / 86400);
}

std::string range_text(const Range& seconds) {
  return duration(seconds.mean) + " (" + duration(seconds.least) + " to " + duration(seconds.most) + ")";
}

std::string machine_lines(const MachineFigure& figure) {
  return text("bed       %d six-sphere clusters near rest: %d spheres, %ld contacts, %ld more with walls\n", figure.clusters,
              figure.spheres, figure.touching.grains, figure.touching.walls) +
         text("machine   %.1f us per step on one core (%.1f to %.1f in %d rounds of %d steps): %.1f M sphere-steps/s\n",
              figure.us_per_step, figure.least_us, figure.most_us, figure.rounds, figure.steps_a_round,
              figure.sphere_steps_per_s() * 1e-6);
}

std::string stage_lines(const ProfileSteps& profile, const Estimate& times) {
  std::string lines =
      text("\n%-10s  %-24s  %s\n", "stage", "1000 steps (least-most)", "one of them on one core (least to most)");
  for (std::size_t k = 0; k < profile.stages.size(); ++k) {
    const StageSteps& stage = profile.stages[k];
    const Range& steps = stage.thousands;
    const std::string times_many = stage.per_material > 1 ? " x " + std::to_string(stage.per_material) : "";
    lines += text("%-10s  %-24s  ", (std::string(name_of(stage.kind)) + times_many).c_str(),
                  text("%.0f (%.0f-%.0f)", steps.mean, steps.least, steps.most).c_str()) +
             range_text(times.stage_s[k]) + "\n";
  }
  return lines + text("%-10s  %-24s  ", "material", "") + range_text(times.material_s) + "\n";
}

std::string study_line(const Study& study, const Estimate& times) {
  const double materials = static_cast<double>(study.rows) * study.seeds;
  const double share = std::max(1.0, materials / study.workers);  // materials a worker does; one cannot be shared out well
  const Range& one = times.material_s;
  return text("\nstudy     %d %s x %d %s: ", study.rows, study.rows == 1 ? "row" : "rows", study.seeds,
              study.seeds == 1 ? "seed" : "seeds") +
         duration(materials * one.mean) + " of one core; about " +
         range_text({share * one.mean, share * one.least, share * one.most}) + " with " + std::to_string(study.workers) +
         (study.workers == 1 ? " worker\n" : " workers\n");
}

std::string assumptions(const ProfileSteps& profile, int clusters) {
  return text("assumes   %d clusters, all four stress tests;\n          steps %s;\n", clusters,
              std::string(profile.source).c_str()) +
         text(
             "          a cluster costs a step as much as in this bed, times %.2g in settling, %.2g in repose, %.2g in "
             "stress;\n",
             load_of(StageKind::kSettle), load_of(StageKind::kRepose), load_of(StageKind::kStress)) +
         "          every worker has a core of its own. The ranges are the cheapest and the dearest of those materials: "
         "light\n"
         "          grains, stiff springs and strong dashpots shorten the time step\n";
}

}  // namespace

std::string report(const MachineFigure& figure, const Study& study) {
  const Numerics numerics = *profile(study.profile);
  const ProfileSteps steps = *steps_of_profile(study.profile);
  const Estimate times = estimate(steps, numerics.clusters, figure.us_per_cluster_step());
  return machine_lines(figure) + stage_lines(steps, times) + study_line(study, times) +
         assumptions(steps, numerics.clusters);
}

}  // namespace regolab::bench
