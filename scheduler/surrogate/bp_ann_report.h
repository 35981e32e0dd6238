/// The three prediction functions trained and measured: Table 12 on a recorded split, and what left-out tests say.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scheduler/surrogate/bp_ann.h"
#include "vocab/result.h"
#include "vocab/result_table.h"

namespace regolab::surrogate {

/// One column of Table 12.
struct FunctionGroup {
  std::string name;                ///< "training", "validation", "test", "all"
  std::vector<int> points;         ///< of the table; empty for "all"
  std::optional<double> r;         ///< mean over the outputs of their R
  std::optional<double> r_pooled;  ///< all normalised outputs in one R
  double article_r = 0;            ///< as printed
};

struct OutputReport {
  std::string response;  ///< as AnnOutput
  std::string unit;      ///< door unit of every rms here
  FitQuality left_out;
  std::vector<FitQuality> groups;  // [4] in the order of FunctionReport::groups
};

struct FunctionReport {
  std::string name;     ///< "BP-ANN-1"
  std::string problem;  ///< not empty: not trained, and why
  std::vector<std::string> inputs;
  int weights = 0;
  double weights_in_use = 0;  ///< of the network chosen on the split
  int chosen_start = 0;       ///< 1-based
  TrainEffort effort;
  std::vector<FunctionGroup> groups;  // [4]
  std::vector<OutputReport> outputs;
};

struct FunctionsReport {
  std::string experiment;
  std::uint64_t seed = 0;
  std::vector<FunctionReport> functions;  // [3]
  std::vector<std::string> notes;
};

/// Trains on any experiment. A function whose factors or numbers are not there is reported with its problem. Errors: the
/// first problem when none can be trained; kFailedPrecondition when a number is not finite.
Result<FunctionsReport> train_functions(const ResultTable& table, std::uint64_t seed);

/// The same on the article's Tables 2, 3, 5, 7 and 9. BP-ANN-1 learns void ratios recomputed from the density; an output
/// `void_ratio_as_printed` says how it does on Table 5 as it stands.
FunctionsReport train_article_functions(std::uint64_t seed);

}  // namespace regolab::surrogate
