/// Repeats of one quantity: the same line twice counts once, what agrees is merged by the number of repeats, all else is refused.
#pragma once
#include <map>
#include <string>

#include "input/report.h"
#include "scheduler/gap/observation.h"

namespace regolab::gap {

class Merger {
 public:
  Merger(ObservationSet& set, Report& report, Report& warnings) : set_(set), report_(report), warnings_(warnings) {}

  void add(Scalar scalar, Place place);
  void add(MeasuredCurve curve, Place place);
  /// Where a scalar stood first. REQUIRES: it was added.
  Place place_of(const std::string& id) const { return at_.at(id).second; }

 private:
  ObservationSet& set_;
  Report& report_;
  Report& warnings_;
  std::map<std::string, std::pair<std::size_t, Place>> at_, curve_at_;  ///< by id: index, where it stood first
};

}  // namespace regolab::gap
