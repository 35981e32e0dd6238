/// Results of one experiment, and the article's tables, as text.
#pragma once
#include <string>

#include "client/wire.h"

namespace regolab::client {

/// One line a row: factors, responses (the article's, or all), and below why cells are missing.
std::string results_text(const pb::ResultsReply& results, bool all);

/// How many entries of each table follow from the data, and those that do not (or all) with the reason.
std::string check_text(const pb::CheckArticleReply& check, bool all);

/// Correlation and errors per response, then test by test.
std::string comparison_text(const pb::CompareArticleReply& comparison, bool cells = true);

}  // namespace regolab::client
