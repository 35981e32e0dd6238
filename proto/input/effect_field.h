/// The effects as fields: what files may say of them.
#pragma once
#include <span>

#include "input/field.h"

namespace regolab {

std::span<const Field> effect_fields();

}  // namespace regolab
