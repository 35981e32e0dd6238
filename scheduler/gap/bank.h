/// The bank: what our own runs gave, a row per point and seed. What emulators learn from. SI throughout.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "input/diagnostic.h"
#include "scheduler/gap/features.h"

namespace regolab::gap {

/// A parameter of the material, of the specimen, or the strength of an effect.
struct BankInput {
  std::string name;  ///< as designs name it
  std::string unit;  ///< SI
  bool operator==(const BankInput&) const = default;
};

struct BankRow {
  std::string experiment;
  int point = 0;
  std::uint64_t seed = 0;
  std::string profile;           ///< empty when the study chose its own numerics
  std::vector<double> inputs;    // [n_inputs] choices by number (N_E 12 = mixture; rotation 0 none, 1 x, 2 z, 3 xz)
  std::vector<double> features;  // [n_features] NaN = missing
};

struct Bank {
  std::vector<BankInput> inputs;
  std::vector<std::string> features;  ///< ids
  std::vector<BankRow> rows;

  std::optional<std::size_t> input(const std::string& name) const;
  std::optional<std::size_t> feature(const std::string& id) const;
};

/// One point and seed as the store knows it.
struct BankSource {
  std::string experiment;
  int point = 0;
  std::uint64_t seed = 0;
  std::string profile;
  std::vector<std::pair<BankInput, double>> inputs;
  Readings readings;
};

/// Columns are what any source has; an input that a source does not name is 0 there (an effect that was off). Rows without any
/// feature are left out. Features come in the order of all_features; one that no row has is no column.
Bank bank_of(const std::vector<BankSource>& sources);

/// CSV, seven significant digits, SI, units in the names: experiment, point, seed, profile, inputs (`K_N_N_per_m`), features
/// (`bulk_density_kg_per_m3`); an empty cell is a missing feature.
std::string bank_csv(const Bank& bank);

/// A column whose name is no feature's is an input. Every problem at its place: missing columns, cells that are no numbers, rows of
/// another length, a row twice.
Read<Bank> read_bank(const std::string& file_name, const std::string& text);

inline constexpr std::size_t kLargestBank = 64 << 20;  ///< [bytes] of a file

}  // namespace regolab::gap
