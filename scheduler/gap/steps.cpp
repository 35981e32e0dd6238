#include "scheduler/gap/steps.h"

#include <cstring>

#include "scheduler/gap/diagnosis.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Numbers in the machine's own form: a step is taken up on the machine whose store holds it.
class Writer {
 public:
  void put(double value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void put(std::int64_t value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void put(const std::string& text) { put(static_cast<std::int64_t>(text.size())), bytes_ += text; }
  void put(const MatrixXd& m) {
    put(static_cast<std::int64_t>(m.rows())), put(static_cast<std::int64_t>(m.cols()));
    for (Index k = 0; k < m.size(); ++k) put(m.data()[k]);
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Taker {
 public:
  explicit Taker(const std::string& bytes) : bytes_(bytes) {}

  double real() { return plain<double>(); }
  std::int64_t whole() { return plain<std::int64_t>(); }
  std::string text() {
    const auto n = whole();
    if (!fits(n, 1)) return {};
    const std::string out = bytes_.substr(at_, static_cast<std::size_t>(n));
    at_ += static_cast<std::size_t>(n);
    return out;
  }
  MatrixXd matrix() {
    const auto rows = whole(), cols = whole();
    if (!fits(rows, 1) || !fits(cols, 1) || !fits(rows * cols, sizeof(double))) return {};
    MatrixXd out(rows, cols);
    for (Index k = 0; k < out.size(); ++k) out.data()[k] = real();
    return out;
  }
  /// Everything was there, and nothing more.
  bool whole_read() const { return good_ && at_ == bytes_.size(); }

 private:
  bool fits(std::int64_t count, std::size_t each) {
    good_ = good_ && count >= 0 && static_cast<std::uint64_t>(count) <= (bytes_.size() - at_) / each;
    return good_;
  }
  template <class T>
  T plain() {
    T value{};
    if (!fits(sizeof value, 1)) return value;
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
  bool good_ = true;
};

const std::string kPosterior = "posterior/1", kWhere = "where/1";

}  // namespace

std::string bytes_of(const Posterior& p) {
  Writer out;
  out.put(kPosterior);
  out.put(p.log_z), out.put(p.log_z_error), out.put(p.u), out.put(MatrixXd(p.log_likelihood));
  return out.take();
}

std::optional<Posterior> posterior_from(const std::string& bytes) {
  Taker in(bytes);
  if (in.text() != kPosterior) return std::nullopt;
  Posterior p;
  p.log_z = in.real(), p.log_z_error = in.real();
  p.u = in.matrix();
  const MatrixXd log_likelihood = in.matrix();
  if (!in.whole_read() || log_likelihood.size() != p.u.cols()) return std::nullopt;
  p.log_likelihood = Eigen::Map<const VectorXd>(log_likelihood.data(), log_likelihood.size());
  return p;
}

std::string bytes_of(const std::vector<GroupGap>& where) {
  Writer out;
  out.put(kWhere), out.put(static_cast<std::int64_t>(where.size()));
  for (const GroupGap& g : where) {
    out.put(static_cast<std::int64_t>(g.group.test)), out.put(g.group.sigma3), out.put(static_cast<std::int64_t>(g.group.part));
    out.put(g.feature), out.put(g.text);
    for (const double v : {g.shift_pct, g.z, g.p, g.p_adjusted}) out.put(v);
  }
  return out.take();
}

std::optional<std::vector<GroupGap>> where_from(const std::string& bytes) {
  Taker in(bytes);
  if (in.text() != kWhere) return std::nullopt;
  const auto n = in.whole();
  if (n < 0 || static_cast<std::uint64_t>(n) > bytes.size()) return std::nullopt;
  std::vector<GroupGap> where(static_cast<std::size_t>(n));
  for (GroupGap& g : where) {
    g.group.test = static_cast<Test>(in.whole()), g.group.sigma3 = in.real(), g.group.part = static_cast<Part>(in.whole());
    g.feature = in.text(), g.text = in.text();
    g.shift_pct = in.real(), g.z = in.real(), g.p = in.real(), g.p_adjusted = in.real();
  }
  if (!in.whole_read()) return std::nullopt;
  return where;
}

}  // namespace regolab::gap
