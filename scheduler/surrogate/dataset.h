/// What surrogates learn from: materials with the mean of each response over their seeds. SI throughout.
#pragma once
#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

#include "vocab/result.h"
#include "vocab/result_table.h"

namespace regolab::surrogate {

/// One varied parameter: a number, or one of some names. `profile` and `particles` belong to the run, the others to the material.
struct InputColumn {
  std::string name;                 ///< of the field: theta_F, N_E, gravity, ...
  std::vector<std::string> labels;  ///< of a choice, in the field's order; empty = a number
  double low = 0, high = 0;         ///< smallest and largest of the data [SI]
  bool is_choice() const { return !labels.empty(); }
};

/// The mean of a response over the seeds of a point.
struct SeedMean {
  double value = 0;    ///< [SI]
  int seeds = 0;
  double squares = 0;  ///< sum of squared deviations of the seeds from it; not kept in a model's file
};

struct DataRow {
  std::string source;                    ///< "article-l32-ad98e2, point 7"
  std::vector<double> x;                 ///< [n_columns] SI value, or index of the label
  std::map<std::string, SeedMean> mean;  ///< by response id
};

/// A curve's values on the grid: sigma1 at these axial strains under one confining stress.
inline constexpr int kStrainSteps = 20;      ///< 1 % apart, 0 to 20 %
using CurveSamples = std::vector<double>;    // [kStrainSteps + 1] [Pa]

struct Dataset {
  std::vector<InputColumn> columns;
  std::vector<DataRow> rows;
  std::map<std::string, std::string> unit;   ///< SI unit of each response
  std::map<std::string, std::string> fixed;  ///< what never varied, as shown: particle_density -> "2.93 g/cm3"
};

/// A table as read from the store, with what its curves add.
struct Source {
  ResultTable table;
  /// (point, seed) -> response id "sigma1_curve_at_sigma3_10kPa" -> samples
  std::map<std::pair<int, std::uint64_t>, std::map<std::string, CurveSamples>> curves;
};

/// Rows of all sources together, one for each material (different seeds are expected in different sources: equal ones would count twice); a parameter that one varies and another keeps fixed is a column. Curves become responses
/// "sigma1_at_sigma3_10kPa@0.05". Errors: kInvalidArgument (a number that is not finite, a unit that cannot be read, a factor that one
/// source neither varies nor names), kFailedPrecondition (fewer than `kFewestRows` rows with numbers).
inline constexpr std::size_t kFewestRows = 8;
Result<Dataset> dataset_of(const std::vector<Source>& sources);

/// The rows of one source for given columns.
Result<std::vector<DataRow>> rows_of(const Source& source, const std::vector<InputColumn>& columns);

/// What `text` says for a column: SI value, or the index of a choice ("0.1" with unit "deg", "40 degree", "mixture"; "quick" of profile).
Result<double> input_value(const std::string& name, const std::string& text, const std::string& unit = {});

/// A material and its specimen as processes see them. A measured mean scatters as one over the number of grains behind it.
struct Inputs {
  Eigen::VectorXd scaled;  ///< numbers to [0, 1] over the data's range (`particles` by its logarithm), choices one-hot
  double grains = 1;       ///< in the specimen, in units of the smallest specimen of the data
};
Inputs inputs_of(const std::vector<InputColumn>& columns, const std::vector<double>& x);

/// What belongs to the run and not to the material: the profile and the number of particles.
bool is_of_the_run(const std::string& column);

/// Interpolates a curve onto the strain grid; empty when it ends before.
CurveSamples sampled(const std::vector<double>& strain, const std::vector<double>& stress);

}  // namespace regolab::surrogate
