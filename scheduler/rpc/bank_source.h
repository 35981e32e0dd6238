/// An experiment as the bank reads it: for each point and seed the inputs and everything measured.
#pragma once
#include "scheduler/gap/bank.h"
#include "store/reader.h"

namespace regolab {

/// Inputs come from the stages themselves, bit for bit; factors that are no part of a material (the strength of an effect, a number
/// of the numerics) from the design's levels. Runs without effects come again as an erring apparatus would show them (bank_variants.h). Errors: kNotFound, kInvalidArgument (a level that cannot be read).
Result<std::vector<gap::BankSource>> bank_sources(Reader& reader, const std::string& label);

}  // namespace regolab
