/// Text under a key, so that it can lie about without being read.
#pragma once
#include <string>
#include <string_view>

#include "vocab/result.h"

namespace regolab {

inline constexpr std::size_t kKeyBytes = 32;

/// AES-256-GCM with a fresh random nonce, as bytes: nonce, ciphertext, tag. `name` is bound in: only the same name opens it.
/// REQUIRES: key of kKeyBytes.
Result<std::string> sealed(std::string_view key, std::string_view text, std::string_view name);

/// kDataLoss: another key, another name, or changed bytes; which of them cannot be told.
Result<std::string> opened(std::string_view key, std::string_view bytes, std::string_view name);

}  // namespace regolab
