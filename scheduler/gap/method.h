/// Which method this program diagnoses by: a stored diagnosis of another one is never taken for this one's.
#pragma once
#include <string_view>

namespace regolab::gap {

/// SHA-256 over the sources of this folder and the table of effects, taken when they are compiled.
std::string_view method_digest();

}  // namespace regolab::gap
