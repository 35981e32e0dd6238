/// Range analysis as text: all responses on one page, or one response in full.
#pragma once
#include <string>

#include "client/wire.h"

namespace regolab::client {

/// Factors down, responses across, R in each cell with its standard error over seeds and its marks: * p < 0.05, ! fragile.
std::string range_matrix_text(const pb::RangeReply& range);

/// R, ANOVA, leave-one-run-out and the level means of one response.
std::string range_detail_text(const pb::ResponseAnalysis& analysis);

}  // namespace regolab::client
