/// A surrogate: from the parameters of a material to its measured properties, with a band, in microseconds instead of a DEM run.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scheduler/surrogate/dataset.h"
#include "scheduler/surrogate/gaussian_process.h"
#include "scheduler/surrogate/scatter.h"

namespace regolab::surrogate {

inline constexpr double kCoverage = 0.90;  ///< of every interval
inline constexpr double kNormal90 = 1.6448536269514722;

/// A predicted number [SI]. The band is where one DEM run of that material, with a seed of its own, would fall.
struct Estimate {
  std::string id;
  std::string unit;
  double value = 0, low = 0, high = 0;
  double mean_low = 0, mean_high = 0;  ///< band of the material's own mean over many seeds
};

/// How well held-out points are predicted.
struct Skill {
  int points = 0;
  double r = 0, r2 = 0;         ///< correlation; share of the variance explained. Of the logarithm where the response is modelled so
  double rms = 0;               ///< [SI]
  double relative = 0;          ///< mean of |error / measured|
  double coverage = 0;          ///< share of held-out points inside their 90 % band, its width set by other points
};

/// One property is one process. The values of a property at several confining stresses are a family: its processes are the level,
/// slope, curvature ... over the logarithm of the stress, so that what they have in common is learned from all of them.
struct ResponseModel {
  std::string id;
  std::string unit;
  bool logarithm = false;
  double inflation = 1;          ///< of what the process does not know, so that bands cover 90 % of the points left out
  double noise = 0;              ///< variance of one run of the average material, as repeats show it; 0: none were run
  std::string family;            ///< "sigma1_at_sigma3_*", or the id
  std::vector<double> weight;    ///< [n_processes] the response is their sum with these weights
  std::vector<std::shared_ptr<const GaussianProcess>> processes;  ///< shared within a family
  Scatter scatter;               ///< likewise: the noise of a process is that of the average material
  Skill skill;                   ///< each material left out in turn

  /// As modelled, that is of the logarithm where it is.
  GaussianProcess::Prediction predict(const Inputs& inputs) const;
};

/// Stress-strain curves: the logarithms of sigma1 over strain and confining stress, in few principal components.
struct CurveModel {
  std::vector<double> sigma3;                ///< [n] ascending [Pa]
  Eigen::VectorXd mean;                      ///< [n * (kStrainSteps + 1)]
  Eigen::MatrixXd components;                ///< [n * (kStrainSteps + 1)][n_components]
  Eigen::VectorXd residual;                  ///< standard deviation that the components leave
  std::vector<GaussianProcess> processes;    ///< [n_components] of the scores
  Scatter scatter;
};

struct Model {
  std::string id;                ///< first 12 digits of the SHA-256 of its file
  std::string name;
  int physics_version = 0;
  Dataset data;
  std::vector<ResponseModel> responses;
  std::optional<CurveModel> curves;

  /// REQUIRES: x has one value per column.
  std::vector<Estimate> predict(const std::vector<double>& x) const;
  Estimate predict_one(const ResponseModel& response, const Inputs& inputs) const;
  /// Null when it is not modelled.
  const ResponseModel* find(const std::string& response) const;
  /// sigma1 [Pa] at a confining stress between those of the data, by interpolation of logarithms. Empty: outside, or not modelled.
  std::optional<Estimate> sigma1_at(const std::vector<double>& x, double sigma3) const;
  /// sigma1 on the strain grid; empty as above.
  std::vector<Estimate> curve_at(const std::vector<double>& x, double sigma3) const;
  /// What of x lies outside the data: "theta_F = 75 deg (the data end at 60)".
  std::vector<std::string> outside(const std::vector<double>& x) const;
};

/// The model conditioned on further rows, hyperparameters kept: what new DEM runs taught. Errors as dataset_of.
Result<Model> with_rows(const Model& model, const std::vector<Source>& sources);

/// Called before each response; false ends the training (kCancelled).
using OnProgress = std::function<bool(const std::string& response, int done, int of)>;

/// Fits every response that the data hold often enough. The same data give the same model, bit for bit.
Result<Model> train(const std::string& name, Dataset data, const OnProgress& on_progress = {});

/// As a file, and back: data and hyperparameters, so a loaded model needs no fit. kDataLoss: not ours, or damaged;
/// kFailedPrecondition: made under another physics version.
std::string to_json(const Model& model);
Result<Model> model_from_json(const std::string& text);

/// The model that comes with the program, loaded once; null when this build has none.
const Model* shipped_model();

}  // namespace regolab::surrogate
