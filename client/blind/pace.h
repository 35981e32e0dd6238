/// How fast cases are done, and what that says of the rest.
#pragma once
#include <chrono>
#include <string>

namespace regolab::client {

class Pace {
 public:
  explicit Pace(std::size_t to_do) : to_do_(to_do), start_(std::chrono::steady_clock::now()) {}

  void one_done() { ++done_; }
  /// "3 of 156 done, 31 cases/h, 4.6 h left".
  std::string text() const { return text_after(std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count()); }
  std::string text_after(double seconds) const;

 private:
  std::size_t to_do_, done_ = 0;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace regolab::client
