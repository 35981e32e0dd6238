/// How a step of a verb went, and the exit code it means to the shell.
#pragma once
#include <string>
#include <utility>

namespace regolab::client {

enum class Exit {
  kDone = 0,
  kInternal = 1,
  kUsage = 2,         ///< the command line
  kInvalidInput = 3,  ///< a file
  kUnreachable = 4,   ///< no scheduler at the address
  kTrialsFailed = 5,  ///< the study ended, but not every trial has its numbers
  kTimeout = 6,
  kInterrupted = 130,
};

/// Text reads *problem (why) remedy*. It may be empty when what is to be said has been said already.
struct [[nodiscard]] Outcome {
  Exit exit = Exit::kDone;
  std::string text;

  bool ok() const { return exit == Exit::kDone; }
};

inline Outcome done() { return {}; }
inline Outcome failed(Exit exit, std::string text) { return {exit, std::move(text)}; }

}  // namespace regolab::client
