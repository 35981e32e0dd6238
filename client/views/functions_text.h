/// The article's prediction functions as text.
#pragma once
#include <string>

#include "client/wire.h"

namespace regolab::client {

/// R of every group beside Table 12, then what left-out tests say of every output, the split, and the notes.
std::string functions_text(const pb::TrainFunctionsReply& trained);

}  // namespace regolab::client
