#include "scheduler/gap/space.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace regolab::gap {
namespace {

constexpr std::string_view kNumbers[] = {"theta_F", "K_N", "eta_N", "K_T", "eta_T", "L_S", "gravity"};
constexpr std::string_view kChoices[] = {"N_E", "rotation"};

std::set<double> values_of(const Bank& bank, std::size_t input) {
  std::set<double> out;
  for (const BankRow& row : bank.rows) out.insert(row.inputs[input]);
  return out;
}

}  // namespace

Space space_of(const Bank& bank) {
  Space space;
  for (const std::string_view name : kNumbers) {
    const auto input = bank.input(std::string(name));
    if (!input) continue;
    const auto values = values_of(bank, *input);
    if (values.size() > 1) space.axes.push_back({std::string(name), *values.begin(), *values.rbegin(), {}});
  }
  for (const std::string_view name : kChoices) {
    const auto input = bank.input(std::string(name));
    if (!input) continue;
    const auto values = values_of(bank, *input);
    if (values.size() > 1) space.axes.push_back({std::string(name), *values.begin(), *values.rbegin(), {values.begin(), values.end()}});
  }
  for (std::size_t i = 0; i < bank.inputs.size(); ++i) {
    const auto values = values_of(bank, i);
    if (values.size() == 1) space.fixed[bank.inputs[i].name] = *values.begin();
  }
  return space;
}

int Space::find(const std::string& name) const {
  const auto found = std::ranges::find(axes, name, &Axis::name);
  return found == axes.end() ? -1 : static_cast<int>(found - axes.begin());
}

double Space::value(std::size_t axis, double u) const {
  const Axis& a = axes[axis];
  if (!a.is_choice()) return a.low + (a.high - a.low) * u;
  const auto n = a.choices.size();
  return a.choices[std::min(n - 1, static_cast<std::size_t>(u * static_cast<double>(n)))];
}

Eigen::MatrixXd Space::scaled(const Eigen::MatrixXd& values, int extra) const {
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(values.cols(), static_cast<Eigen::Index>(groups(extra).size()));
  Eigen::Index column = 0;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const Axis& a = axes[k];
    const auto row = values.row(static_cast<Eigen::Index>(k)).transpose();
    if (!a.is_choice()) {
      x.col(column++) = (row.array() - a.low) / (a.high - a.low);
      continue;
    }
    for (const double choice : a.choices) x.col(column++) = (row.array() == choice).cast<double>();
  }
  return x;
}

Groups Space::groups(int extra) const {
  Groups out;
  int group = 0;
  for (const Axis& a : axes) {
    out.insert(out.end(), std::max<std::size_t>(1, a.choices.size()), group);
    ++group;
  }
  for (int k = 0; k < extra; ++k) out.push_back(group++);
  return out;
}

}  // namespace regolab::gap
