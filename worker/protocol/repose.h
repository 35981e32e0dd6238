/// Angle of repose: the right wall is taken away and what does not hold falls over the edge
/// [article Sec. 3.1.4, Figure 8; protocols, section 6].
#pragma once
#include <vector>

#include "worker/protocol/guard.h"
#include "worker/protocol/test.h"

namespace regolab::protocol {

class Repose final : public Test {
 public:
  explicit Repose(Bed bed);

  std::optional<Ending> advance() override;
  StageResult result(const Ending& ending) const override;
  std::string_view phase() const override { return "collapse"; }
  double fraction() const override;
  std::int64_t steps() const override { return started_ ? bed_.world.step - start_step_ : 0; }
  Bed& bed() override { return bed_; }
  void save(dem::Saver& saver) override { archive(saver); }
  void load(dem::Loader& loader) override { archive(loader); }

 private:
  template <class A>
  void archive(A& ar) { ar(bed_, guard_, start_time_, start_step_, time_limit_, height_before_, looks_at_rest_, started_); }
  void open_the_box();
  void empty_the_tray();

  Bed bed_;
  Guard guard_;
  double start_time_ = 0;
  std::int64_t start_step_ = 0;
  double time_limit_ = 0;
  double height_before_ = 0;
  int looks_at_rest_ = 0;
  bool started_ = false;
};

/// The readings of one surface profile; angles in rad. `x` column centres, `h` heights [n].
struct SlopeReading {
  double sloping_part = 0;    ///< least-squares line between 10 and 90 % of the range, right of the crest
  bool has_sloping_part = false;
  double whole = 0;           ///< line through all of h(x)
  double chord = 0;           ///< crest to edge
  double wedge = 0;           ///< atan(2 mean(h) / L)
};
SlopeReading read_slope(const std::vector<double>& x, const std::vector<double>& h, double length);

}  // namespace regolab::protocol
