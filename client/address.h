/// What may stand behind --server.
#pragma once
#include <string>

#include "client/outcome.h"

namespace regolab::client {

/// Done for "host:port" and "unix:/path"; else kUsage with what is wrong.
Outcome check_address(const std::string& address);

}  // namespace regolab::client
