#include "client/embedded.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace regolab::client {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kReadyWithin = 60s;         // opening a large database recovers its log first
constexpr auto kWorkersLeaveWithin = 20s;  // a worker saves its stage before it leaves
constexpr auto kSchedulerLeavesWithin = 10s;
constexpr auto kWatchEvery = 100ms;
constexpr auto kHealthyAfter = 10s;  // a process that lived this long starts with a clean record
constexpr int kFailuresToGiveUp = 8;

fs::path folder_of(const fs::path& database) { return database.string() + ".d"; }
fs::path announcement_of(const fs::path& database) { return folder_of(database) / "address"; }

/// A folder only we may enter, with a path short enough for a socket's address (108 bytes).
Outcome make_scratch(fs::path& scratch) {
  const char* wanted = std::getenv("TMPDIR");
  std::string pattern = (wanted != nullptr && *wanted != '\0' && std::strlen(wanted) < 70) ? wanted : "/tmp";
  pattern += "/regolab-XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) {
    return failed(Exit::kInternal,
                  fmt::format("cannot make a folder {} ({}) point TMPDIR to a writable one", pattern, std::strerror(errno)));
  }
  scratch = pattern;
  return done();
}

bool answers(const std::string& address) {
  if (!address.starts_with("unix:")) return false;
  sockaddr_un to{};
  to.sun_family = AF_UNIX;
  const std::string path = address.substr(5);
  if (path.empty() || path.size() >= sizeof to.sun_path) return false;
  std::memcpy(to.sun_path, path.c_str(), path.size() + 1);
  const int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (fd < 0) return false;
  const bool yes = connect(fd, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0;
  close(fd);
  return yes;
}

std::string how_it_ended(const ChildEnd& end) {
  return end.by_signal ? fmt::format("killed by signal {}", end.code) : fmt::format("exit code {}", end.code);
}

/// The scheduler's own words: what follows its name, without the log lines before.
std::string last_words(const fs::path& log) {
  const std::string name = "regolab-scheduler: ";
  const std::string said = tail_of(log, 20);
  const auto at = said.rfind(name);
  return at == std::string::npos ? said : said.substr(at + name.size());
}

}  // namespace

std::string running_scheduler_of(const fs::path& database) {
  std::ifstream file(announcement_of(database));
  std::string address;
  std::getline(file, address);
  return answers(address) ? address : std::string();
}

Outcome Embedded::start(const Options& options, std::unique_ptr<Embedded>& started) {
  std::unique_ptr<Embedded> embedded(new Embedded());
  if (auto made = make_scratch(embedded->scratch_); !made.ok()) return made;
  if (auto up = embedded->start_scheduler(options); !up.ok()) return up;
  embedded->supervisor_ = std::jthread([self = embedded.get()](const std::stop_token& stop) { self->supervise(stop); });
  started = std::move(embedded);
  return done();
}

Outcome Embedded::start_scheduler(const Options& options) {
  programs_ = options.programs;
  logs_ = scratch_;
  address_ = "unix:" + (scratch_ / "socket").string();
  const fs::path database = options.database.empty() ? scratch_ / "scratch.db" : options.database;
  Kept scheduler{.name = "regolab-scheduler", .start = {}, .child = {}};
  scheduler.start = {.command = {(programs_ / "regolab-scheduler").string(), "--db", database.string(), "--listen", address_,
                                 "--exit-with-parent"},
                     .log = logs_ / "scheduler.log",
                     .pipe_stdout = true};
  if (auto up = scheduler.child.start(scheduler.start); !up.ok()) return up;
  const auto deadline = Clock::now() + kReadyWithin;
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    const auto line = scheduler.child.read_line(std::max(left, 0ms));
    if (line && line->starts_with("listening on")) break;
    if (line) continue;
    const bool ended = scheduler.child.wait(1s);
    const std::string said = last_words(scheduler.start.log);
    if (!ended) {
      scheduler.child.send(SIGKILL);
      scheduler.child.wait(1s);
      return failed(Exit::kTimeout,
                    fmt::format("regolab-scheduler was not ready within {} s ({}) try again", kReadyWithin.count(), said));
    }
    const ChildEnd end = *scheduler.child.look();
    const Exit code = end.by_signal || end.code == 0 ? Exit::kInternal : static_cast<Exit>(end.code);
    return failed(code, said.empty() ? fmt::format("regolab-scheduler did not start ({}) run it by hand to see why: {}",
                                                   how_it_ended(end), fmt::join(scheduler.start.command, " "))
                                     : said);
  }
  scheduler.started = Clock::now();
  scheduler.start.pipe_stdout = false;  // a restarted one is found through its socket
  kept_.push_back(std::move(scheduler));
  if (!options.database.empty()) {
    announced_ = announcement_of(fs::absolute(options.database));
    std::error_code ignored;
    fs::create_directories(announced_.parent_path(), ignored);
    std::ofstream(announced_) << address_ << '\n';  // a convenience: not being able to write it hurts nobody
  }
  return done();
}

