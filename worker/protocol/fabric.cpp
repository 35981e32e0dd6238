#include "worker/protocol/fabric.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "vocab/units.h"
#include "worker/dem/contacts.h"
#include "worker/dem/step.h"
#include "worker/effects/strengths.h"
#include "worker/protocol/surface.h"

namespace regolab::protocol {
namespace {

constexpr int kAngleBins = 18;
constexpr int kFewestContacts = 3;  // a cluster with fewer bears nothing: a rattler [physics, section 6]

struct Counts {
  double contacts = 0;              // pairs of touching spheres of different clusters
  double neighbours = 0;            // pairs of touching clusters
  double rattlers = 0;
  double contacts_of_bearers = 0;   // pairs whose clusters are both no rattlers
  double clusters = 0;
};

Counts count(const dem::World& w, const std::vector<dem::Contact>& contacts) {
  const auto n = static_cast<std::size_t>(w.bodies.count());
  std::vector<int> touches(n, 0);
  std::set<std::pair<int, int>> neighbours;
  Counts out{.clusters = static_cast<double>(n)};
  const auto of = [&](int body) -> int& { return touches[static_cast<std::size_t>(body)]; };
  for (const dem::Contact& c : contacts) {
    ++out.contacts;
    ++of(c.body_a);
    ++of(c.body_b);
    neighbours.insert(std::minmax(c.body_a, c.body_b));
  }
  for (const dem::Contact& c : dem::wall_contacts(w)) ++of(c.body_a);
  out.neighbours = static_cast<double>(neighbours.size());
  out.rattlers = static_cast<double>(std::count_if(touches.begin(), touches.end(), [](int t) { return t < kFewestContacts; }));
  for (const dem::Contact& c : contacts) out.contacts_of_bearers += of(c.body_a) >= kFewestContacts && of(c.body_b) >= kFewestContacts;
  return out;
}

/// Shares of contact normals over the horizontal angle (in the base plane, 0 to 180 deg: a normal has no sign) and the vertical
/// angle (from the base plane, 0 to 90 deg).
std::pair<Curve, Curve> contact_angles(const std::vector<dem::Contact>& contacts) {
  Curve horizontal{"contact_angle_horizontal", "settle", "horizontal_angle", "rad", "share_of_contacts", "1", {}, {}};
  Curve vertical{"contact_angle_vertical", "settle", "vertical_angle", "rad", "share_of_contacts", "1", {}, {}};
  const double bin_h = std::numbers::pi / kAngleBins, bin_v = 0.5 * std::numbers::pi / kAngleBins;
  for (int i = 0; i < kAngleBins; ++i) {
    horizontal.x.push_back((i + 0.5) * bin_h);
    vertical.x.push_back((i + 0.5) * bin_v);
  }
  horizontal.y.assign(kAngleBins, 0.0);
  vertical.y.assign(kAngleBins, 0.0);
  const double share = 1.0 / std::max<double>(1.0, static_cast<double>(contacts.size()));
  const auto add = [&](Curve& curve, double angle, double bin) {
    curve.y[static_cast<std::size_t>(std::clamp(static_cast<int>(angle / bin), 0, kAngleBins - 1))] += share;
  };
  for (const dem::Contact& c : contacts) {
    double azimuth = std::atan2(c.normal[1], c.normal[0]);
    if (azimuth < 0) azimuth += std::numbers::pi;
    add(horizontal, azimuth, bin_h);
    add(vertical, std::asin(std::min(1.0, std::abs(c.normal[2]))), bin_v);
  }
  return {horizontal, vertical};
}

double mean_of(const Curve& histogram) {
  double sum = 0;
  for (std::size_t i = 0; i < histogram.x.size(); ++i) sum += histogram.x[i] * histogram.y[i];
  return sum;
}

}  // namespace

StageResult measure_fabric(Bed& bed) {
  dem::compute_forces(bed.world);
  const std::vector<dem::Contact> contacts = dem::contacts(bed.world);
  const Counts c = count(bed.world, contacts);
  auto [horizontal, vertical] = contact_angles(contacts);
  const double height = mean_height(bed), top = highest_point(bed);
  const double base = bed.length * bed.width, true_share = effects::density_ratio(bed.effects);
  const double density = true_share * bed.micro.grain_density;
  const double bearers = std::max(1.0, c.clusters - c.rattlers);
  const double void_ratio = base * height / (true_share * bed.solid_volume) - 1;
  StageResult out;
  out.measurements = {
      {"contacts_per_particle", c.contacts / c.clusters, "1", {},
       "sphere-sphere contacts between different clusters, each counted once, divided by the number of clusters; settled state, "
       "walls not counted, rattlers included"},
      {"coordination_number", 2 * c.contacts / c.clusters, "1", {}, "the same counted for both clusters"},
      {"contacts_without_rattlers", c.contacts_of_bearers / bearers, "1", {},
       "the same among clusters with at least 3 contacts, divided by their number"},
      {"neighbours_per_particle", c.neighbours / c.clusters, "1", {},
       "distinct touching pairs of clusters divided by the number of clusters"},
      {"rattler_share", c.rattlers / c.clusters, "1", {}, "share of clusters with fewer than 3 contacts, walls counted"},
      {"bulk_density", density * bed.solid_volume / (base * height), "kg/m3", {},
       "rho_P V_P/(L W H), H = mean height of the free surface over 24 x 24 columns"},
      {"void_ratio", void_ratio, "1", {}, "L W H/V_P - 1, same H"},
      {"porosity", void_ratio / (1 + void_ratio), "1", {}, "same H"},
      {"bulk_density_Hmax", density * bed.solid_volume / (base * top), "kg/m3", {}, "same with H = highest point of the sample"},
      {"core_density", density * core_solid_fraction(bed, height), "kg/m3", {},
       "solid fraction inside 0.15-0.85 L, 0.15-0.85 W, 0.2-0.75 H times rho_P"},
      {"mean_contact_angle_horizontal", mean_of(horizontal), "rad", {}, "mean angle of contact normals in the base plane, 0 to 180 deg"},
      {"mean_contact_angle_vertical", mean_of(vertical), "rad", {}, "mean angle of contact normals from the base plane, 0 to 90 deg"},
  };
  out.numerics = {
      {"bed_height", height, "m", {}, "mean free surface"},
      {"solid_volume", bed.solid_volume, "m3", {}, "of all clusters"},
      {"box_length", bed.length, "m", {}, ""},
      {"box_width", bed.width, "m", {}, ""},
  };
  out.curves = {std::move(horizontal), std::move(vertical)};
  return out;
}

}  // namespace regolab::protocol
