#include <fmt/format.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "client/blind/folder.h"
#include "client/blind/pace.h"
#include "client/commands/commands.h"
#include "client/file_read.h"
#include "client/interrupt.h"
#include "client/json_view.h"
#include "client/process.h"

namespace regolab::client {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
constexpr std::size_t kLargestAnswer = 16 << 20;  // [bytes]

/// A solver and the case it answers: its stdin is the observation file, its stdout a file that becomes the answer.
struct Solving {
  std::string id;
  fs::path output;
  Child child;
};

class Solvers {
 public:
  Solvers(const Arguments& arguments, BlindFolder& folder, std::vector<std::string> cases, Console& console)
      : arguments_(arguments),
        folder_(folder),
        cases_(std::move(cases)),
        console_(console),
        pace_(cases_.size()),
        log_(folder.path() / "solver.log") {}

  Outcome run() {
    Outcome outcome = done();
    while (outcome.ok() && (next_ < cases_.size() || !under_way_.empty())) {
      if (interrupted().stop_requested())
        outcome =
            failed(Exit::kInterrupted, fmt::format("interrupted (answers given so far are kept) go on with `regolab{}`", arguments_.original_line));
      while (outcome.ok() && next_ < cases_.size() && under_way_.size() < arguments_.jobs) outcome = start(cases_[next_++]);
      std::erase_if(under_way_, [&](Solving& one) {
        const auto end = one.child.look();
        if (end && outcome.ok()) outcome = take(one, *end);
        return end.has_value();
      });
      std::this_thread::sleep_for(50ms);
    }
    stop_all();
    return outcome;
  }

 private:
  Outcome start(const std::string& id) {
    Solving one{.id = id, .output = folder_.path() / ("answering-" + id), .child = {}};
    Child::Start how{.command = {(program_folder() / "regolab-solver").string(), "--seed", "1"},
                     .log = log_,
                     .pipe_stdout = false,
                     .input = folder_.case_file(id),
                     .output = one.output};
    for (const auto& [option, file] : {std::pair{"--bank", arguments_.bank}, std::pair{"--kernels", arguments_.kernels}}) {
      if (!file.empty()) how.command.insert(how.command.end(), {option, file});
    }
    if (auto up = one.child.start(how); !up.ok()) return up;
    under_way_.push_back(std::move(one));
    return done();
  }

  Outcome take(const Solving& one, const ChildEnd& end) {
    std::string text;
    if (end.by_signal || end.code != 0) {
      fs::remove(one.output);
      return failed(static_cast<Exit>(end.by_signal ? 1 : end.code),
                    fmt::format("case {}: the solver ended ({} {}) nothing is lost; it said:\n{}", one.id, end.by_signal ? "signal" : "exit code",
                                end.code, tail_of(log_, 5)));
    }
    if (auto got = read_whole_file(one.output, kLargestAnswer, "an answer", text); !got.ok()) return got;
    const auto answer = nlohmann::json::parse(text, nullptr, false);
    if (!answer.is_object() || !answer.contains("verdict"))
      return failed(Exit::kInternal, fmt::format("case {}: the solver gave no answer (its output is not JSON) see {}", one.id, log_.string()));
    if (auto kept = folder_.add_answer(one.id, text); !kept.ok()) return kept;
    fs::remove(one.output);
    pace_.one_done();
    std::string classes;
    for (const auto& name : answer["classes"]) classes += " " + name.get<std::string>();
    console_.err << fmt::format("case {}: {}{}; {}\n", one.id, answer["verdict"].get<std::string>(), classes, pace_.text()) << std::flush;
    return done();
  }

  void stop_all() {
    for (Solving& one : under_way_) one.child.send(SIGTERM);
    for (Solving& one : under_way_) {
      if (!one.child.wait(5s)) one.child.send(SIGKILL), one.child.wait(1s);
      std::error_code ignored;
      fs::remove(one.output, ignored);
    }
    under_way_.clear();
  }

  const Arguments& arguments_;
  BlindFolder& folder_;
  const std::vector<std::string> cases_;
  Console& console_;
  Pace pace_;
  const fs::path log_;
  std::size_t next_ = 0;
  std::vector<Solving> under_way_;
};

}  // namespace

Outcome blind_solve(const Arguments& arguments, Console& console) {
  BlindFolder folder(arguments.folder);
  if (auto locked = folder.lock(false); !locked.ok()) return locked;
  if (auto got = folder.read(); !got.ok()) return got;
  if (auto whole = folder.check_answers(); !whole.ok()) return whole;
  std::vector<std::string> cases;
  std::size_t not_measured = 0, revealed = 0;
  std::error_code ignored;
  for (const Digest& commitment : folder.commitments()) {
    if (folder.answer_of(commitment.id)) continue;
    if (fs::exists(folder.truth_file(commitment.id), ignored))
      ++revealed;
    else if (!fs::exists(folder.case_file(commitment.id), ignored))
      ++not_measured;
    else if (arguments.only == 0 || cases.size() < arguments.only)
      cases.push_back(commitment.id);
  }
  if (revealed > 0) console.err << fmt::format("{} cases are left out: their truth lies open in {}\n", revealed, (folder.path() / "truths").string());
  if (not_measured > 0) console.err << fmt::format("{} cases are not measured yet: regolab gap blind make {}\n", not_measured, arguments.folder);
  if (auto solved = Solvers(arguments, folder, cases, console).run(); !solved.ok()) return solved;
  const std::size_t answered = folder.answers().size(), all = folder.commitments().size();
  if (arguments.json) {
    Json out = document("blind-solve");
    out["folder"] = arguments.folder, out["cases"] = all, out["answered"] = answered, out["not_measured"] = not_measured,
    out["development"] = folder.set().seed.has_value();
    console.out << text_of(out) << std::flush;
    return done();
  }
  console.out << fmt::format("{} of {} cases answered, each once; the SHA-256 of every answer is in {}\n", answered, all,
                             (folder.path() / "answers").string())
              << std::flush;
  if (answered == all) console.err << fmt::format("next: regolab gap blind reveal {}\n", arguments.folder);
  return done();
}

}  // namespace regolab::client
