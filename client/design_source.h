/// A design on disk, made ready for submission.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "client/arguments.h"
#include "client/outcome.h"
#include "client/wire.h"
#include "input/diagnostic.h"

namespace regolab::client {

/// The design with the tables it names (`array: {table: points.csv}`, relative to the design) and the command line's
/// overrides. What only this side can see (an unreadable file, bytes that cannot travel as text) becomes diagnostics, and
/// kInvalidInput; everything else is the scheduler's to judge.
Outcome read_design_source(const Arguments& arguments, pb::SubmitRequest& request, std::vector<Diagnostic>& diagnostics);

/// Unique per intended submission; a repeated call carries the same one.
std::string new_request_id();

/// `file:line:column: problem (why) remedy` with source line and caret, the place in bold and the caret in red.
std::string diagnostics_text(const std::vector<Diagnostic>& diagnostics, bool colour);

std::vector<Diagnostic> from_proto(const google::protobuf::RepeatedPtrField<pb::Diagnostic>& diagnostics);

}  // namespace regolab::client
