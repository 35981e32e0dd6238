/// An experiment as of now, as shown to people.
#pragma once
#include "regolab/v1/lab.pb.h"
#include "scheduler/rpc/desk.h"

namespace regolab {

v1::ExperimentStatus status_of(ExperimentId id, const Desk::Turn& turn);

}  // namespace regolab
