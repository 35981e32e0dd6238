/// One material of the reference, simulated by us under the reference's settings.
#pragma once
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "vocab/stage.h"

namespace regolab::test {

/// Observable id -> value in the reference's units (g/cm3, deg, kPa).
using Observed = std::map<std::string, double>;

/// The settle stage of a test in reference.json: its micro-parameters, box and number; K/(p d) 300 and 1000, I = 5e-3.
StageSpec spec_of(const nlohmann::ordered_json& test, std::uint64_t seed);

/// Settles, measures, collapses and compresses it at 1.25, 2.5, 5 and 10 kPa. What a stage did not give is absent, and why
/// is said on standard error.
Observed run_material(const StageSpec& settle);

}  // namespace regolab::test
