#include "client/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

extern char** environ;  // NOLINT: POSIX

namespace regolab::client {
namespace {

using Clock = std::chrono::steady_clock;

/// posix_spawn's two argument objects, freed together.
struct SpawnSetup {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;

  SpawnSetup() {
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigset_t defaults;
    sigemptyset(&none);
    sigemptyset(&defaults);
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) sigaddset(&defaults, number);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;
};

int milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return left > 0 ? static_cast<int>(left) : 0;
}

}  // namespace

Child::Child(Child&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), pipe_(std::exchange(other.pipe_, -1)), end_(other.end_) {}

Child& Child::operator=(Child&& other) noexcept {
  if (pipe_ >= 0) close(pipe_);
  pid_ = std::exchange(other.pid_, -1);
  pipe_ = std::exchange(other.pipe_, -1);
  end_ = other.end_;
  return *this;
}

Child::~Child() {
  if (pipe_ >= 0) close(pipe_);
}

Outcome Child::start(const Start& start) {
  int ends[2] = {-1, -1};
  if (start.pipe_stdout && pipe2(ends, O_CLOEXEC) != 0) {
    return failed(Exit::kInternal, fmt::format("cannot make a pipe ({}) close some files", std::strerror(errno)));
  }
  SpawnSetup setup;
  posix_spawn_file_actions_addopen(&setup.files, STDIN_FILENO, start.input.c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&setup.files, STDERR_FILENO, start.log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  if (start.output.empty()) posix_spawn_file_actions_adddup2(&setup.files, start.pipe_stdout ? ends[1] : STDERR_FILENO, STDOUT_FILENO);
  else posix_spawn_file_actions_addopen(&setup.files, STDOUT_FILENO, start.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);

  std::vector<char*> arguments;
  for (const std::string& word : start.command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int error = posix_spawn(&pid_, arguments[0], &setup.files, &setup.attributes, arguments.data(), environ);
  if (ends[1] >= 0) close(ends[1]);
  pipe_ = ends[0];
  end_.reset();
  if (error != 0) {
    pid_ = -1;
    return failed(Exit::kInternal, fmt::format("cannot start {} ({}) build it first: cmake --build build", start.command[0],
                                               std::strerror(error)));
  }
  return done();
}

std::optional<ChildEnd> Child::look() {
  if (pid_ <= 0 || end_) return end_;
  int status = 0;
  if (waitpid(pid_, &status, WNOHANG) == pid_) {
    end_ = WIFSIGNALED(status) ? ChildEnd{true, WTERMSIG(status)} : ChildEnd{false, WEXITSTATUS(status)};
  }
  return end_;
}

void Child::send(int signal) const {
  if (running()) kill(pid_, signal);
}

bool Child::wait(std::chrono::milliseconds limit) {
  const auto deadline = Clock::now() + limit;
  while (pid_ > 0 && !look()) {
    if (Clock::now() >= deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

std::optional<std::string> Child::read_line(std::chrono::milliseconds limit) {
  const auto deadline = Clock::now() + limit;
  std::string line;
  while (true) {
    pollfd wait{.fd = pipe_, .events = POLLIN, .revents = 0};
    const int ready = poll(&wait, 1, milliseconds_until(deadline));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return std::nullopt;
    char c = 0;
    if (read(pipe_, &c, 1) != 1) return std::nullopt;
    if (c == '\n') return line;
    line += c;
  }
}

std::filesystem::path program_folder() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::path(".") : self.parent_path();
}

std::string tail_of(const std::filesystem::path& log, int lines) {
  std::ifstream file(log);
  std::vector<std::string> kept;
  for (std::string line; std::getline(file, line);) {
    kept.push_back(line);
    if (kept.size() > static_cast<std::size_t>(lines)) kept.erase(kept.begin());
  }
  std::string text;
  for (const std::string& line : kept) text += (text.empty() ? "" : "\n") + line;
  return text;
}

}  // namespace regolab::client
