/// A stage's identity as text: sorted fields, SI, shortest round-trip decimals. Its SHA-256 is the stage_key.
#pragma once
#include <string>

#include "vocab/stage.h"

namespace regolab {

/// Only what the stage depends on is written (a settle stage does not know sigma3 or the inertial number), and a stage on a
/// bed carries its settle stage's text, so equal text means equal bits.
std::string canonical_text(const StageSpec& spec);

/// The box the stage runs in: the spec's, or by rule L = 3 s L_S, W = 2.4 s L_S, s = (N/400)^(1/3) [m].
struct Base {
  double length;
  double width;
};
Base base_of(const StageSpec& spec);

}  // namespace regolab
