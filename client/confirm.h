/// Inverse design checked by DEM: the best candidates are run, the surrogate learns from them, and so on.
#pragma once
#include <string>
#include <vector>

#include "client/wire.h"

namespace regolab::client {

/// What DEM measured of a candidate: mean over seeds and its standard error, in the targets' order and units.
struct Confirmed {
  pb::Candidate candidate;
  std::string experiment;
  int point = 0, seeds = 0;
  std::vector<double> mean, standard_error;  // [n_targets]; NaN: not measured
  double miss = 0;                           ///< largest |mean - target| / tolerance
};

/// A design of these candidates: what differs stands in its table, the rest is fixed. `columns` as InvertReply has them.
pb::SubmitRequest confirmation_design(const pb::InvertReply& reply, int candidates, unsigned seeds, const std::string& name);

/// DEM runs of one candidate and seed: settling, and each test that the targets need.
unsigned runs_of_one(const pb::InvertReply& reply);

std::vector<Confirmed> confirmed_of(const pb::InvertReply& reply, int candidates, const std::string& experiment, const pb::ResultsReply& results);

}  // namespace regolab::client
