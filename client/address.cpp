#include "client/address.h"

#include <fmt/format.h>

#include "client/number_text.h"

namespace regolab::client {

Outcome check_address(const std::string& address) {
  const auto bad = [&](const char* why) {
    return failed(
        Exit::kUsage,
        fmt::format("--server {} ({}) write HOST:PORT, as in localhost:7070, or unix:/path/to/socket", address, why));
  };
  if (address.starts_with("unix:")) return address.size() > 5 ? done() : bad("no path");
  if (address.find("://") != std::string::npos) return bad("an address, not a URL, is wanted");
  const auto colon = address.rfind(':');
  if (colon == std::string::npos) return bad("no port");
  const auto port = as_number(address.substr(colon + 1));
  const bool digits = address.find_first_not_of("0123456789", colon + 1) == std::string::npos;
  if (!port || !digits || *port < 1 || *port > 65535) return bad("the port must be a number from 1 to 65535");
  return colon == 0 ? bad("no host") : done();
}

}  // namespace regolab::client
