/// Stress test: isotropic compression to sigma3, then the top plate moves down at a constant rate while the side walls hold
/// sigma3 [article Sec. 3.1.5, Figure 10; protocols, section 7]. Gravity off, smooth plates. The specimen is not levelled: the
/// top plate first meets its peaks, as in the article.
#pragma once
#include <array>
#include <vector>

#include "apparatus/stress_results.h"
#include "worker/protocol/guard.h"
#include "worker/protocol/servo.h"
#include "worker/protocol/test.h"

namespace regolab::protocol {

class Stress final : public Test {
 public:
  Stress(Bed bed, const StageSpec& spec);

  std::optional<Ending> advance() override;
  StageResult result(const Ending& ending) const override;
  std::string_view phase() const override;
  double fraction() const override;
  std::int64_t steps() const override { return started_ ? bed_.world.step - start_step_ : 0; }
  Bed& bed() override { return bed_; }
  void save(dem::Saver& saver) override { archive(saver); }
  void load(dem::Loader& loader) override { archive(loader); }

 private:
  enum class Phase { kApproach, kRamp, kHold, kShear };
  struct Window {
    double stress[3] = {0, 0, 0};
    int steps = 0;
    template <class A>
    void archive(A& ar) { ar(stress[0], stress[1], stress[2], steps); }
  };
  template <class A>
  void archive(A& ar) {
    ar(bed_, guard_, sigma3_, inertial_number_, end_strain_, start_pressure_, start_law_, end_law_, phase_, started_, ramp_,
       pressure_, start_step_, phase_start_, looks_in_band_, window_, shear_start_time_, height0_, volume0_, void_ratio0_,
       interval_, interval_steps_, samples_, servo_[0], servo_[1], servo_[2]);
    if (bed_.effects[EffectId::kBreakage] != 0) ar(broken_);  // checkpoints of the base model stay as they were
  }
  void enclose();
  void break_overloaded();
  double lateral_offset() const;
  void set_phase(Phase phase);
  double inertial_time() const;
  std::optional<Ending> isotropic_look();
  std::optional<Ending> shear_look();
  void advance_ramp();
  void start_shear();
  void shear_step();
  void close_interval(double strain);
  double axial_strain() const;
  bool window_within(double tolerance) const;

  Bed bed_;
  Guard guard_;
  double sigma3_ = 0, inertial_number_ = 1e-2, end_strain_ = 0.2;
  double servo_steps_ = 50;            // of the isotropic phases; from the specification, so not in checkpoints
  double start_pressure_ = 0;          // of the settled bed [Pa]
  dem::LinearLaw start_law_, end_law_; // stiffness and stress rise together between them
  Phase phase_ = Phase::kApproach;
  bool started_ = false;
  std::array<ServoParts, 3> servo_{};
  double ramp_ = 0;                    // 0 to 1
  double pressure_ = 0;                // wanted now [Pa]
  std::int64_t start_step_ = 0;
  double phase_start_ = 0;             // time [s]
  int looks_in_band_ = 0;
  Window window_;
  double shear_start_time_ = 0, height0_ = 0, volume0_ = 0, void_ratio0_ = 0;
  StressSample interval_;              // sums while open
  int interval_steps_ = 0;
  std::vector<StressSample> samples_;
  int broken_ = 0;                     // clusters, by the `breakage` effect
};

}  // namespace regolab::protocol
