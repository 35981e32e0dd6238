/// Analysis results to their wire form: field by field, nothing decided here.
#pragma once
#include <string>
#include <vector>

#include "input/diagnostic.h"
#include "regolab/v1/lab.pb.h"
#include "scheduler/analysis/article.h"
#include "scheduler/analysis/range.h"
#include "scheduler/design/design.h"

namespace regolab {

v1::Diagnostic to_proto(const Diagnostic& diagnostic);

/// All but jobs, jobs_stored and dem_jobs, which the store knows.
v1::DesignSummary to_proto(const Design& design);

v1::ResponseAnalysis to_proto(const analysis::ResponseAnalysis& analysis);
v1::RangeReply to_proto(const std::string& experiment, const std::vector<analysis::ResponseAnalysis>& responses);
v1::CheckArticleReply to_proto(const analysis::ArticleCheck& check);
v1::CompareArticleReply to_proto(const std::string& experiment, const analysis::ArticleComparison& comparison);
v1::ResultsReply to_proto(const ResultTable& table, const std::string& name);

}  // namespace regolab
