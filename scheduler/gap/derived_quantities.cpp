#include "scheduler/gap/derived_quantities.h"

#include <algorithm>
#include <cmath>

#include "scheduler/gap/number_check.h"

namespace regolab::gap {
namespace {

constexpr double kContradict = 3;  // standard errors between density and void ratio

auto find(ObservationSet& set, std::string_view id) { return std::ranges::find(set.scalars, id, &Scalar::id); }

void leave_out(ObservationSet& set, std::string_view id, const std::string& why) {
  const auto found = find(set, id);
  if (found == set.scalars.end()) return;
  set.unused.push_back({std::string(id), why});
  set.scalars.erase(found);
}

void compare_densities(const Scalar& rho, const Scalar& e, const Known& grain, Place place, Report& warnings) {
  const double meant = grain.value / rho.value - 1;
  const double error = std::hypot(e.standard_error, (1 + meant) * std::hypot(rho.standard_error / rho.value, grain.standard_error.value_or(0) / grain.value));
  if (std::abs(meant - e.value) <= kContradict * error) return;
  warnings.add(place, "void_ratio " + shown(e.value, "1") + " and bulk_density " + shown(rho.value, "kg/m3") + " contradict each other (with grains of " +
                          shown(grain.value, "kg/m3") + " that density means a void ratio of " + shown(meant, "1") + ") check the grain density; the density is kept");
}

void resolve_density(ObservationSet& set, const Merger& merger, Report& warnings) {
  const auto e = find(set, "void_ratio");
  if (e == set.scalars.end()) return;
  const auto rho = find(set, "bulk_density");
  const auto& grain = set.material.grain_density;
  if (rho != set.scalars.end()) {
    if (grain) compare_densities(*rho, *e, *grain, merger.place_of("void_ratio"), warnings);
    return leave_out(set, "void_ratio", grain ? "derived (bulk_density and the grain density say the same) the density is kept"
                                              : "one measurement with bulk_density (they would count twice) the density is kept");
  }
  if (!grain) return leave_out(set, "void_ratio", "no grain density (only with it is a void ratio a density) give material.particle_density_g_cm3");
  const double density = grain->value / (1 + e->value);
  const double error = density * std::hypot(e->standard_error / (1 + e->value), grain->standard_error.value_or(0) / grain->value);
  warnings.add(merger.place_of("void_ratio"), "void_ratio is used as the bulk density it means (" + shown(density, "kg/m3") + " with the grain density given)");
  *e = {.id = "bulk_density", .value = density, .unit = "kg/m3", .unit_as_read = e->unit_as_read, .standard_error = error, .assumed = e->assumed, .seeds = e->seeds,
        .definition = "from void_ratio and the grain density", .sigma3 = 0};
}

void resolve_strength(ObservationSet& set, const Merger& merger, Report& warnings) {
  const bool c = find(set, "cohesion") != set.scalars.end(), phi = find(set, "friction_angle_internal") != set.scalars.end();
  if (!c && !phi) return;
  const auto is_sigma1 = [](const auto& measured) { return measured.id.starts_with("sigma1_"); };
  if (std::ranges::any_of(set.scalars, is_sigma1) || std::ranges::any_of(set.curves, is_sigma1)) {
    for (const char* id : {"cohesion", "friction_angle_internal"}) leave_out(set, id, "derived (the sigma1 behind it is given, and would count twice) sigma1 is compared");
  } else if (!c || !phi) {
    leave_out(set, c ? "cohesion" : "friction_angle_internal",
              c ? "no friction_angle_internal (a strength is a line: it takes both) give it as well" : "no cohesion (a strength is a line: it takes both) give it as well, 0 where it is 0");
  } else if (set.protocol.sigma3.empty()) {
    warnings.add(merger.place_of("cohesion"), "cohesion and friction angle without the confining stresses they were fitted over (a line is known only there) add "
                                              "nominal_protocol.sigma3_kPa; the bank's lowest and highest are taken");
  }
}

}  // namespace

void resolve_derived(ObservationSet& set, const Merger& merger, Report& warnings) {
  resolve_density(set, merger, warnings);
  resolve_strength(set, merger, warnings);
}

}  // namespace regolab::gap
