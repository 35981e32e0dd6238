/// What all protocols have in common: they advance look by look, can be saved between looks, and end with a result.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "vocab/measurement.h"
#include "worker/dem/archive.h"
#include "worker/protocol/bed.h"

namespace regolab::protocol {

/// How a test ended: completed, or why not.
struct Ending {
  StageEnd end = StageEnd::kCompleted;
  std::string reason;
};

class Test {
 public:
  virtual ~Test() = default;
  /// Runs to the next look. Empty while the test goes on.
  virtual std::optional<Ending> advance() = 0;
  /// Numbers and curves; what was measured so far when the test ended early.
  virtual StageResult result(const Ending& ending) const = 0;
  virtual std::string_view phase() const = 0;
  virtual double fraction() const = 0;  ///< of the whole, 0 to 1, an estimate
  virtual std::int64_t steps() const = 0;  ///< of this test so far, over all its resumes
  virtual Bed& bed() = 0;
  virtual void save(dem::Saver& saver) = 0;
  virtual void load(dem::Loader& loader) = 0;
};

}  // namespace regolab::protocol
