/// Curves of a report. The four windows of strain in which features are taken stand for a model's curve.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "client/number_text.h"
#include "client/views/gap_html.h"

namespace regolab::client {
namespace {

constexpr double kWidth = 300, kHeight = 190, kLeft = 42, kRight = 8, kTop = 20, kBottom = 32;  // [px] of a panel
constexpr double kMostStrain = 0.20;
constexpr std::size_t kMostPoints = 160;  // of a measured curve

struct Window {
  std::string_view stem;
  double strain;  ///< its middle
};
constexpr Window kStress[] = {{"sigma1_early_", 0.01}, {"sigma1_rising_", 0.03}, {"sigma1_middle_", 0.075}, {"sigma1_ratio_", 0.175}};
constexpr Window kVolume[] = {{"volumetric_strain_0.05_", 0.05}, {"volumetric_strain_0.10_", 0.10}, {"volumetric_strain_0.19_", 0.19}};

struct Point {
  double x = 0, y = 0, error = 0;
};
using Points = std::vector<Point>;

/// What one panel shows, in the units of its axis.
struct Panel {
  std::string title, what;
  Points measured, base, repaired, base_runs, repaired_runs;
  std::vector<std::pair<double, double>> curve;

  double low() const { return extreme([](double a, double b) { return std::min(a, b); }, -1); }
  double high() const { return extreme([](double a, double b) { return std::max(a, b); }, 1); }

 private:
  template <class Pick>
  double extreme(const Pick& pick, double sign) const {
    double value = measured.front().y;
    for (const Points* points : {&measured, &base, &repaired, &base_runs, &repaired_runs}) {
      for (const Point& p : *points) value = pick(value, p.y + sign * p.error);
    }
    for (const auto& [x, y] : curve) value = pick(value, y);
    return value;
  }
};

/// A round step that divides the range into about four.
double step_of(double range) {
  const double raw = range / 4, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double m : {1.0, 2.0, 5.0}) {
    if (raw <= m * power) return m * power;
  }
  return 10 * power;
}

class Drawing {
 public:
  explicit Drawing(const Panel& panel) : panel_(panel) {
    const double low = panel.low(), high = panel.high(), room = std::max(1e-9, 0.06 * (high - low));
    low_ = low - room, high_ = high + room;
  }

  std::string svg() {
    axes();
    band(panel_.base, "b"), band(panel_.repaired, "r");
    curve();
    line(panel_.base, "b"), line(panel_.repaired, "r");
    diamonds(panel_.base_runs, "b"), diamonds(panel_.repaired_runs, "r");
    for (const Point& p : panel_.measured) {
      out_ += fmt::format("<path class=\"m\" d=\"M{:.1f} {:.1f}V{:.1f}\"/><circle class=\"md\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\"/>", x(p.x), y(p.y - p.error), y(p.y + p.error), x(p.x), y(p.y));
    }
    return fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}</svg>", kWidth, kHeight, html_escaped(panel_.title + ": " + panel_.what), out_);
  }

 private:
  double x(double strain) const { return kLeft + strain / kMostStrain * (kWidth - kLeft - kRight); }
  double y(double value) const { return kHeight - kBottom - (value - low_) / (high_ - low_) * (kHeight - kTop - kBottom); }

  void axes() {
    out_ += fmt::format("<text x=\"{}\" y=\"13\" class=\"t\">{}</text>", kLeft, html_escaped(panel_.title + ", " + panel_.what));
    const double step = step_of(high_ - low_);
    for (double v = std::ceil(low_ / step) * step; v <= high_; v += step) {
      const double shown = std::abs(v) < 1e-9 * step ? 0 : v;
      out_ += fmt::format("<path class=\"g\" d=\"M{:.1f} {:.1f}H{:.1f}\"/><text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.4g}</text>", kLeft, y(v), kWidth - kRight, kLeft - 4, y(v) + 3.5, shown);
    }
    for (int percent = 0; percent <= 20; percent += 5) {
      out_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", x(percent / 100.0), kHeight - kBottom + 13, percent);
    }
    out_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">axial strain, %</text>", 0.5 * (kLeft + kWidth - kRight), kHeight - 5);
  }
  void curve() {
    std::string d;
    for (const auto& [at, value] : panel_.curve) d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", x(at), y(value));
    if (!d.empty()) out_ += "<path class=\"c\" d=\"" + d + "\"/>";
  }
  void line(const Points& points, const char* kind) {
    std::string d;
    for (const Point& p : points) d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", x(p.x), y(p.y));
    if (!d.empty()) out_ += fmt::format("<path class=\"l {}\" d=\"{}\"/>", kind, d);
  }
  void band(const Points& points, const char* kind) {
    std::string d;
    for (const Point& p : points) d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", x(p.x), y(p.y + p.error));
    for (auto p = points.rbegin(); p != points.rend(); ++p) d += fmt::format("L{:.1f} {:.1f}", x(p->x), y(p->y - p->error));
    if (!d.empty()) out_ += fmt::format("<path class=\"f {}\" d=\"{}Z\"/>", kind, d);
  }
  void diamonds(const Points& points, const char* kind) {
    for (const Point& p : points) out_ += fmt::format("<path class=\"d {}\" d=\"M{:.1f} {:.1f}l4 4l-4 4l-4-4Z\"/>", kind, x(p.x), y(p.y) - 4);
  }

  const Panel& panel_;
  double low_ = 0, high_ = 1;
  std::string out_;
};

