#include "client/fd_output.h"

#include "client/file_write.h"

namespace regolab::client {

constexpr std::size_t kHold = 64 << 10;  // [bytes] gathered before they are written

FdOutput::int_type FdOutput::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  const char one = traits_type::to_char_type(c);
  return xsputn(&one, 1) == 1 ? c : traits_type::eof();
}

std::streamsize FdOutput::xsputn(const char* text, std::streamsize n) {
  held_.append(text, static_cast<std::size_t>(n));
  if (held_.size() >= kHold && sync() != 0) return 0;
  return n;
}

int FdOutput::sync() {
  const int error = write_all(fd_, held_);
  held_.clear();
  if (error_ == 0) error_ = error;
  return error == 0 ? 0 : -1;
}

}  // namespace regolab::client
