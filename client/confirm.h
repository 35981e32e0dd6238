/// Inverse design checked by DEM: candidates are run, the surrogate learns from them, and so on until one is known to meet its targets.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "client/wire.h"

namespace regolab::client {

/// What DEM measured of one target so far. A mean of beds that scatter is an estimate, so it must also be known well enough.
struct MeasuredTarget {
  std::vector<double> runs;  ///< [target's unit]
  double value = 0, tolerance = 0;

  double mean() const;            ///< NaN without runs
  double standard_error() const;  ///< NaN below two runs
  double miss() const;            ///< |mean - value| / tolerance; infinite without runs
  bool known() const { return standard_error() <= tolerance; }
  bool met() const { return miss() <= 1 && known(); }
};

/// A material that was run, over all rounds.
struct Confirmed {
  pb::Candidate candidate;
  std::vector<std::string> experiments;
  std::vector<MeasuredTarget> targets;  // [n_targets]

  double miss() const;
  bool met() const;
  /// Its means may still fit: none is off by more than its tolerance and two standard errors. More runs must say.
  bool open() const;
};

/// The materials of the next round, `count` or fewer: what is open first, then what the surrogate proposes and nobody has run.
std::vector<pb::Candidate> next_round(const std::vector<Confirmed>& tried, const pb::InvertReply& reply, std::size_t count);

/// A design of these candidates: what differs stands in its table, the rest is fixed. `reply` says the columns and the targets.
struct RoundSeeds {
  std::uint64_t first = 1;
  unsigned count = 4;
};
pb::SubmitRequest confirmation_design(const pb::InvertReply& reply, std::span<const pb::Candidate> candidates, RoundSeeds seeds, const std::string& name);

/// DEM runs of one candidate and seed: settling, and each test that the targets need.
unsigned runs_of_one(const pb::InvertReply& reply);

/// Adds what a round measured to what is known.
void learn(const pb::InvertReply& reply, std::span<const pb::Candidate> candidates, const std::string& experiment, const pb::ResultsReply& results,
           std::vector<Confirmed>& tried);

/// Who met every target, else whose largest miss is smallest; null when nothing was run.
const Confirmed* best_of(const std::vector<Confirmed>& tried);

}  // namespace regolab::client
