#include "input/unit_convert.h"

#include <udunits2.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <mutex>

#include "input/report.h"

namespace regolab {
namespace {

struct UnitDeleter {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct ConverterDeleter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, UnitDeleter>;
using Converter = std::unique_ptr<cv_converter, ConverterDeleter>;

std::mutex& library_mutex() {  // UDUNITS keeps its parser and its error state in globals
  static std::mutex mutex;
  return mutex;
}

/// The unit database of package libudunits2-data, read once; null when it is not there. Lives as long as the program.
ut_system* unit_system() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);  // errors are ours to word
    return ut_read_xml(nullptr);
  }();
  return system;
}

Unit parse_unit(std::string_view text) {
  constexpr std::size_t kLongestUnit = 40;
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  const bool scaled = !text.empty() && text.front() >= '0' && text.front() <= '9' && text != "1" && !text.starts_with("1/");
  if (text.empty() || text.size() > kLongestUnit || scaled) return nullptr;  // "5 10 m" is a slip, not a unit
  std::string name(text);
  if (text == "deg") name = "degree";  // two writings people use that UDUNITS does not know
  if (text == "Ns/m") name = "N s/m";
  return Unit(ut_parse(unit_system(), name.c_str(), UT_UTF8));
}

/// UDUNITS takes the radian for a pure number; people who write degrees for a ratio made a mistake.
bool is_angle(const ut_unit* unit) {
  char text[256];
  const int length = ut_format(unit, text, sizeof text, UT_ASCII | UT_DEFINITION);
  return length > 0 && static_cast<std::size_t>(length) < sizeof text &&
         std::string_view(text).find("rad") != std::string_view::npos;
}

/// Same dimension, neither inverted (UDUNITS would turn seconds into hertz) nor angle for number.
bool same_dimension(const ut_unit* a, const ut_unit* b) {
  const Unit ratio(ut_divide(a, b));
  return ratio && ut_is_dimensionless(ratio.get()) != 0 && is_angle(a) == is_angle(b) && ut_are_convertible(a, b) != 0;
}

constexpr struct {
  const char* si;
  const char* name;
} kDimensions[] = {
    {"rad", "an angle"},
    {"1", "a pure number"},
    {"m", "a length"},
    {"kg", "a mass"},
    {"s", "a time"},
    {"N", "a force"},
    {"N/m", "a stiffness"},
    {"N s/m", "a damping constant"},
    {"Pa", "a stress"},
    {"kg/m3", "a density"},
    {"m/s2", "an acceleration"},
    {"m/s", "a velocity"},
    {"J", "an energy"},
    {"1/s", "a rate"},
    {"m2", "an area"},
    {"m3", "a volume"},
    {"K", "a temperature"},
    {"W", "a power"},
    {"N/m3", "a force per volume"},
    {"rad/s", "an angular velocity"},
};

std::string dimension_name(const ut_unit* unit) {
  for (const auto& [si, name] : kDimensions) {
    const Unit known(ut_parse(unit_system(), si, UT_ASCII));
    if (known && same_dimension(unit, known.get())) return name;
  }
  return "another kind of quantity";
}

/// " (case counts) write kPa" for KPA; MPA may be meant as either, so no unit is guessed.
std::string case_remedy(std::string_view unit) {
  constexpr std::string_view kKnown[] = {"Pa", "kPa", "MPa", "g/cm3", "kg/m3", "deg", "rad", "mm", "cm", "m", "N", "kN", "s", "g", "kg"};
  const auto same = [&](std::string_view known) {
    return std::equal(unit.begin(), unit.end(), known.begin(), known.end(), [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
  };
  const auto found = std::find_if(std::begin(kKnown), std::end(kKnown), same);
  return found == std::end(kKnown) ? "" : " (case counts) write " + std::string(*found);
}

}  // namespace

Result<double> convert_to_si(double value, std::string_view written, std::string_view unit, std::string_view si,
                             std::string_view what) {
  const std::lock_guard lock(library_mutex());
  if (unit_system() == nullptr) {
    return Error{Code::kFailedPrecondition,
                 "no unit database (udunits2.xml could not be read) install package libudunits2-data"};
  }
  const Unit from = parse_unit(unit);
  const std::string wanted = "expected " + std::string(si == "1" ? "a pure number" : si) + " (" + std::string(what) + ")";
  if (!from) return invalid("unknown unit '" + excerpt(unit) + "', " + wanted + case_remedy(unit));
  const Unit to(ut_parse(unit_system(), std::string(si).c_str(), UT_ASCII));
  if (!same_dimension(from.get(), to.get())) {
    return invalid(excerpt(written) + " is " + dimension_name(from.get()) + ", " + wanted);
  }
  const Converter converter(ut_get_converter(from.get(), to.get()));
  const double converted = converter ? cv_convert_double(converter.get(), value) : NAN;
  if (!std::isfinite(converted)) return invalid(excerpt(written) + " (too large to convert), " + wanted);
  return converted;
}

}  // namespace regolab
