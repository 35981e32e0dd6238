/// Where to listen, checked before gRPC sees it: its own messages name neither cause nor remedy.
#pragma once
#include <string>

#include "vocab/result.h"

namespace regolab {

/// kInvalidArgument: not an address. kAlreadyExists: somebody listens there. kFailedPrecondition: not allowed, no such
/// folder.
Result<void> check_address(const std::string& listen);

}  // namespace regolab
