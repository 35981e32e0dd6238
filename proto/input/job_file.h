/// JOB.yaml of `regolab-worker run`: one material, one seed, its tests.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "input/diagnostic.h"
#include "vocab/stage.h"

namespace regolab {

struct Job {
  std::string profile = "quick";
  std::uint64_t seed = 1;
  Micro micro;
  EffectSet effects;    ///< all 0 = the base model
  Numerics numerics;  ///< the profile's, with what the file overrides
  bool repose = false;
  std::vector<double> confining_stresses;  ///< sigma3 of the stress tests [Pa]; empty = none
  std::vector<PlateSize> plates;           ///< of the penetration test, thin ones first; empty = none
};                                         // settling and the fabric measurement are always done

/// `file_name` is for messages only.
Read<Job> read_job(std::string_view text, const std::string& file_name);

}  // namespace regolab
