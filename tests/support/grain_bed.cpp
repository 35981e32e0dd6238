#include "support/grain_bed.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "support/small_world.h"

namespace regolab::test {
namespace {

constexpr const char* kColumns = "cluster,x_m,y_m,z_m,radius_m,vx,vy,vz,wx,wy,wz";

Vec3 centre_of_mass(const Grain& grain) {
  Vec3 sum{};
  double volume = 0;
  for (std::size_t i = 0; i < grain.radius.size(); ++i) {
    const double share = std::pow(grain.radius[i], 3);
    sum = sum + share * grain.centre[i];
    volume += share;
  }
  return (1 / volume) * sum;
}

/// Polar vectors (places, velocities) turn their component across the mirror; axial ones (spins) the two others.
Vec3 mirrored(Vec3 v, std::size_t across, bool axial) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((axis == across) != axial) v[axis] = -v[axis];
  }
  return v;
}

Grain mirrored(const Grain& grain, std::size_t across, double extent) {
  Grain out = grain;
  for (Vec3& centre : out.centre) {
    centre = mirrored(centre, across, false);
    centre[across] += extent;
  }
  out.velocity = mirrored(grain.velocity, across, false);
  out.spin = mirrored(grain.spin, across, true);
  return out;
}

/// Appends numbers, exactly, with `before` ahead of each.
void append(std::string& text, char before, std::initializer_list<double> numbers) {
  char digits[40];
  for (const double number : numbers) {
    std::snprintf(digits, sizeof digits, "%c%.17g", before, number);
    text += digits;
  }
}

bool read_row(const std::string& line, GrainBed& bed) {
  std::istringstream numbers(line);
  double row[11];
  for (double& number : row) {
    if (!(numbers >> number)) return false;
    numbers.ignore();  // the comma
  }
  const auto cluster = static_cast<std::size_t>(row[0]);
  if (cluster != bed.grains.size() && cluster != bed.grains.size() + 1) return false;
  bed.grains.resize(cluster);
  Grain& grain = bed.grains.back();
  grain.centre.push_back({row[1], row[2], row[3]});
  grain.radius.push_back(row[4]);
  grain.velocity = {row[5], row[6], row[7]};
  grain.spin = {row[8], row[9], row[10]};
  return true;
}

}  // namespace

GrainBed grains_of(const dem::World& world) {
  GrainBed bed{.length = world.walls[dem::kRight].position, .width = world.walls[dem::kBack].position};
  const dem::Centres at = dem::sphere_centres(world.bodies, world.spheres);
  for (int body = 0; body < world.bodies.count(); ++body) {
    const auto i = static_cast<std::size_t>(body);
    Grain grain{.velocity = velocity(world, body), .spin = spin(world, body)};
    for (auto s = world.bodies.first_sphere[i]; s < world.bodies.first_sphere[i + 1]; ++s) {
      const auto k = static_cast<std::size_t>(s);
      grain.centre.push_back({at.x[k], at.y[k], at.z[k]});
      grain.radius.push_back(world.spheres.radius[k]);
    }
    bed.grains.push_back(std::move(grain));
  }
  return bed;
}

void add_grains(const GrainBed& bed, double density, dem::World& world) {
  for (const Grain& grain : bed.grains) {
    const int body =
        dem::add_cluster({.centre = grain.centre, .radius = grain.radius, .density = density}, world.bodies, world.spheres);
    set_velocity(world, body, grain.velocity);
    set_spin(world, body, grain.spin);
  }
  world.lists_stale = true;
}

GrainBed tiled(const GrainBed& bed, int along_x, int along_y) {
  GrainBed out{.length = along_x * bed.length, .width = along_y * bed.width};
  for (int i = 0; i < along_x; ++i) {
    for (int j = 0; j < along_y; ++j) {
      for (Grain grain : bed.grains) {
        if (i % 2 == 1) grain = mirrored(grain, 0, bed.length);
        if (j % 2 == 1) grain = mirrored(grain, 1, bed.width);
        for (Vec3& centre : grain.centre) centre = centre + Vec3{i * bed.length, j * bed.width, 0};
        out.grains.push_back(std::move(grain));
      }
    }
  }
  return out;
}

double top_of(const GrainBed& bed) {
  double top = 0;
  for (const Grain& grain : bed.grains) {
    for (std::size_t i = 0; i < grain.radius.size(); ++i) top = std::max(top, grain.centre[i][2] + grain.radius[i]);
  }
  return top;
}

std::string to_csv(const GrainBed& bed) {
  std::string text = "box_m";
  append(text, ',', {bed.length, bed.width});
  text += std::string("\n") + kColumns + "\n";
  for (std::size_t g = 0; g < bed.grains.size(); ++g) {
    const Grain& grain = bed.grains[g];
    const Vec3 &v = grain.velocity, &w = grain.spin;
    for (std::size_t i = 0; i < grain.radius.size(); ++i) {
      const Vec3& c = grain.centre[i];
      text += std::to_string(g + 1);
      append(text, ',', {c[0], c[1], c[2], grain.radius[i], v[0], v[1], v[2], w[0], w[1], w[2]});
      text += '\n';
    }
  }
  return text;
}

Result<GrainBed> from_csv(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  GrainBed bed;
  const Error unusable{Code::kDataLoss, "unusable bed (not a bed's CSV, or cut short) remove it and make the beds again"};
  if (!std::getline(lines, line) || std::sscanf(line.c_str(), "box_m,%lf,%lf", &bed.length, &bed.width) != 2)
    return unusable;
  if (!std::getline(lines, line) || line != kColumns) return unusable;
  while (std::getline(lines, line)) {
    if (!read_row(line, bed)) return unusable;
  }
  if (bed.grains.empty()) return unusable;
  return bed;
}

std::string to_lammps_data(const GrainBed& bed, double density, double headroom) {
  std::size_t spheres = 0;
  for (const Grain& grain : bed.grains) spheres += grain.radius.size();
  std::string text = "bed of rigid clusters, SI\n\n" + std::to_string(spheres) + " atoms\n1 atom types\n\n";
  const auto side = [&](double extent, const char* names) {
    append(text, ' ', {0, extent});
    text += names;
  };
  side(bed.length, " xlo xhi\n");
  side(bed.width, " ylo yhi\n");
  side(top_of(bed) + headroom, " zlo zhi\n\nAtoms # sphere\n\n");
  std::string velocities, molecules;
  int atom = 0;
  for (std::size_t g = 0; g < bed.grains.size(); ++g) {
    const Grain& grain = bed.grains[g];
    const Vec3 centre = centre_of_mass(grain), &w = grain.spin;
    for (std::size_t i = 0; i < grain.radius.size(); ++i) {
      const Vec3& c = grain.centre[i];
      const Vec3 v = grain.velocity + cross(w, c - centre);
      const std::string id = std::to_string(++atom);
      text += id + " 1";
      append(text, ' ', {2 * grain.radius[i], density, c[0], c[1], c[2]});
      text += '\n';
      velocities += id;
      append(velocities, ' ', {v[0], v[1], v[2], w[0], w[1], w[2]});
      velocities += '\n';
      molecules += id + " " + std::to_string(g + 1) + "\n";
    }
  }
  return text + "\nVelocities\n\n" + velocities + "\nMolecules\n\n" + molecules;
}

}  // namespace regolab::test
