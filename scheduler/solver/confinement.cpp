#include "scheduler/solver/confinement.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace regolab {
namespace {

// Of linux/landlock.h, written out: the header of an old system lacks what a new kernel can.
struct Ruleset {
  std::uint64_t files = 0, network = 0, scope = 0;
};
constexpr unsigned kAskVersion = 1;
constexpr int kNetworkSince = 4, kScopeSince = 6;
constexpr std::uint64_t kTcp = 3, kSignalsAndSockets = 3;

/// Every access to files that this version knows of.
std::uint64_t all_files(int version) {
  constexpr int kBits[] = {13, 14, 15, 15, 16};  // of versions 1, 2, ...
  return (std::uint64_t{1} << kBits[version > 5 ? 4 : version - 1]) - 1;
}

std::string landlock() {
  const int version = landlock_version();
  if (version < 1) return "no landlock (the kernel has none)";
  const Ruleset rules{
      .files = all_files(version), .network = version >= kNetworkSince ? kTcp : 0, .scope = version >= kScopeSince ? kSignalsAndSockets : 0};
  const std::size_t size = version >= kScopeSince ? 24 : version >= kNetworkSince ? 16 : 8;
  const auto set = static_cast<int>(syscall(SYS_landlock_create_ruleset, &rules, size, 0));
  const bool held = set >= 0 && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && syscall(SYS_landlock_restrict_self, set, 0) == 0;
  const int error = errno;
  if (set >= 0) close(set);
  if (!held) return std::string("no landlock (") + std::strerror(error) + ")";
  return "landlock abi " + std::to_string(version) + " (no files" + (rules.network != 0 ? ", no TCP" : "") +
         (rules.scope != 0 ? ", no signals" : "") + ")";
}

std::string no_descriptors() {
  const bool closed = syscall(SYS_close_range, 3, ~0U, 0) == 0;
  const rlimit three{3, 3};
  if (setrlimit(RLIMIT_NOFILE, &three) != 0) return std::string("descriptors not limited (") + std::strerror(errno) + ")";
  return closed ? "no new descriptors" : "no new descriptors (inherited ones are open)";
}

}  // namespace

int landlock_version() {
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, kAskVersion);
  return version > 0 ? static_cast<int>(version) : 0;
}

std::string confine(const Walls& walls) {
  std::string held;
  if (walls.landlock) held = landlock();
  if (walls.descriptors) held += (held.empty() ? "" : "; ") + no_descriptors();
  return held.empty() ? "none (not asked for)" : held;
}

}  // namespace regolab
