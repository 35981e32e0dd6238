/// The verbs. Data goes to console.out, messages to console.err; the outcome's text is printed by the caller.
#pragma once
#include <vector>

#include "client/arguments.h"
#include "client/console.h"
#include "client/outcome.h"
#include "input/diagnostic.h"

namespace regolab::client {

Outcome run_study(const Arguments& arguments, Console& console);
Outcome submit(const Arguments& arguments, Console& console);
Outcome watch(const Arguments& arguments, Console& console);
Outcome show_design(const Arguments& arguments, Console& console);
Outcome status(const Arguments& arguments, Console& console);
Outcome cancel(const Arguments& arguments, Console& console);
Outcome retry(const Arguments& arguments, Console& console);
Outcome results(const Arguments& arguments, Console& console);
Outcome range(const Arguments& arguments, Console& console);
Outcome export_stages(const Arguments& arguments, Console& console);
Outcome train(const Arguments& arguments, Console& console);
Outcome models(const Arguments& arguments, Console& console);
Outcome predict(const Arguments& arguments, Console& console);
Outcome invert(const Arguments& arguments, Console& console);
Outcome gap_import(const Arguments& arguments, Console& console);
Outcome gap_bank(const Arguments& arguments, Console& console);
Outcome gap_emulate(const Arguments& arguments, Console& console);
Outcome gap_diagnose(const Arguments& arguments, Console& console);
Outcome gap_locate(const Arguments& arguments, Console& console);
Outcome gap_confirm(const Arguments& arguments, Console& console);
Outcome gap_ls(const Arguments& arguments, Console& console);
Outcome gap_show(const Arguments& arguments, Console& console);
Outcome gap_report(const Arguments& arguments, Console& console);
Outcome blind_make(const Arguments& arguments, Console& console);
Outcome blind_solve(const Arguments& arguments, Console& console);
Outcome blind_reveal(const Arguments& arguments, Console& console);
Outcome gap_next(const Arguments& arguments, Console& console);
Outcome check_article(const Arguments& arguments, Console& console);
Outcome compare_article(const Arguments& arguments, Console& console);
Outcome article_functions(const Arguments& arguments, Console& console);
Outcome list_effects(const Arguments& arguments, Console& console);
Outcome version(const Arguments& arguments, Console& console);
Outcome completion(const Arguments& arguments, Console& console);

/// Prints what is wrong with a design; kInvalidInput with nothing left to say.
Outcome rejected(const std::vector<Diagnostic>& diagnostics, const Arguments& arguments, Console& console);

/// "next: regolab ..." under human output.
void hint(const Arguments& arguments, Console& console, const std::string& words);

}  // namespace regolab::client
