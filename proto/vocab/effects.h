/// Candidate unmodelled effects: what the base model leaves out, each a named law with a strength. Strength 0 is the base model.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace regolab {

enum class StageKind;

/// In the order of the table; the wire, the store and canonical text use names alone.
enum class EffectId {
  kRollingResistance,
  kRollingVariant,  ///< a choice, meant while rolling_resistance is on
  kCohesion,
  kCohesionVariant,  ///< a choice, meant while cohesion is on
  kHertzianContact,
  kWallFriction,
  kSizeDistribution,
  kBoundaryCompliance,
  kLateralStressOffset,
  kLoadingRate,
  kPreparationFriction,
  kPreparationGravity,
  kBreakage,
  kFrameCompliance,
  kSeating,
  kLoadCellOffset,
  kLoadCellGain,
  kGrainDensity,
};
inline constexpr std::size_t kEffectCount = 18;

enum class RollingVariant { kElasticPlastic = 0, kIwashitaOda = 1 };
enum class CohesionVariant { kConstant = 0, kJkr = 1 };

/// The strengths, SI; of a variant its number.
struct EffectSet {
  std::array<double, kEffectCount> strength{};

  double operator[](EffectId id) const { return strength[static_cast<std::size_t>(id)]; }
  double& operator[](EffectId id) { return strength[static_cast<std::size_t>(id)]; }
  bool any() const { return *this != EffectSet{}; }
  bool operator==(const EffectSet&) const = default;
};

/// Stages an effect acts in, as bits 1 << StageKind. What acts in settling acts in all that start from the bed.
namespace acts {
inline constexpr unsigned kSettle = 1, kFabric = 2, kRepose = 4, kStress = 8, kPenetration = 16;
inline constexpr unsigned kEverywhere = 31;
}  // namespace acts

struct EffectInfo {
  EffectId id;
  std::string_view name;       ///< as files write it
  int version;                 ///< raised whenever the same strength would give other bits
  unsigned acts_in;            ///< bits of acts::
  std::string_view parameter;  ///< symbol of the strength
  std::string_view si;         ///< its unit, "1" for pure numbers
  double low, high;            ///< what a file may say
  double prior_low, prior_high;  ///< where a diagnosis looks
  bool logarithmic;            ///< prior uniform in the logarithm
  std::string_view law;
  std::string_view moves;      ///< what it changes
  std::string_view source;
  std::optional<EffectId> variant_of = {};       ///< a choice that means something only while that effect is on
  std::span<const std::string_view> choices = {};
};

std::span<const EffectInfo> all_effects();
inline const EffectInfo& info_of(EffectId id) { return all_effects()[static_cast<std::size_t>(id)]; }
/// Null when there is none of that name.
const EffectInfo* find_effect(std::string_view name);

/// The effects that a stage of this kind, the bed it starts from included, depends on; the others at 0, and a variant too when
/// its effect is off.
EffectSet acting_in(const EffectSet& effects, StageKind kind);

/// "cohesion=200;rolling_resistance=0.3": those that are not 0, by name, shortest round-trip decimals; empty for the base model.
std::string effects_text(const EffectSet& effects);
/// The same back; nothing when a name is unknown or a number is none.
std::optional<EffectSet> effects_from_text(std::string_view text);

}  // namespace regolab
