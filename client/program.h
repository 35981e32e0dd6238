/// The client as a function: words in, exit code out.
#pragma once
#include <string>
#include <vector>

#include "client/arguments.h"
#include "client/console.h"
#include "client/outcome.h"

namespace regolab::client {

/// The verb's work and its messages. With --json, an error is a document too: {"format": "regolab.error/1", ...}.
int run_verb(const Arguments& arguments, Console& console);

/// Parses, runs, and checks that everything reached stdout.
int run_program(const std::vector<std::string>& words);

}  // namespace regolab::client
