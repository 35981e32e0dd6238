/// One scheduler per database: an advisory lock that ends with the process, however it ends.
#pragma once
#include <string>
#include <utility>

#include "vocab/result.h"

namespace regolab {

class LockFile {
 public:
  /// kFailedPrecondition: another process holds it (its pid is in the text).
  static Result<LockFile> take(const std::string& path);
  LockFile(LockFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  LockFile& operator=(LockFile&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~LockFile();

 private:
  explicit LockFile(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace regolab
