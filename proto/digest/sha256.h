/// SHA-256 as 64 lower-case hex digits: the name of everything that is addressed by content.
#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "vocab/stage.h"

namespace regolab {

class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void add(std::string_view bytes);
  std::string hex();  ///< ends the digest; REQUIRES: called once, last

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string sha256_hex(std::string_view bytes);

/// Equal stages have equal keys: SHA-256 of canonical_text(spec).
std::string stage_key(const StageSpec& spec);

/// 64 lower-case hex digits: what may stand where a digest is expected (a digest also names a file).
bool is_digest(std::string_view text);

}  // namespace regolab
