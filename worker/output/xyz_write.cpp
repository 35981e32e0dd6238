#include "worker/output/xyz_write.h"

#include "worker/output/contact_count.h"
#include "worker/output/number_text.h"

namespace regolab {

std::string bed_xyz(const BedView& bed) {
  const std::vector<int> touching = contact_count(bed);
  std::string text = std::to_string(bed.spheres.size()) + "\n";
  text += "Lattice=\"" + shortest_text(bed.length) + " 0 0 0 " + shortest_text(bed.width) + " 0 0 0 " +
          shortest_text(bed.height) + "\" ";
  text += "Properties=species:S:1:pos:R:3:radius:R:1:cluster:I:1:velo:R:3:contacts:I:1 pbc=\"F F F\" length_unit=m\n";
  for (std::size_t i = 0; i < bed.spheres.size(); ++i) {
    const SphereView& s = bed.spheres[i];
    text += "Si";
    for (const double value : {s.x, s.y, s.z, s.radius}) text += " " + shortest_text(value);
    text += " " + std::to_string(s.cluster);
    for (const double value : {s.vx, s.vy, s.vz}) text += " " + shortest_text(value);
    text += " " + std::to_string(touching[i]) + "\n";
  }
  return text;
}

}  // namespace regolab
