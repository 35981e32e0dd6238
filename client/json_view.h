/// Replies as JSON. Documents are named "regolab.<verb>/1"; a key that holds a physical number ends in its door unit, or
/// stands beside a "unit". Numbers carry every digit; what is not known is null.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "client/wire.h"
#include "input/diagnostic.h"

namespace regolab::client {

using Json = nlohmann::ordered_json;

Json document(const std::string& verb);  ///< {"format": "regolab.<verb>/1"}

Json json_of(const std::vector<Diagnostic>& diagnostics);
Json json_of(const pb::DesignSummary& summary);
Json json_of(const pb::ExperimentStatus& status);
Json json_of(const pb::WatchEvent& event);
Json json_of(const pb::RangeReply& range);  ///< the list of responses
void add_results(const pb::ResultsReply& results, Json& document);
void add_check(const pb::CheckArticleReply& check, Json& document);
void add_comparison(const pb::CompareArticleReply& comparison, Json& document);
void add_functions(const pb::TrainFunctionsReply& trained, Json& document);
Json json_of(const pb::ExportItem& item);  ///< without its curves, which are files

/// Indented, with a line break at the end; bytes that are not UTF-8 are replaced.
std::string text_of(const Json& document);
std::string line_of(const Json& document);

}  // namespace regolab::client
