#include "seal/random_bytes.h"

#include <sys/random.h>

#include <cerrno>
#include <cstring>

namespace regolab {
namespace {

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

}  // namespace

Result<std::string> random_bytes(std::size_t n) {
  std::string out(n, '\0');
  for (std::size_t have = 0; have < n;) {
    const ssize_t got = getrandom(out.data() + have, n - have, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return Error{Code::kUnavailable, std::string("no random bytes (") + std::strerror(errno) + ") run on a system that has getrandom"};
    have += static_cast<std::size_t>(got);
  }
  return out;
}

std::string hex_text(std::string_view bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    out += kDigits[byte >> 4];
    out += kDigits[byte & 15];
  }
  return out;
}

Result<std::string> bytes_of_hex(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    const int high = digit_of(text[i]), low = i + 1 < text.size() ? digit_of(text[i + 1]) : -1;
    if (high < 0 || low < 0) return invalid("not hexadecimal (two digits 0-9a-f for each byte) take the file as it was written");
    out += static_cast<char>(high * 16 + low);
  }
  return out;
}

}  // namespace regolab
