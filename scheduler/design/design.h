/// A study as read from design.yaml: which materials are measured, how often, and what is measured on each.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "vocab/stage.h"

namespace regolab {

struct DesignFactor {
  std::string name;                 ///< theta_F, K_N, eta_N, K_T, eta_T, L_S, N_E, rotation, gravity, particles, ...
  std::string unit;                 ///< door unit of the labels ("deg", "N/m", "cm"), "1" when none
  std::vector<std::string> labels;  ///< levels in design order, in `unit`: "0.1", "20"; "mixture"; "xz"
  int column = 0;                   ///< 1-based column of the built-in array; 0 = explicit table or full factorial
};

struct DesignPoint {
  int point = 0;           ///< 1-based row of the design
  std::vector<int> level;  // [n_factors] 0-based level index
  Micro micro;
  Numerics numerics;
  EffectSet effects;
};

/// Computed from the rows themselves, never looked up.
struct ArrayQuality {
  int strength = 0;                  ///< largest t <= 3 so that any t columns hold every level combination equally often
  bool balanced = false;             ///< every level of a factor occurs equally often
  int error_degrees_of_freedom = 0;  ///< rows - 1 - sum(levels - 1): what the additive model leaves; may be negative
};

struct Design {
  std::string name;
  std::string profile;
  std::string array;  ///< "L32 (4^9 2^1)", "full factorial", "table"
  ArrayQuality quality;
  std::vector<DesignFactor> factors;
  std::vector<DesignPoint> points;
  std::vector<std::uint64_t> seeds;          ///< every point is run with each of them
  bool own_seeds = false;                    ///< each point has seeds of its own instead: those of the first, counted on (see seeds_of)
  bool repose = false;                       ///< settling and the fabric measurement are always done
  std::vector<double> confining_stresses;    ///< sigma3 of the stress tests [Pa], ascending; empty = none
  std::vector<PlateSize> plates;             ///< of the penetration test, thin ones first; empty = none
  std::map<std::string, std::string> fixed;  ///< what does not vary, as shown: "gravity" -> "1.63 m/s2"
  std::vector<std::string> notes;            ///< worth reading before it runs
};

/// The seeds that a point is run with.
std::vector<std::uint64_t> seeds_of(const Design& design, const DesignPoint& point);

/// "theta_F: 4 levels, column 1", one line per factor.
std::vector<std::string> factor_columns(const Design& design);

/// Of each point and seed.
std::size_t stages_per_run(const Design& design);

/// {"settle", "contacts", "density", "repose", "stress", "penetration"} as far as asked for.
std::vector<std::string> test_names(const Design& design);

}  // namespace regolab
