/// Contacts, contact angles, density and void ratio of a settled bed [article Sec. 3.1.2, 3.1.3, Eq. 3; protocols, section 5].
#pragma once
#include "worker/protocol/test.h"

namespace regolab::protocol {

/// No steps: the bed as it lies. REQUIRES: forces computed once (contacts gathered).
StageResult measure_fabric(Bed& bed);

}  // namespace regolab::protocol
