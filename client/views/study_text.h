/// Designs and experiments as text.
#pragma once
#include <string>

#include "client/wire.h"

namespace regolab::client {

/// Array, strength, balance, error degrees of freedom, factors, jobs, notes.
std::string summary_text(const pb::DesignSummary& summary);

/// One line an experiment, oldest first.
std::string list_text(const pb::ListReply& list);

/// State, counts, running jobs, failures.
std::string status_text(const pb::ExperimentStatus& status);

}  // namespace regolab::client
