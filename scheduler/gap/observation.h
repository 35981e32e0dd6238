/// What was measured on one material, as its experimenter gave it. SI throughout; units as read stand beside.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/report.h"
#include "vocab/plate.h"

namespace regolab::gap {

/// A number that the experimenter states about the material.
struct Known {
  double value = 0;                      ///< [SI]; of a choice (N_E, rotation) its number
  std::optional<double> standard_error;  ///< [SI]; none: taken as exact
  std::string unit;                      ///< SI
};

struct Material {
  std::optional<double> nominal_max_size, nominal_min_size;  ///< [m]
  std::string size_law;
  std::optional<Known> grain_density;  ///< [kg/m3]
  std::map<std::string, Known> micro;  ///< measured micro-parameters, by the name designs give: theta_F, K_N, N_E, ...
};

struct Specimen {
  std::optional<double> particles;
  std::optional<double> volume;                 ///< [m3]
  std::optional<double> box_length, box_width;  ///< [m]
  int repeats = 0;                              ///< specimens behind each mean; 0 = not said
};

/// What was intended; the real run may have departed from it.
struct Protocol {
  std::optional<double> gravity;  ///< [m/s2]
  std::string preparation, repose, stress, penetration;
  std::vector<double> sigma3;                // [n] [Pa]
  std::vector<double> stated_strain_rate;    // [n] [1/s], or empty
  std::vector<PlateSize> plates;
};

/// A mean over repeats.
struct Scalar {
  std::string id;    ///< normal form: "sigma1_at_sigma3_5kPa" however the file wrote 5
  double value = 0;  ///< [SI]
  std::string unit;  ///< SI
  std::string unit_as_read;
  double standard_error = 0;  ///< of the mean [SI]
  bool assumed = false;       ///< the error was not given: a stated default
  int seeds = 1;              ///< repeats behind the mean
  std::string definition;
  double sigma3 = 0;          ///< [Pa]; 0 when it belongs to none
};

struct MeasuredCurve {
  std::string id;    ///< normal form
  std::string test;  ///< repose, stress, penetration
  double sigma3 = 0; ///< [Pa]; 0 when it belongs to none
  std::string x_name, x_unit, y_name, y_unit;            ///< units SI
  std::string x_unit_as_read, y_unit_as_read;
  std::vector<double> x, y, y_standard_error;            // [n_points] [SI]
  bool assumed = false;
  int seeds = 1;
};

/// Something in the file that takes no part, and why.
struct Unused {
  std::string id;
  std::string why;  ///< problem (why) remedy
};

/// Who measured. Laboratories and other codes may write a law of the same name otherwise; this code does not.
inline constexpr std::string_view kLaboratory = "laboratory", kOtherCode = "other_code", kSameCode = "same_code";

struct ObservationSet {
  std::string name;    ///< of the case
  std::string source;  ///< one of the above, or nothing: not said
  Material material;
  Specimen specimen;
  Protocol protocol;
  std::vector<Scalar> scalars;
  std::vector<MeasuredCurve> curves;
  std::vector<Unused> unused;
  std::map<std::string, Place> places;  ///< where scalars, curves (by id) and keys (by name without unit) stand
  std::vector<Diagnostic> warnings;  ///< read all the same
  bool few = false;                  ///< fewer features than any diagnosis can stand on (see kFewFeatures)
  bool assumed = false;              ///< any error was assumed

  /// Confining stresses met in scalars and curves, ascending [Pa].
  std::vector<double> sigma3() const;
};

inline constexpr std::size_t kFewFeatures = 4;
inline constexpr std::size_t kLargestObservations = 16 << 20;  ///< [bytes] of a file

}  // namespace regolab::gap