using ByLevel = std::map<double, std::string>;  // sigma3 [Pa] -> how ids write it

const pb::FittedFeature* find(const google::protobuf::RepeatedPtrField<pb::FittedFeature>& all, const std::string& id) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.id() == id; });
  return found == all.end() ? nullptr : &*found;
}

void add(const pb::Diagnosis& d, std::span<const Window> windows, const std::string& level, double unit, Panel& panel) {
  for (const Window& w : windows) {
    const std::string id = std::string(w.stem) + level;
    if (const auto* f = find(d.fits(), id)) {
      panel.measured.push_back({w.strain, f->measured() * unit, f->measured_error() * unit});
      panel.base.push_back({w.strain, f->base() * unit, f->base_error() * unit});
      if (f->has_repaired()) panel.repaired.push_back({w.strain, f->repaired() * unit, f->repaired_error() * unit});
    }
    if (const auto* f = find(d.shrinkage().features(), id)) {
      panel.base_runs.push_back({w.strain, f->base() * unit, 0});
      if (f->has_repaired()) panel.repaired_runs.push_back({w.strain, f->repaired() * unit, 0});
    }
  }
}

void add_curve(const pb::StoredDiagnosis& stored, const std::string& id, double unit, Panel& panel) {
  for (const auto& curve : stored.curves()) {
    if (curve.id() != id) continue;
    const auto n = static_cast<std::size_t>(std::min(curve.x_si_size(), curve.y_si_size()));
    const std::size_t every = std::max<std::size_t>(1, n / kMostPoints);
    for (std::size_t k = 0; k < n; k += every) {
      const double at = curve.x_si(static_cast<int>(k)), value = curve.y_si(static_cast<int>(k)) * unit;
      if (at >= 0 && at <= kMostStrain && std::isfinite(value)) panel.curve.emplace_back(at, value);
    }
  }
}

}  // namespace

std::string curves_html(const pb::StoredDiagnosis& stored) {
  const pb::Diagnosis& d = stored.diagnosis();
  ByLevel levels;
  for (const auto& f : d.fits()) {
    if (f.sigma3_pa() > 0) levels[f.sigma3_pa()] = f.id().substr(f.id().rfind('_') + 1);
  }
  std::string figures;
  for (const auto& [sigma3, level] : levels) {
    const bool held = d.has_shrinkage() && std::find(d.shrinkage().heldout().begin(), d.shrinkage().heldout().end(), "stress " + level + " kPa") != d.shrinkage().heldout().end();
    const std::string title = level + " kPa" + (held ? " (held out)" : "");
    Panel stress{.title = title, .what = "sigma1 / sigma3"}, volume{.title = title, .what = "contraction, %"};
    add(d, kStress, level, 1000 / sigma3, stress);  // features are in kPa
    add(d, kVolume, level, 100, volume);
    add_curve(stored, "sigma1_at_sigma3_" + level + "kPa", 1 / sigma3, stress);
    add_curve(stored, "volumetric_strain_contraction_positive_at_sigma3_" + level + "kPa", 100, volume);
    std::string pair;
    for (const Panel* panel : {&stress, &volume}) {
      if (!panel->measured.empty()) pair += "<figure>" + Drawing(*panel).svg() + "</figure>";
    }
    if (!pair.empty()) figures += "<div class=pair>" + pair + "</div>";
  }
  if (figures.empty()) return "";
  const bool runs = d.has_shrinkage() && !d.shrinkage().features().empty();
  std::string legend = "<span class=\"key m\">measured</span><span class=\"key b\">re-calibrated base model</span>";
  if (!d.repaired().empty()) legend += "<span class=\"key r\">with " + html_escaped(d.repaired()) + "</span>";
  if (runs) legend += "<span>diamonds: new DEM runs</span>";
  return "<h2>Before and after</h2><p class=\"legend\">" + legend + "</p><div class=\"curves\">" + figures +
         "</div><p class=quiet>Dots: means over windows of strain, as compared, with their errors. Bands: what is left open of the models after the fit (one standard deviation).</p>";
}

}  // namespace regolab::client
