/// Beds and checkpoints as files named by their SHA-256: ROOT/cas/ab/cdef... Written under another name, made durable, then
/// renamed, so a file under its own name is whole; verified again when read.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "digest/sha256.h"
#include "vocab/result.h"

namespace regolab {

class ArtifactFiles {
 public:
  /// Creates ROOT and removes what unfinished uploads left.
  static Result<ArtifactFiles> open(const std::string& root);

  /// One upload. Gone without a trace unless finished.
  class Upload {
   public:
    Upload(Upload&& other) noexcept;
    Upload& operator=(Upload&&) = delete;
    ~Upload();
    Result<void> add(std::string_view bytes);  ///< kResourceExhausted: disk full
    /// kDataLoss: the bytes are not those of the digest. Durable when it returns.
    Result<void> finish();
    std::uint64_t size() const { return size_; }

   private:
    friend class ArtifactFiles;
    Upload(int descriptor, std::string temporary, std::string final_path, std::string digest);
    int descriptor_;
    std::string temporary_, final_path_, digest_;
    Sha256 sum_;
    std::uint64_t size_ = 0;
  };
  Result<Upload> begin(const std::string& digest) const;

  bool has(const std::string& digest) const;
  /// kNotFound, or kDataLoss when the bytes have changed (the file is then set aside).
  Result<std::string> read(const std::string& digest) const;
  void remove(const std::string& digest) const;
  std::vector<std::string> list() const;

 private:
  explicit ArtifactFiles(std::string root) : root_(std::move(root)) {}
  std::string path_of(const std::string& digest) const;
  std::string root_;
};

}  // namespace regolab
