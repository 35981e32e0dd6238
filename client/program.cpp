#include "client/program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/fd_output.h"
#include "client/interrupt.h"
#include "client/json_view.h"

namespace regolab::client {
namespace {

using Verb = Outcome (*)(const Arguments&, Console&);

const std::map<std::string, Verb>& verbs() {
  static const std::map<std::string, Verb> all{
      {"run", run_study},
      {"submit", submit},
      {"watch", watch},
      {"design show", show_design},
      {"validate", show_design},
      {"status", status},
      {"cancel", cancel},
      {"retry", retry},
      {"results", results},
      {"range", range},
      {"export", export_stages},
      {"train", train},
      {"models", models},
      {"predict", predict},
      {"invert", invert},
      {"gap import", gap_import},
      {"gap bank", gap_bank},
      {"gap emulate", gap_emulate},
      {"gap diagnose", gap_diagnose},
      {"gap locate", gap_locate},
      {"gap confirm", gap_confirm},
      {"gap ls", gap_ls},
      {"gap show", gap_show},
      {"gap report", gap_report},
      {"gap blind make", blind_make},
      {"gap blind solve", blind_solve},
      {"gap blind reveal", blind_reveal},
      {"gap next", gap_next},
      {"article check", check_article},
      {"article compare", compare_article},
      {"article functions", article_functions},
      {"effects ls", list_effects},
      {"version", version},
      {"completion", completion},
  };
  return all;
}

void report(const Outcome& outcome, const Arguments& arguments, Console& console) {
  if (outcome.ok()) return;
  const std::string text = outcome.text.empty() && outcome.exit == Exit::kInterrupted ? "interrupted" : outcome.text;
  if (text.empty()) return;
  console.err << paint(console.colour_err, outcome.exit == Exit::kTrialsFailed ? Ink::kYellow : Ink::kRed, "regolab: ")
              << text << std::endl;
  if ((!arguments.json && !arguments.json_lines) || outcome.exit == Exit::kTrialsFailed)
    return;  // its document is out already
  Json error = document("error");
  error["exit_code"] = static_cast<int>(outcome.exit);
  error["message"] = text;
  console.out << (arguments.json_lines ? line_of(error) : text_of(error));
}

/// A full disk behind stdout must not look like success; a reader that went away (`| head`) is none of our business.
int flushed(std::ostream& out, const FdOutput& to, int code) {
  out.flush();
  if (to.error() == 0 || to.error() == EPIPE) return code;
  std::cerr << fmt::format("regolab: cannot write the output ({}) make room or write elsewhere\n",
                           std::strerror(to.error()));
  return static_cast<int>(Exit::kInternal);
}

}  // namespace

int run_verb(const Arguments& arguments, Console& console) {
  const Outcome outcome = verbs().at(arguments.verb)(arguments, console);
  report(outcome, arguments, console);
  return static_cast<int>(outcome.exit);
}

int run_program(const std::vector<std::string>& words) {
  watch_signals();
  FdOutput to(STDOUT_FILENO);
  std::ostream out(&to);
  const Parsed parsed = parse(words);
  if (parsed.leave) {
    (parsed.outcome.ok() ? out : std::cerr) << parsed.text;
    if (!parsed.outcome.text.empty()) std::cerr << "regolab: " << parsed.outcome.text << "\n";
    return flushed(out, to, static_cast<int>(parsed.outcome.exit));
  }
  Console console = terminal_console(parsed.arguments.colour, out);
  const int code = run_verb(parsed.arguments, console);
  return flushed(out, to, code);
}

}  // namespace regolab::client
