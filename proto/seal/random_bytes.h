/// Randomness that nobody can foretell, and bytes as text.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "vocab/result.h"

namespace regolab {

/// Of the operating system's entropy.
Result<std::string> random_bytes(std::size_t n);

/// Lower-case hexadecimal digits.
std::string hex_text(std::string_view bytes);
/// kInvalidArgument: not an even number of hexadecimal digits.
Result<std::string> bytes_of_hex(std::string_view text);

}  // namespace regolab
