/// The plate of the penetration test as people name it: width x thickness, as in the article's "30 x 3 mm" [article Sec. 4.2].
#pragma once
#include <charconv>
#include <cmath>
#include <string>

namespace regolab {

/// Its cross-section seen from above; the thin edge goes down first. Zeros: no plate.
struct PlateSize {
  double width = 0;      ///< along the box's length [m]
  double thickness = 0;  ///< along its width [m]

  bool operator==(const PlateSize&) const = default;
};

/// "30x3mm", whole micrometres: what the observation ids end in.
inline std::string plate_text(const PlateSize& plate) {
  const auto millimetres = [](double metres) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, std::round(metres * 1e6) / 1e3);
    return std::string(buffer, end.ptr);
  };
  return millimetres(plate.width) + "x" + millimetres(plate.thickness) + "mm";
}

}  // namespace regolab
