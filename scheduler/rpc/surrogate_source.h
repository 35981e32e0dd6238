/// An experiment as surrogates read it: its table, its profile, its stress-strain curves.
#pragma once
#include "scheduler/surrogate/dataset.h"
#include "store/reader.h"

namespace regolab {

Result<surrogate::Source> surrogate_source(Reader& reader, const std::string& label);

}  // namespace regolab
