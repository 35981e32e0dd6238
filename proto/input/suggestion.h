/// "did you mean ...": the known name closest to what was typed.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace regolab {

/// The closest of `known` within 2 edits (1 for names of up to 3 letters; case is free), or empty.
std::string_view closest(std::string_view typed, std::span<const std::string_view> known);

/// "a, b, c".
std::string join_names(std::span<const std::string_view> names);

/// The remedy for an unknown name: "did you mean 'K_N'?", or "known: a, b, c".
std::string suggestion(std::string_view typed, std::span<const std::string_view> known);

}  // namespace regolab
