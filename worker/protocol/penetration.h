/// Plate penetration: a rigid plate, edge first, goes down in the middle of the settled bed at a constant speed, to half the bed's
/// depth [article Sec. 4.2, Fig. 18; protocols, section 8]. Gravity on, top free, the law that the bed settled under.
#pragma once
#include <vector>

#include "worker/protocol/guard.h"
#include "worker/protocol/test.h"

namespace regolab::protocol {

/// Means over one interval of depth. Depth is that of the plate's edge below the mean surface of the bed as it settled: the first
/// touch would hang on one grain that stands out. Negative while only such grains are met.
struct PenetrationSample {
  double depth = 0;       ///< middle of the interval [m]
  double force = 0;       ///< upward, of the grains on the plate, friction on its sides included [N]
  double contacts = 0;    ///< with the plate
  double unbalanced = 0;  ///< unbalanced force ratio at its end

  template <class A>
  void archive(A& ar) { ar(depth, force, contacts, unbalanced); }
};

class Penetration final : public Test {
 public:
  Penetration(Bed bed, const StageSpec& spec);

  std::optional<Ending> advance() override;
  StageResult result(const Ending& ending) const override;
  std::string_view phase() const override { return "penetration"; }
  double fraction() const override;
  std::int64_t steps() const override { return started_ ? bed_.world.step - start_step_ : 0; }
  Bed& bed() override { return bed_; }
  void save(dem::Saver& saver) override { archive(saver); }
  void load(dem::Loader& loader) override { archive(loader); }

 private:
  template <class A>
  void archive(A& ar) {
    ar(bed_, guard_, plate_.width, plate_.thickness, inertial_number_, speed_, surface_, interval_, first_, next_, last_, start_step_,
       started_, sum_, sum_steps_, samples_);
    bed_.world.walls.archive_plate(ar);
  }
  void bring_plate();
  double depth() const;
  void note();
  void close_interval();

  Bed bed_;
  Guard guard_;
  PlateSize plate_;
  double inertial_number_ = 1e-2;
  double speed_ = 0;               // downwards [m/s]
  double surface_ = 0;             // mean height of the settled bed [m]
  double interval_ = 0;            // of depth [m]
  int first_ = 0, next_ = 0, last_ = 0;  // depths in intervals: at the start, the next to be reached, at the end
  std::int64_t start_step_ = 0;
  bool started_ = false;
  PenetrationSample sum_;          // over the open interval
  int sum_steps_ = 0;
  std::vector<PenetrationSample> samples_;
};

/// Numbers and the curve of a whole run into a bed of this mean height; ids end in the plate. `grain`: mean diameter [m].
void add_penetration_results(const std::vector<PenetrationSample>& samples, const PlateSize& plate, double height, double grain,
                             StageResult& out);
Curve penetration_curve(const std::vector<PenetrationSample>& samples, const PlateSize& plate);

}  // namespace regolab::protocol