void Embedded::have_workers(unsigned count) {
  const std::lock_guard lock(mutex_);
  while (kept_.size() < count + 1U) {  // the first is the scheduler
    Kept worker{.name = fmt::format("regolab-worker {}", kept_.size()), .start = {}, .child = {}};
    worker.start = {
        .command = {(programs_ / "regolab-worker").string(), "serve", "--server", address_, "--exit-with-parent"},
        .log = logs_ / fmt::format("worker-{}.log", kept_.size())};
    kept_.push_back(std::move(worker));  // the supervisor starts what does not run
  }
}

Outcome Embedded::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

void Embedded::supervise(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    {
      const std::lock_guard lock(mutex_);
      for (Kept& kept : kept_) look_after(kept);
    }
    std::this_thread::sleep_for(kWatchEvery);
  }
}

void Embedded::look_after(Kept& kept) {
  if (kept.child.running()) {
    if (const auto end = kept.child.look()) note_end(kept, *end);
    return;
  }
  if (!failure_.ok() || Clock::now() < kept.start_again) return;
  kept.started = Clock::now();
  if (auto up = kept.child.start(kept.start); !up.ok()) give_up(up);
}

void Embedded::note_end(Kept& kept, const ChildEnd& end) {
  const bool scheduler = &kept == &kept_.front();
  if (Clock::now() - kept.started > kHealthyAfter) kept.failures_in_a_row = 0;
  ++kept.failures_in_a_row;
  const bool said_no = !end.by_signal && end.code != 0;
  const std::string text = fmt::format("{} ended ({}):\n{}", kept.name, how_it_ended(end), tail_of(kept.start.log, 20));
  // A scheduler that ends by itself has a reason that starting it again would only repeat.
  if (scheduler && said_no) return give_up(failed(static_cast<Exit>(end.code), text));
  if (kept.failures_in_a_row >= kFailuresToGiveUp && (scheduler || said_no)) return give_up(failed(Exit::kInternal, text));
  const auto pause = std::min<std::chrono::milliseconds>(100ms * (1 << std::min(kept.failures_in_a_row, 6)), 5s);
  kept.start_again = Clock::now() + pause;
}

void Embedded::give_up(Outcome why) {
  if (!failure_.ok()) return;
  failure_ = std::move(why);
  broken_.request_stop();
}

Embedded::~Embedded() {
  // The supervisor started the workers and they die with the thread that started them, so it ends after they have left.
  {
    const std::lock_guard lock(mutex_);
    if (failure_.ok()) failure_ = failed(Exit::kInterrupted, "");  // from now on nothing is started again
    for (std::size_t i = 1; i < kept_.size(); ++i) kept_[i].child.send(SIGTERM);
    const auto deadline = Clock::now() + kWorkersLeaveWithin;
    for (std::size_t i = 1; i < kept_.size(); ++i) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
      if (kept_[i].child.wait(std::max(left, 0ms))) continue;
      kept_[i].child.send(SIGKILL);
      kept_[i].child.wait(1s);
    }
    if (!kept_.empty()) {
      kept_.front().child.send(SIGTERM);
      if (!kept_.front().child.wait(kSchedulerLeavesWithin)) {
        kept_.front().child.send(SIGKILL);
        kept_.front().child.wait(1s);
      }
    }
  }
  if (supervisor_.joinable()) {
    supervisor_.request_stop();
    supervisor_.join();
  }
  std::error_code ignored;
  if (!announced_.empty()) fs::remove(announced_, ignored);
  if (!scratch_.empty()) fs::remove_all(scratch_, ignored);
}

}  // namespace regolab::client
