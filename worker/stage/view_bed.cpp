#include "vocab/canonical.h"
#include "worker/dem/step.h"
#include "worker/protocol/bed.h"
#include "worker/protocol/surface.h"
#include "worker/stage/envelope.h"
#include "worker/stage/open_bed.h"
#include "worker/stage/run_stage.h"

namespace regolab {
namespace {

void add_spheres(const dem::World& w, BedView& view) {
  for (std::size_t i = 0; i < w.spheres.x.size(); ++i) {
    const auto b = static_cast<std::size_t>(w.spheres.body[i]);
    const dem::Vec3 v = dem::point_velocity(w.bodies, b, w.spheres.x[i] - w.bodies.x[b], w.spheres.y[i] - w.bodies.y[b],
                                            w.spheres.z[i] - w.bodies.z[b]);
    view.spheres.push_back(
        {w.spheres.body[i], w.spheres.x[i], w.spheres.y[i], w.spheres.z[i], w.spheres.radius[i], v[0], v[1], v[2]});
  }
}

void add_contacts(const dem::World& w, const dem::Contacts& contacts, bool with_walls, BedView& view) {
  contacts.each([&](std::size_t k) {
    const auto p = static_cast<std::size_t>(contacts.slot[k]), a = static_cast<std::size_t>(contacts.body_a[k]);
    const double normal = contacts.fx[k] * contacts.nx[k] + contacts.fy[k] * contacts.ny[k] + contacts.fz[k] * contacts.nz[k];
    view.contacts.push_back({with_walls ? w.walls.sphere[p] : w.pairs.a[p], with_walls ? -1 - contacts.body_b[k] : w.pairs.b[p],
                             w.bodies.x[a] + contacts.ax[k], w.bodies.y[a] + contacts.ay[k], w.bodies.z[a] + contacts.az[k],
                             normal});
  });
}

}  // namespace

Result<BedView> view_bed(const std::string& bytes) {
  auto bed = open_bed(bytes, {});
  if (!bed) return bed.error();
  dem::compute_forces(bed->world);
  BedView view{.length = bed->length, .width = bed->width, .height = protocol::highest_point(*bed),
               .clusters = bed->world.bodies.count(), .spheres = {}, .contacts = {}};
  add_spheres(bed->world, view);
  add_contacts(bed->world, bed->world.contacts, false, view);
  add_contacts(bed->world, bed->world.wall_contacts, true, view);
  return view;
}

}  // namespace regolab
