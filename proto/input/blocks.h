/// The parts that job files and design files share: profile, box, tests, stress, penetration, numerics.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "input/field.h"
#include "input/map_reader.h"

namespace regolab {

inline constexpr std::uint64_t kLargestSeed = (1ULL << 53) - 1;  ///< exact in JSON too
inline constexpr std::string_view kTestNames[] = {"settle", "contacts", "density", "repose", "stress", "penetration"};

struct Tests {
  bool repose = false;
  std::vector<double> confining_stresses = {};  ///< [Pa] ascending; empty = no stress test
  std::vector<PlateSize> plates = {};           ///< thin ones first; empty = no penetration test
};

/// `profile:`, default quick; a name given by `override_name` wins over the file's. Its numerics go to `numerics`.
std::string read_profile(MapReader& top, const std::string& override_name, Numerics& numerics, Report& report);

/// `tests:` (default repose and stress), `stress: {sigma3: [...]}` (default the article's 1.25, 2.5, 5, 10 kPa), and
/// `penetration: {plates: [...], width}` (default the article's 3, 5 and 10 mm, 30 mm wide).
Tests read_tests(MapReader& top, Report& report);

/// `box: {length, width}`; where it stands and what it says. Both numbers stay 0 = by rule when there is none.
void read_box(MapReader& top, Numerics& numerics, Report& report);

/// `particles:` and every key of the `numerics:` block; gives the names that were set.
std::vector<std::string_view> read_numerics(MapReader& top, Settings& settings, Report& report);

/// `effects: {rolling_resistance: 0.3, cohesion: 200 Pa}`; gives the names that were set. A variant without its effect is told.
std::vector<std::string_view> read_effects(MapReader& top, Settings& settings, Report& report);

/// `damping_unit:` of a micro or fixed block.
DampingUnit read_damping_unit(MapReader& block, Report& report);

/// Why the box does not suit particles of that size, or empty: each side must hold two of the largest.
std::string box_problem(const Settings& settings);

/// Why a plate does not suit the box, or empty: at each side there must be room for a particle of mean size.
std::string plate_problem(const Settings& settings, const std::vector<PlateSize>& plates);

}  // namespace regolab
