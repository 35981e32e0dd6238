#include "client/blind/pace.h"

#include <fmt/format.h>

namespace regolab::client {
namespace {

std::string duration(double seconds) {
  if (seconds >= 5400) return fmt::format("{:.1f} h", seconds / 3600);
  return seconds >= 90 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.0f} s", seconds);
}

}  // namespace

std::string Pace::text_after(double seconds) const {
  const std::string share = fmt::format("{} of {} done", done_, to_do_);
  if (done_ == 0 || seconds <= 0) return share;
  const double each = seconds / static_cast<double>(done_);
  const std::string pace = fmt::format("{}, {:.3g} cases/h", share, 3600 / each);
  return done_ == to_do_ ? pace : fmt::format("{}, about {} left", pace, duration(each * static_cast<double>(to_do_ - done_)));
}

}  // namespace regolab::client
