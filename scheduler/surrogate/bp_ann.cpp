#include "scheduler/surrogate/bp_ann.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "scheduler/surrogate/ann_random.h"

namespace regolab::surrogate {
namespace {

constexpr double kSplitPenalty = 1e-3;  // keeps weights of order 1 to 10; early stopping does the rest
constexpr double kFirstPenalty = 1e-2;  // where the evidence starts: stiff enough that no start runs off

AnnData part_of(const AnnData& data, const std::vector<Eigen::Index>& rows) {
  AnnData part{.inputs = data.inputs,
               .outputs = data.outputs,
               .test = {},
               .x = data.x(rows, Eigen::all),
               .y = data.y(rows, Eigen::all)};
  for (const Eigen::Index row : rows) part.test.push_back(data.test[static_cast<std::size_t>(row)]);
  return part;
}

/// The different tests in random order.
std::vector<int> drawn_order(const std::vector<int>& tests, std::uint64_t seed) {
  std::vector<std::pair<double, int>> drawn;
  for (const int test : std::set<int>(tests.begin(), tests.end()))
    drawn.emplace_back(ann_uniform(seed, AnnPurpose::kSplit, static_cast<std::uint64_t>(test)), test);
  std::ranges::sort(drawn);
  std::vector<int> order;
  for (const auto& [number, test] : drawn) order.push_back(test);
  return order;
}

double mean_square(const NetworkShape& shape, const Eigen::VectorXd& w, const AnnData& data) {
  return (network_forward(shape, w, data.x) - data.y).squaredNorm() / static_cast<double>(data.y.size());
}

/// Residuals in the order of network_jacobian: row by row, output by output.
Eigen::VectorXd residual_of(const NetworkShape& shape, const Eigen::VectorXd& w, const AnnData& data) {
  const Eigen::MatrixXd error = (network_forward(shape, w, data.x) - data.y).transpose();
  return Eigen::Map<const Eigen::VectorXd>(error.data(), error.size());
}

Fit fit_network(const AnnData& data, const NetworkShape& shape, std::uint64_t seed, int start, const FitOptions& options) {
  const LeastSquares problem{.residual = [&](const Eigen::VectorXd& w) { return residual_of(shape, w, data); },
                             .jacobian = [&](const Eigen::VectorXd& w) { return network_jacobian(shape, w, data.x); },
                             .penalised = shape.penalised()};
  return fit_least_squares(problem, network_start(shape, seed, static_cast<std::uint64_t>(start)), options);
}

}  // namespace

Split split_tests(const std::vector<int>& tests, std::uint64_t seed) {
  const std::vector<int> order = drawn_order(tests, seed);
  const auto held = static_cast<std::size_t>(std::lround(0.15 * static_cast<double>(order.size())));
  Split split;
  for (std::size_t i = 0; i < order.size(); ++i) {
    auto& group = i < held ? split.validation : i < 2 * held ? split.test : split.training;
    group.push_back(order[i]);
  }
  for (auto* group : {&split.training, &split.validation, &split.test}) std::ranges::sort(*group);
  return split;
}

std::vector<Eigen::Index> rows_of(const std::vector<int>& test, const std::vector<int>& wanted) {
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < test.size(); ++i) {
    if (std::ranges::binary_search(wanted, test[i])) rows.push_back(static_cast<Eigen::Index>(i));
  }
  return rows;
}

Eigen::MatrixXd AnnModel::predict(const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(x.rows(), shape.outputs);
  for (const Fit& member : members) sum += network_forward(shape, member.w, x);
  return sum / static_cast<double>(members.size());
}

SplitTraining train_on_split(const AnnData& data, const Split& split, const NetworkShape& shape, int starts,
                             std::uint64_t seed) {
  const AnnData training = part_of(data, rows_of(data.test, split.training));
  const AnnData validation = part_of(data, rows_of(data.test, split.validation));
  const auto larger_error = [&](const Eigen::VectorXd& w) {
    return std::max(mean_square(shape, w, training), mean_square(shape, w, validation));
  };
  const FitOptions options{.mode = Penalty::kFixed, .penalty = kSplitPenalty, .watched = larger_error};
  SplitTraining best{.model = {.shape = shape, .members = {}}};
  for (int start = 0; start < starts; ++start) {
    Fit fit = fit_network(training, shape, seed, start, options);
    if (!best.model.members.empty() && !(fit.watched < best.model.members.front().watched)) continue;
    best.model.members = {std::move(fit)};
    best.chosen = start + 1;
  }
  return best;
}

AnnModel train_ensemble(const AnnData& data, const NetworkShape& shape, int members, std::uint64_t seed) {
  const auto tests = std::set<int>(data.test.begin(), data.test.end()).size();
  const FitOptions options{.mode = Penalty::kEvidence,
                           .penalty = kFirstPenalty,
                           .independent = static_cast<double>(tests) * static_cast<double>(data.y.cols()),
                           .watched = {}};
  AnnModel model{.shape = shape, .members = {}};
  for (int start = 0; start < members; ++start) model.members.push_back(fit_network(data, shape, seed, start, options));
  return model;
}

TrainEffort effort_for(const AnnData& data) {
  constexpr int kOneAtATime = 64;
  constexpr int kManyRows = 2000;
  const int tests = static_cast<int>(std::set<int>(data.test.begin(), data.test.end()).size());
  TrainEffort effort{.folds = tests <= kOneAtATime ? tests : 10};
  if (data.x.rows() > kManyRows) {
    effort.starts = 8;
    effort.members = 2;
  }
  return effort;
}

Eigen::MatrixXd leave_tests_out(const AnnData& data, const NetworkShape& shape, const TrainEffort& effort,
                                std::uint64_t seed) {
  const std::vector<int> order = drawn_order(data.test, seed);
  Eigen::MatrixXd predicted(data.y.rows(), data.y.cols());
  for (int fold = 0; fold < effort.folds; ++fold) {
    std::vector<int> left_out;
    for (std::size_t i = static_cast<std::size_t>(fold); i < order.size(); i += static_cast<std::size_t>(effort.folds))
      left_out.push_back(order[i]);
    std::ranges::sort(left_out);
    std::vector<Eigen::Index> kept, held;
    for (std::size_t i = 0; i < data.test.size(); ++i)
      (std::ranges::binary_search(left_out, data.test[i]) ? held : kept).push_back(static_cast<Eigen::Index>(i));
    const AnnModel model = train_ensemble(part_of(data, kept), shape, effort.members, seed);
    predicted(held, Eigen::all) = model.predict(data.x(held, Eigen::all));
  }
  return predicted;
}

FitQuality quality_of(const Eigen::VectorXd& data, const Eigen::VectorXd& predicted) {
  FitQuality quality{.rows = static_cast<int>(data.size())};
  if (data.size() == 0) return quality;
  const Eigen::VectorXd a = data.array() - data.mean(), b = predicted.array() - predicted.mean();
  const double squared_error = (predicted - data).squaredNorm();
  quality.rms = std::sqrt(squared_error / static_cast<double>(data.size()));
  quality.relative = quality.rms / std::abs(data.mean());
  const double spread = a.norm() * b.norm();
  if (data.size() < 2 || !(spread > 0)) return quality;
  quality.r = a.dot(b) / spread;
  quality.r2 = 1 - squared_error / a.squaredNorm();
  return quality;
}

}  // namespace regolab::surrogate
