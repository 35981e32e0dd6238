/// Contacts of each sphere, walls included.
#pragma once
#include <vector>

#include "worker/stage/run_stage.h"

namespace regolab {

inline std::vector<int> contact_count(const BedView& bed) {  // [n_spheres]
  std::vector<int> count(bed.spheres.size(), 0);
  for (const ContactView& contact : bed.contacts) {
    ++count.at(static_cast<std::size_t>(contact.sphere_a));
    if (contact.sphere_b >= 0) ++count.at(static_cast<std::size_t>(contact.sphere_b));
  }
  return count;
}

}  // namespace regolab
