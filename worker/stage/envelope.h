/// Beds and checkpoints as bytes that cannot be mistaken: what they are, of which stage and physics, and whether they are whole.
#pragma once
#include <string>
#include <string_view>

#include "vocab/result.h"

namespace regolab {

enum class Content { kBed = 1, kCheckpoint = 2 };

/// magic, content, stage text, payload, SHA-256 of all before.
std::string seal(Content content, std::string_view stage_text, std::string_view payload);

/// The payload, or kDataLoss: damaged, of another kind, or of another stage or physics version.
/// An empty `stage_text` accepts any stage of this physics version.
Result<std::string_view> unseal(Content content, std::string_view stage_text, std::string_view bytes);

}  // namespace regolab
