/// Sedimentation under gravity until rest [article Sec. 2.4; protocols, section 4].
#pragma once
#include <vector>

#include "worker/protocol/guard.h"
#include "worker/protocol/test.h"

namespace regolab::protocol {

class Settle final : public Test {
 public:
  /// Takes over a generated bed. The seed chooses the witness particle whose forces are recorded (article, Figure 4).
  Settle(Bed bed, const StageSpec& spec);

  std::optional<Ending> advance() override;
  StageResult result(const Ending& ending) const override;
  std::string_view phase() const override { return quenching_ ? "damping out" : "sedimentation"; }
  double fraction() const override;
  std::int64_t steps() const override { return bed_.world.step; }
  Bed& bed() override { return bed_; }
  void save(dem::Saver& saver) override { archive(saver); }
  void load(dem::Loader& loader) override { archive(loader); }

 private:
  struct Record {
    double time, kinetic, floor_force, unbalanced, witness_x, witness_y, witness_z;
    template <class A>
    void archive(A& ar) { ar(time, kinetic, floor_force, unbalanced, witness_x, witness_y, witness_z); }
  };
  template <class A>
  void archive(A& ar) {
    ar(bed_, guard_, witness_, time_limit_, fall_time_, looks_at_rest_, quenching_, quench_looks_, started_, record_);
  }
  void note();
  bool at_rest() const;
  std::optional<Ending> fall();
  std::optional<Ending> quench();
  void end_preparation();
  double carried() const;

  Bed bed_;
  Guard guard_;
  double stiffness_number_ = 0;        // for the law that the bed is left with
  int witness_ = 0;
  double time_limit_ = 0;
  double fall_time_ = 0;
  int looks_at_rest_ = 0;
  bool quenching_ = false;
  int quench_looks_ = 0;
  bool started_ = false;
  std::vector<Record> record_;
};

}  // namespace regolab::protocol
