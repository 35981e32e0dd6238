/// Gap diagnosis in words and tables.
#pragma once
#include <string>

#include "client/wire.h"

namespace regolab::client {

/// The table of features, what takes no part and why, warnings apart.
std::string import_text(const pb::ImportReply& reply);

}  // namespace regolab::client
