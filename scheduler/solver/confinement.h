/// Giving up rights, for good: for a process that must not be able to cheat.
#pragma once
#include <string>

namespace regolab {

struct Walls {
  bool landlock = true;     ///< no file by its path; no TCP, signals or abstract sockets where the kernel can
  bool descriptors = true;  ///< what is open but stdin, stdout and stderr is closed, and nothing can be opened
};

/// What holds from now on, in words: "landlock abi 7 (no files, no TCP, no signals); no new descriptors", or "none (why)".
/// Threads started before keep their rights: call it first.
std::string confine(const Walls& walls);

/// Version of Landlock's interface that this kernel has; 0: none.
int landlock_version();

}  // namespace regolab
