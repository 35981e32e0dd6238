#include "input/blocks.h"

#include <algorithm>
#include <cmath>

#include "input/field_value.h"
#include "input/number_text.h"
#include "vocab/canonical.h"
#include "vocab/profile.h"
#include "vocab/units.h"

namespace regolab {
namespace {

constexpr double kArticleStresses[] = {1250, 2500, 5000, 10000};  // sigma3 [Pa], article Sec. 3.1.5
constexpr std::size_t kMostStresses = 20;
constexpr double kArticlePlates[] = {0.003, 0.005, 0.010};  // thickness [m], article Sec. 4.2
constexpr double kArticlePlateWidth = 0.030;                // [m]
constexpr std::size_t kMostPlates = 20;

void ignore(Settings&, double) {}

constexpr Field kSigma3{.name = "sigma3",
                        .si = "Pa",
                        .what = "stress",
                        .low = 1,
                        .high = 1e6,
                        .usual = "the article uses 1.25 to 10 kPa",
                        .set = ignore};
constexpr Field kBoxSide{.name = "side",
                         .si = "m",
                         .what = "length",
                         .low = 2e-5,
                         .high = 100,
                         .usual = "leave `box` out to have it follow L_S",
                         .set = ignore};

constexpr Field kPlateEdge{.name = "plate",
                           .si = "m",
                           .what = "length",
                           .low = 1e-5,
                           .high = 10,
                           .usual = "the article's plates are 3, 5 and 10 mm thick and 30 mm wide",
                           .set = ignore};

std::vector<double> read_sigma3(const YamlNode& list, Report& report) {
  std::vector<double> stresses;
  if (!list.is_list() || list.items.empty() || list.items.size() > kMostStresses) {
    report.add(list.place, "stress.sigma3 (must be a list of 1 to " + std::to_string(kMostStresses) +
                               " pressures) write e.g. [1.25 kPa, 10 kPa]");
    return stresses;
  }
  for (const YamlNode& item : list.items) {
    const auto stress = read_field(kSigma3, item, "", "stress.sigma3", report);
    if (!stress) continue;
    const auto same = [&](double other) { return std::round(other) == std::round(*stress); };  // ids name whole pascals
    if (std::ranges::any_of(stresses, same)) {
      report.add(item.place,
                 "stress.sigma3: " + excerpt(item.text) + " stands twice (each pressure is measured once) remove one");
    }
    stresses.push_back(*stress);
  }
  std::ranges::sort(stresses);
  return stresses;
}

std::vector<double> read_thicknesses(const YamlNode& list, Report& report) {
  std::vector<double> thicknesses;
  if (!list.is_list() || list.items.empty() || list.items.size() > kMostPlates) {
    report.add(list.place, "penetration.plates (must be a list of 1 to " + std::to_string(kMostPlates) +
                               " thicknesses) write e.g. [3 mm, 10 mm]");
    return thicknesses;
  }
  for (const YamlNode& item : list.items) {
    const auto thickness = read_field(kPlateEdge, item, "", "penetration.plates", report);
    if (!thickness) continue;
    const auto same = [&](double other) { return plate_text({0, other}) == plate_text({0, *thickness}); };
    if (std::ranges::any_of(thicknesses, same)) {
      report.add(item.place,
                 "penetration.plates: " + excerpt(item.text) + " stands twice (each plate is pushed in once) remove one");
    }
    thicknesses.push_back(*thickness);
  }
  std::ranges::sort(thicknesses);
  return thicknesses;
}

std::vector<PlateSize> read_plates(MapReader& top, Report& report) {
  double width = kArticlePlateWidth;
  std::vector<double> thicknesses(std::begin(kArticlePlates), std::end(kArticlePlates));
  if (const YamlNode* node = top.get("penetration")) {
    MapReader block(*node, "penetration", report);
    if (const YamlNode* list = block.get("plates")) thicknesses = read_thicknesses(*list, report);
    if (const YamlNode* given = block.get("width")) {
      width = read_field(kPlateEdge, *given, "", "penetration.width", report).value_or(width);
    }
    block.finish();
  }
  std::vector<PlateSize> plates;
  for (const double thickness : thicknesses) plates.push_back({.width = width, .thickness = thickness});
  return plates;
}

std::string centimetres(double metres) { return number_text(metres * door_unit("m").factor) + " cm"; }

bool asks_for(const std::vector<std::size_t>& tests, std::string_view name) {
  return std::ranges::any_of(tests, [&](std::size_t i) { return kTestNames[i] == name; });
}

}  // namespace

std::string read_profile(MapReader& top, const std::string& override_name, Numerics& numerics, Report& report) {
  std::string name = "quick";
  if (const YamlNode* node = top.get("profile")) {
    if (const auto index = read_name(*node, kProfileNames, "profile", report)) name = kProfileNames[*index];
  }
  if (!override_name.empty()) name = override_name;
  const auto found = profile(name);
  if (!found) {
    YamlNode given{.kind = YamlNode::Kind::kScalar, .place = {}, .text = name};
    (void)read_name(given, kProfileNames, "profile", report);  // words the error
  }
  numerics = found.value_or(Numerics{});
  return name;
}

Tests read_tests(MapReader& top, Report& report) {
  std::vector<std::size_t> wanted;
  const YamlNode* tests = top.get("tests");
  if (tests == nullptr) {
    wanted = {3, 4};
  } else if (!tests->is_list() || tests->items.empty()) {
    report.add(tests->place, "tests (must be a list) write e.g. [settle, repose, stress]");
  } else {
    for (const YamlNode& item : tests->items) {
      if (const auto index = read_name(item, kTestNames, "tests", report)) wanted.push_back(*index);
    }
  }
  Tests read{.repose = asks_for(wanted, "repose")};
  std::vector<double> stresses(std::begin(kArticleStresses), std::end(kArticleStresses));
  if (const YamlNode* node = top.get("stress")) {
    MapReader stress(*node, "stress", report);
    if (const YamlNode* list = stress.need("sigma3", "sigma3: [1.25 kPa, 10 kPa]")) stresses = read_sigma3(*list, report);
    stress.finish();
  }
  if (asks_for(wanted, "stress")) read.confining_stresses = std::move(stresses);
  std::vector<PlateSize> plates = read_plates(top, report);
  if (asks_for(wanted, "penetration")) read.plates = std::move(plates);
  return read;
}

void read_box(MapReader& top, Numerics& numerics, Report& report) {
  const YamlNode* node = top.get("box");
  if (node == nullptr) return;
  MapReader box(*node, "box", report);
  const YamlNode* length = box.need("length", "length: 3.63 cm");
  const YamlNode* width = box.need("width", "width: 2.18 cm");
  if (length != nullptr) numerics.box_length = read_field(kBoxSide, *length, "", "box.length", report).value_or(0);
  if (width != nullptr) numerics.box_width = read_field(kBoxSide, *width, "", "box.width", report).value_or(0);
  box.finish();
}

std::vector<std::string_view> read_numerics(MapReader& top, Settings& settings, Report& report) {
  std::vector<std::string_view> set;
  const auto read = [&](const Field& field, MapReader& block) {
    const YamlNode* value = block.get(field.name);
    if (value == nullptr) return;
    set.push_back(field.name);
    if (const auto si = read_field(field, *value, "", block.path_of(field.name), report)) field.set(settings, *si);
  };
  read(*find_field("particles"), top);
  const YamlNode* node = top.get("numerics");
  if (node == nullptr) return set;
  MapReader block(*node, "numerics", report);
  for (const Field& field : all_fields()) {
    if (field.group == Field::Group::kNumerics) read(field, block);
  }
  block.finish();
  return set;
}

std::vector<std::string_view> read_effects(MapReader& top, Settings& settings, Report& report) {
  std::vector<std::string_view> set;
  const YamlNode* node = top.get("effects");
  if (node == nullptr) return set;
  MapReader block(*node, "effects", report);
  for (const Field& field : all_fields()) {
    if (field.group != Field::Group::kEffect) continue;
    const YamlNode* value = block.get(field.name);
    if (value == nullptr) continue;
    set.push_back(field.name);
    if (const auto si = read_field(field, *value, "", block.path_of(field.name), report)) field.set(settings, *si);
  }
  block.finish();
  return set;
}

DampingUnit read_damping_unit(MapReader& block, Report& report) {
  const YamlNode* node = block.get("damping_unit");
  if (node == nullptr) return DampingUnit::kAbsolute;
  const auto index = read_name(*node, kDampingNames, block.path_of("damping_unit"), report);
  return index == 1 ? DampingUnit::kRatio : DampingUnit::kAbsolute;
}

std::string box_problem(const Settings& settings) {
  const double least = 2 * settings.micro.largest_diameter;
  const double length = settings.numerics.box_length;
  const double width = settings.numerics.box_width;
  if ((length == 0 || length >= least) && (width == 0 || width >= least)) return {};
  return "box " + centimetres(length) + " x " + centimetres(width) + " (each side must hold two of the largest particles, here " + centimetres(least) +
         ") widen it, or leave `box` out to have it follow L_S";
}

std::string plate_problem(const Settings& settings, const std::vector<PlateSize>& plates) {
  const double room = 2 * 0.6 * settings.micro.largest_diameter;  // diameters are uniform in [L_S/5, L_S]
  const Base base = base_of({.micro = settings.micro, .numerics = settings.numerics});
  for (const PlateSize& plate : plates) {
    if (plate.width + room <= base.length && plate.thickness + room <= base.width) continue;
    return "plate " + centimetres(plate.width) + " x " + centimetres(plate.thickness) + " in a box " + centimetres(base.length) + " x " +
           centimetres(base.width) + " (at each side a particle of mean size, here " + centimetres(0.5 * room) +
           ", needs room) widen the box, or take a smaller plate";
  }
  return {};
}

}  // namespace regolab
