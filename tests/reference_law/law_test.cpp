/// The engine's law beside its plain twin on random contacts, and the same bits one at a time, four and eight together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "reference_law/plain_law.h"
#include "worker/generate/random.h"

namespace regolab::test {
namespace {

constexpr int kSets = 2500, kInSet = dem::kMostLanes;

/// Contacts that share a law and a step, as those of one world do.
struct ContactSet {
  PlainLaw law;
  double dt = 0;
  PlainTouch touch[kInSet];
  double tilt[kInSet] = {};  ///< of the spring out of the tangent plane [rad]
};

class Draws {
 public:
  explicit Draws(int set) : set_(static_cast<std::uint64_t>(set)) {}
  double share() { return random_.uniform(generate::Purpose::kWitness, set_, drawn_++); }
  bool one_in(int n) { return share() * n < 1; }
  double between(double low, double high) { return low + (high - low) * share(); }
  double decades(double low, double high) { return low * std::pow(high / low, share()); }
  Vec3 direction() {
    const double z = between(-1, 1), angle = between(0, 2 * std::numbers::pi), across = std::sqrt(1 - z * z);
    return {across * std::cos(angle), across * std::sin(angle), z};
  }

 private:
  generate::Random random_{23};
  std::uint64_t set_, drawn_ = 0;
};

/// Spring, dashpots and cap are of one size, so that every branch is taken.
ContactSet random_set(int n) {
  Draws draw(n);
  ContactSet set;
  const double mass = draw.decades(1e-7, 1), stiffness = draw.decades(1e2, 1e7), rate = std::sqrt(stiffness / mass);
  set.dt = 0.1 / rate;
  set.law = {.normal_stiffness = stiffness,
             .tangential_stiffness = stiffness * draw.between(0.3, 1.2),
             .normal_damping = draw.decades(0.01, 5),
             .tangential_damping = draw.decades(0.01, 5),
             .damping_is_ratio = draw.one_in(2),
             .most_damping_ratio = draw.one_in(2) ? draw.decades(0.1, 2) : 0};
  if (!set.law.damping_is_ratio) {
    set.law.normal_damping *= 2 * mass * rate;
    set.law.tangential_damping *= 2 * mass * rate;
  }
  for (int k = 0; k < kInSet; ++k) {
    PlainTouch& touch = set.touch[k];
    touch.normal = draw.direction();
    touch.overlap = draw.decades(1e-8, 1e-4);
    touch.velocity = touch.overlap * rate * draw.decades(1e-3, 10) * draw.direction();
    touch.friction = draw.one_in(8) ? 0 : draw.between(0.05, 1.5);
    touch.mass = mass * draw.decades(0.3, 3);
    set.tilt[k] = draw.decades(1e-6, 0.1);
    const Vec3 across = cross(touch.normal, draw.direction());
    const double length = draw.one_in(8) ? 0 : touch.overlap * draw.decades(1e-3, 3);
    touch.spring = length * (std::cos(set.tilt[k]) * ((1 / norm(across)) * across) + std::sin(set.tilt[k]) * touch.normal);
  }
  return set;
}

/// The engine's answers to contacts [from, from + lanes of Real) of a set.
struct Answers {
  Vec3 force[kInSet], spring[kInSet];
};
double& lane(double& v, int) { return v; }
template <class Pack>
decltype(auto) lane(Pack& v, int l) { return v[l]; }

template <class Real>
Answers engine_answers(const ContactSet& set) {
  constexpr int kWide = static_cast<int>(sizeof(Real) / sizeof(double));
  const dem::LinearLaw law = engine_law(set.law);
  Answers out;
  for (int from = 0; from < kInSet; from += kWide) {
    dem::ContactPoint<Real> c{};
    Real friction{}, root_mass{};
    for (int l = 0; l < kWide; ++l) {
      const PlainTouch& t = set.touch[from + l];
      lane(c.nx, l) = t.normal[0], lane(c.ny, l) = t.normal[1], lane(c.nz, l) = t.normal[2];
      lane(c.vx, l) = t.velocity[0], lane(c.vy, l) = t.velocity[1], lane(c.vz, l) = t.velocity[2];
      lane(c.sx, l) = t.spring[0], lane(c.sy, l) = t.spring[1], lane(c.sz, l) = t.spring[2];
      lane(c.overlap, l) = t.overlap, lane(friction, l) = t.friction, lane(root_mass, l) = std::sqrt(t.mass);
    }
    dem::linear_contact(law, friction, root_mass, set.dt, c);
    for (int l = 0; l < kWide; ++l) {
      out.force[from + l] = {lane(c.fx, l), lane(c.fy, l), lane(c.fz, l)};
      out.spring[from + l] = {lane(c.sx, l), lane(c.sy, l), lane(c.sz, l)};
    }
  }
  return out;
}

/// The size of the numbers that are added up [N].
double force_scale(const PlainLaw& law, double dt, const PlainTouch& t) {
  const double critical = 2 * std::sqrt(t.mass * std::max(law.normal_stiffness, law.tangential_stiffness));
  const double eta = std::max(law.normal_damping, law.tangential_damping) * (law.damping_is_ratio ? critical : 1.0);
  return law.normal_stiffness * t.overlap + law.tangential_stiffness * (norm(t.spring) + dt * norm(t.velocity)) + eta * norm(t.velocity);
}

/// Some fifty operations lie between what comes in and the force: 1e-13 of the scale is ten times their round-off. The twin turns the
/// spring with roots, the engine with the first terms of 1/sqrt(1 - tilt^2): the next is 5/16 tilt^6.
TEST(Law, FollowsItsPlainTwinOnRandomContacts) {
  int slides = 0, sticks = 0, would_pull = 0, capped = 0, uncapped = 0, no_spring = 0, no_friction = 0;
  double worst_flat = 0;
  for (int n = 0; n < kSets; ++n) {
    const ContactSet set = random_set(n);
    const Answers fast = engine_answers<double>(set);
    for (int k = 0; k < kInSet; ++k) {
      const PlainTouch& touch = set.touch[k];
      const PlainAnswer plain = plain_contact(set.law, set.dt, touch);
      const double scale = force_scale(set.law, set.dt, touch), tilt = set.tilt[k];
      const double difference = std::max(norm(fast.force[k] - plain.force),
                                         set.law.tangential_stiffness * norm(fast.spring[k] - plain.spring)) / scale;
      ASSERT_LT(difference, 1e-13 + 0.4 * std::pow(tilt, 6)) << "set " << n << ", contact " << k << ", tilt " << tilt;
      if (tilt < 3e-3) worst_flat = std::max(worst_flat, difference);
      ++(plain.slides ? slides : sticks);
      ++(plain.capped ? capped : uncapped);
      would_pull += plain.would_pull;
      no_spring += norm(touch.spring) == 0;
      no_friction += touch.friction == 0;
    }
  }
  RecordProperty("largest_difference_of_force_scale", std::to_string(worst_flat * 1e16) + "e-16");
  for (const int cases : {slides, sticks, would_pull, capped, uncapped, no_spring, no_friction}) EXPECT_GT(cases, 1000);
}

bool same_bits(const Answers& a, const Answers& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST(Law, GivesTheSameBitsOneAtATimeFourAndEightTogether) {
  for (int n = 0; n < kSets; ++n) {
    const ContactSet set = random_set(n);
    const Answers one = engine_answers<double>(set);
    ASSERT_TRUE(same_bits(engine_answers<dem::Four>(set), one)) << "set " << n;
    ASSERT_TRUE(same_bits(engine_answers<dem::Eight>(set), one)) << "set " << n;
  }
}

TEST(Law, OfAContactWithNothingButOverlapPushesAlongTheNormal) {
  ContactSet set = random_set(0);
  for (PlainTouch& touch : set.touch) touch.velocity = touch.spring = {0, 0, 0};
  const Answers fast = engine_answers<double>(set);
  for (int k = 0; k < kInSet; ++k) {
    const PlainTouch& touch = set.touch[k];
    EXPECT_EQ(fast.force[k], (set.law.normal_stiffness * touch.overlap) * touch.normal);
    EXPECT_EQ(norm(fast.spring[k]), 0);
  }
}

}  // namespace
}  // namespace regolab::test
