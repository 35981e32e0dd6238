/// Gap diagnosis in words and tables.
#pragma once
#include <string>
#include <vector>

#include "client/wire.h"

namespace regolab::client {

/// The table of features, what takes no part and why, warnings apart.
std::string import_text(const pb::ImportReply& reply);

/// Three plain lines first: where, which, how sure; then the ladder of causes and what these measurements can tell apart.
/// The groups alone, with the line that sums them up.
std::string where_text(const pb::Diagnosis& diagnosis);

/// "by 74 % (shrinkage 61 to 83 %) with cohesion, in 8 new runs ...", or why there is no figure.
std::string shrinkage_line(const pb::Diagnosis& diagnosis);
/// The lines of a confirmation, and each held-out feature: measured, by the base model's runs, by the repaired one's.
std::string shrinkage_text(const pb::Diagnosis& diagnosis);

std::string diagnosis_text(const pb::Diagnosis& diagnosis);
/// The three lines alone.
std::vector<std::string> diagnosis_lines(const pb::Diagnosis& diagnosis);

}  // namespace regolab::client
