#include "scheduler/rpc/address.h"

#include <netdb.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>

namespace regolab {
namespace {

struct Socket {
  int descriptor;
  ~Socket() { close(descriptor); }
};

const char* const kForms = ", give --listen host:port (127.0.0.1:50551) or unix:/path/to/socket";

Error in_use(const std::string& listen) {
  return {Code::kAlreadyExists,
          "cannot listen on " + listen +
              " (the address is in use), stop the program that listens there or choose another address"};
}

Result<void> check_unix(const std::string& listen, const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) {
    return invalid("cannot listen on " + listen + " (the path must have 1 to " +
                   std::to_string(sizeof address.sun_path - 1) + " characters)" + kForms);
  }
  std::error_code error;
  const auto folder = std::filesystem::absolute(path, error).parent_path();
  if (!std::filesystem::is_directory(folder, error)) {
    return Error{Code::kFailedPrecondition,
                 "cannot listen on " + listen + " (no folder " + folder.string() + "), create it first"};
  }
  if (std::filesystem::exists(path, error) && !std::filesystem::is_socket(path, error)) {
    return Error{Code::kFailedPrecondition,
                 "cannot listen on " + listen + " (a file of that name exists), choose another name"};
  }
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  const Socket probe{socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  if (connect(probe.descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return in_use(listen);
  return {};  // a socket file nobody answers on is left from a process that died
}

Result<void> check_tcp(const std::string& listen, const std::string& host, const std::string& port) {
  int number = -1;
  const auto [end, failed] = std::from_chars(port.data(), port.data() + port.size(), number);
  if (failed != std::errc{} || end != port.data() + port.size() || number < 0 || number > 65535) {
    return invalid("cannot listen on " + listen + " ('" + port + "' is not a port, 0 to 65535)" + kForms);
  }
  addrinfo hints{}, *found = nullptr;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  if (const int code = getaddrinfo(host.c_str(), port.c_str(), &hints, &found); code != 0) {
    return invalid("cannot listen on " + listen + " (" + gai_strerror(code) + ")" + kForms);
  }
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> addresses{found, freeaddrinfo};
  const Socket probe{socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  const int reuse = 1;
  setsockopt(probe.descriptor, SOL_SOCKET, SO_REUSEADDR, &reuse, sizeof reuse);
  if (bind(probe.descriptor, found->ai_addr, found->ai_addrlen) == 0) return {};
  if (errno == EADDRINUSE) return in_use(listen);
  return Error{Code::kFailedPrecondition, "cannot listen on " + listen + " (" + std::strerror(errno) +
                                              "), choose an address of this machine and a port above 1023"};
}

}  // namespace

Result<void> check_address(const std::string& listen) {
  if (listen.starts_with("unix:")) return check_unix(listen, listen.substr(5));
  const auto colon = listen.rfind(':');
  if (colon == std::string::npos || colon == 0)
    return invalid("cannot listen on '" + listen + "' (no host and port)" + kForms);
  std::string host = listen.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  return check_tcp(listen, host, listen.substr(colon + 1));
}

}  // namespace regolab
