#include "worker/output/csv_write.h"

#include <algorithm>

#include "vocab/units.h"
#include "worker/output/number_text.h"

namespace regolab {

std::string curve_csv(const Curve& curve) {
  const DoorUnit x_door = door_unit(curve.x_unit);
  const DoorUnit y_door = door_unit(curve.y_unit);
  std::string text = curve.x_name + unit_suffix(x_door.name) + "," + curve.y_name + unit_suffix(y_door.name) + "\n";
  const std::size_t points = std::min(curve.x.size(), curve.y.size());
  for (std::size_t i = 0; i < points; ++i) {
    text += shortest_text(shown_value(curve.x[i], x_door.factor)) + "," +
            shortest_text(shown_value(curve.y[i], y_door.factor)) + "\n";
  }
  return text;
}

}  // namespace regolab
