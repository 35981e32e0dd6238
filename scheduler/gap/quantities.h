/// The observables that have a meaning here: their ids, units and ranges, and the error that stands in when none is given.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace regolab::gap {

struct Quantity {
  /// How an id goes on after the stem: not at all, with "_at_sigma3_XkPa", with "_XkPa", or with "_plate_WxTmm".
  enum class Tail { kNone, kAtSigma3, kSigma3, kPlate };
  std::string_view stem;
  Tail tail = Tail::kNone;
  std::string_view si;
  std::string_view what;            ///< "density", for messages
  double low = 0, high = 0;         ///< what can be measured at all, SI; low itself only where `low_too`
  bool low_too = false;
  double assumed_relative = 0;      ///< share of the value that stands in for a missing error
  double assumed_absolute = 0;      ///< or a fixed one [SI]
  std::string_view unused = {};     ///< why nothing is made of it; empty = used
};

struct ObservableId {
  const Quantity* quantity = nullptr;
  double sigma3 = 0;    ///< [Pa]
  std::string normal;   ///< one spelling: "sigma1_at_sigma3_5kPa" for "..._5.0kPa" and "..._5000Pa"
};

/// Empty when no quantity has that id.
std::optional<ObservableId> scalar_id(std::string_view id);
std::optional<ObservableId> curve_id(std::string_view id);

/// A curve's stem without its sigma3 ("sigma1" with sigma3_kPa beside it), completed.
std::optional<ObservableId> curve_id(std::string_view stem, double sigma3);
/// The same for scalars: "sigma1" under a sigma3 is sigma1_at_sigma3_..., "void_ratio_compressed" as well.
std::optional<ObservableId> scalar_id(std::string_view stem, double sigma3);

/// "1.25": kilopascals as ids write them.
std::string kilopascals(double sigma3);

/// All ids for messages, X for the stress.
std::string known_scalars();
std::string known_curves();

/// The unit of a curve's x, SI: "m" or "1".
std::string_view curve_x_unit(const Quantity& curve);

}  // namespace regolab::gap
