/// An output stream on a file descriptor that remembers why writing failed (std::cout does not).
#pragma once
#include <streambuf>
#include <string>

namespace regolab::client {

class FdOutput : public std::streambuf {
 public:
  explicit FdOutput(int fd) : fd_(fd) {}
  ~FdOutput() override { sync(); }
  /// errno of the first write that failed; 0 when all went well.
  int error() const { return error_; }

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize n) override;
  int sync() override;

 private:
  int fd_;
  int error_ = 0;
  std::string held_;
};

}  // namespace regolab::client
