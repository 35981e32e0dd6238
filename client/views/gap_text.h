/// Gap diagnosis in words and tables.
#pragma once
#include <string>
#include <vector>

#include "client/wire.h"

namespace regolab::client {

/// The table of features, what takes no part and why, warnings apart.
std::string import_text(const pb::ImportReply& reply);

/// Three plain lines first: where, which, how sure; then the ladder of causes and what these measurements can tell apart.
std::string diagnosis_text(const pb::Diagnosis& diagnosis);
/// The three lines alone.
std::vector<std::string> diagnosis_lines(const pb::Diagnosis& diagnosis);

}  // namespace regolab::client
