#include "vocab/canonical.h"
#include "worker/dem/contacts.h"
#include "worker/dem/step.h"
#include "worker/protocol/bed.h"
#include "worker/protocol/surface.h"
#include "worker/stage/envelope.h"
#include "worker/stage/open_bed.h"
#include "worker/stage/run_stage.h"

namespace regolab {
namespace {

void add_spheres(const dem::World& w, BedView& view) {
  const dem::Centres at = dem::sphere_centres(w.bodies, w.spheres);
  for (std::size_t i = 0; i < at.x.size(); ++i) {
    const auto b = static_cast<std::size_t>(w.spheres.body[i]);
    const dem::Vec3 v =
        dem::point_velocity(w.bodies, b, at.x[i] - w.bodies.x[b], at.y[i] - w.bodies.y[b], at.z[i] - w.bodies.z[b]);
    view.spheres.push_back({w.spheres.body[i], at.x[i], at.y[i], at.z[i], w.spheres.radius[i], v[0], v[1], v[2]});
  }
}

void add_contacts(const dem::World& w, const std::vector<dem::Contact>& contacts, BedView& view) {
  for (const dem::Contact& c : contacts) {
    const auto a = static_cast<std::size_t>(c.body_a);
    const double normal = c.force[0] * c.normal[0] + c.force[1] * c.normal[1] + c.force[2] * c.normal[2];
    view.contacts.push_back({c.sphere_a, c.sphere_b < 0 ? -1 - c.body_b : c.sphere_b, w.bodies.x[a] + c.arm_a[0],
                             w.bodies.y[a] + c.arm_a[1], w.bodies.z[a] + c.arm_a[2], normal});
  }
}

}  // namespace

Result<BedView> view_bed(const std::string& bytes) {
  auto bed = open_bed(bytes, {});
  if (!bed) return bed.error();
  dem::compute_forces(bed->world);
  BedView view{.length = bed->length, .width = bed->width, .height = protocol::highest_point(*bed),
               .clusters = bed->world.bodies.count(), .spheres = {}, .contacts = {}};
  add_spheres(bed->world, view);
  add_contacts(bed->world, dem::contacts(bed->world), view);
  add_contacts(bed->world, dem::wall_contacts(bed->world), view);
  return view;
}

}  // namespace regolab
