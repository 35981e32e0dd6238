/// An explicit design as CSV: one column per factor, one row per point.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "input/report.h"
#include "scheduler/design/factor_block.h"

namespace regolab {

/// Columns are named `theta_F_deg`, `K_N_N_per_m` (unit_suffix of vocab/units.h: ' ' becomes _, '/' becomes _per_), or
/// `K_N (N/m)`, `K_N [N/m]`, or `N_E`; cells are numbers in that unit, or with a unit of their own. A column `point` or
/// `test` must count 1, 2, 3, ... Factors already read (`factors:`) keep their levels; others take theirs from the column,
/// ascending. Gives the level indices [n_rows][n_factors], empty when anything was reported. `report` is the CSV file's own.
std::vector<std::vector<int>> read_table(std::string_view csv, DampingUnit damping, std::vector<FactorLevels>& factors,
                                         Report& report);

}  // namespace regolab
