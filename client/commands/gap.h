/// What the verbs of `gap` share.
#pragma once
#include "client/arguments.h"
#include "client/console.h"
#include "client/json_view.h"
#include "client/outcome.h"
#include "client/session.h"
#include "client/wire.h"

namespace regolab::client {

/// The measurements that the arguments name, as the scheduler takes them. Errors: a file that cannot be read or is too large.
Outcome read_measurements(const Arguments& arguments, pb::ImportRequest& request);

/// Measurements and bank of `gap locate`, `diagnose` and `confirm`, and a session whose database keeps what is found: one is made only for
/// measurements that can be read. Diagnostics are printed.
Outcome open_question(const Arguments& arguments, Console& console, pb::DiagnoseRequest& request, Session& session);

/// The arguments that ask the same question of another verb: "o.csv --map m.yaml --bank b.csv".
std::string question_words(const Arguments& arguments);

/// Steps as they come, with the time left; then the diagnosis.
Outcome run_diagnosis(const Arguments& arguments, const pb::DiagnoseRequest& request, Session& session, Console& console, pb::Diagnosis& diagnosis);

/// How far the gap shrinks: a diagnosis without what is held out, then new runs of both models within --budget. Nothing is run where the
/// verdict names nothing to add: the diagnosis then has no shrinkage.
Outcome confirm_by_runs(const Arguments& arguments, pb::DiagnoseRequest request, Session& session, Console& console, pb::Diagnosis& diagnosis);

/// What `--json` says of a diagnosis.
void add_diagnosis(const pb::Diagnosis& diagnosis, Json& out);

/// The report of a stored diagnosis.
Outcome write_report(const std::string& id, const std::string& file, Session& session);

inline constexpr std::size_t kLargestBank = 16 << 20;  ///< [bytes]

/// The files of another bank than the program's own, as a diagnosis takes them.
Outcome read_bank_files(const Arguments& arguments, pb::DiagnoseRequest& request);

}  // namespace regolab::client
