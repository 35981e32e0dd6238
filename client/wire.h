/// The generated messages under the short name the client uses. Services are seen by lab.cpp alone: their headers are slow.
#pragma once
#include "regolab/v1/lab.pb.h"

namespace regolab::client {
namespace pb = ::regolab::v1;
}
