#include "cross_code/lammps_run.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "support/small_world.h"

namespace regolab::test {
namespace {

constexpr double kDensity = 2930;   // [kg/m3]
constexpr double kHeadroom = 0.05;  // [m] above the bed, for grains that fly up

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::string command_for(const Setting& setting, const std::filesystem::path& directory) {
  // Debian's lmp is linked with Open MPI, which asks root to say so
  std::string command = "cd '" + directory.string() +
                        "' && OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 lmp -log none"
                        " -in '" REGOLAB_CROSS_CODE "/bed.lammps' -var data bed.data -var dump states.txt";
  const auto add = [&](const char* name, double value) {
    char text[80];
    std::snprintf(text, sizeof text, " -var %s %.17g", name, value);
    command += text;
  };
  add("dt", setting.dt);
  add("steps", static_cast<double>(setting.steps));
  add("every", static_cast<double>(setting.every));
  add("gravity", setting.gravity);
  add("kn", setting.law.normal_stiffness);
  add("kt", setting.law.tangential_stiffness);
  add("eta", setting.law.normal_damping);
  add("ratio", setting.law.tangential_damping / setting.law.normal_damping);
  add("mu", setting.law.friction);
  add("side_mu", setting.side_friction);
  return command + " >output.txt 2>&1";
}

/// The velocity of the centre of mass, from those of the spheres: spheres weigh as their volumes.
Vec3 mean_velocity(const std::vector<Vec3>& velocity, const std::vector<double>& radius) {
  Vec3 sum{};
  double volume = 0;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double share = radius[i] * radius[i] * radius[i];
    sum = sum + share * velocity[i];
    volume += share;
  }
  return (1 / volume) * sum;
}

/// One frame of the dump: spheres sorted by id, so in the order of `like`.
bool read_frame(std::istream& dump, const GrainBed& like, double dt, State& state) {
  std::string line;
  long step = 0;
  for (int i = 0; i < 9; ++i) {  // ITEM: TIMESTEP, its value, ... ITEM: ATOMS
    if (!std::getline(dump, line)) return false;
    if (i == 1) step = std::atol(line.c_str());
  }
  state.time = dt * static_cast<double>(step);
  state.bed = like;
  for (Grain& grain : state.bed.grains) {
    std::vector<Vec3> velocity(grain.radius.size());
    for (std::size_t i = 0; i < grain.radius.size(); ++i) {
      long id;
      Vec3 &c = grain.centre[i], &v = velocity[i], &w = grain.spin;
      dump >> id >> c[0] >> c[1] >> c[2] >> v[0] >> v[1] >> v[2] >> w[0] >> w[1] >> w[2];
    }
    grain.velocity = mean_velocity(velocity, grain.radius);
  }
  std::getline(dump, line);  // the end of the last row
  return static_cast<bool>(dump);
}

/// Adds the floor's force, from the rows "step force" that the output has once per state.
void read_floor_force(const std::string& output, double dt, std::vector<State>& states) {
  std::istringstream lines(output);
  std::string line;
  while (std::getline(lines, line)) {
    long step;
    double force;
    char more;
    if (std::sscanf(line.c_str(), "%ld %lf %c", &step, &force, &more) != 2) continue;
    for (State& state : states) {
      if (std::abs(state.time - dt * static_cast<double>(step)) < 0.5 * dt) state.floor_force = force;
    }
  }
}

/// Our velocities stand half a step behind; what is compared stands at whole steps. Spins would change by less than is told.
GrainBed at_whole_step(const World& world) {
  GrainBed bed = grains_of(world);
  for (std::size_t i = 0; i < bed.grains.size(); ++i) {
    const dem::Bodies& b = world.bodies;
    const Vec3 force{b.load[i].fx, b.load[i].fy, b.load[i].fz - b.mass[i] * world.gravity};
    bed.grains[i].velocity = bed.grains[i].velocity + (0.5 * world.dt * b.inverse_mass[i]) * force;
  }
  return bed;
}

World world_for(const GrainBed& start, const Setting& setting) {
  World world = empty_world(setting.law);
  GrainBed behind = start;
  for (Grain& grain : behind.grains) grain.velocity[2] += 0.5 * setting.dt * setting.gravity;  // half a step back
  add_grains(behind, kDensity, world);
  add_wall(world, dem::kLeft, 0, setting.side_friction);
  add_wall(world, dem::kRight, start.length, setting.side_friction);
  add_wall(world, dem::kFront, 0, setting.side_friction);
  add_wall(world, dem::kBack, start.width, setting.side_friction);
  add_wall(world, dem::kFloor, 0, setting.law.friction);
  world.gravity = setting.gravity;
  world.dt = setting.dt;
  world.skin = 4e-4;
  return world;
}

}  // namespace

bool lammps_is_installed() { return std::system("command -v lmp >/dev/null 2>&1") == 0; }

Result<std::vector<State>> run_lammps(const GrainBed& start, const Setting& setting,
                                      const std::filesystem::path& directory) {
  std::ofstream(directory / "bed.data") << to_lammps_data(start, kDensity, kHeadroom);
  const int ended = std::system(command_for(setting, directory).c_str());
  const std::string output = text_of(directory / "output.txt");
  if (ended != 0)
    return Error{Code::kInternal,
                 "LAMMPS ended with an error: " + output.substr(output.size() - std::min<std::size_t>(output.size(), 800))};
  std::ifstream dump(directory / "states.txt");
  std::vector<State> states;
  for (State state; read_frame(dump, start, setting.dt, state);) states.push_back(state);
  if (states.size() != static_cast<std::size_t>(setting.steps / setting.every) + 1) {
    return Error{Code::kDataLoss, "LAMMPS left too few states: " + output};
  }
  read_floor_force(output, setting.dt, states);
  return states;
}

std::vector<State> run_ours(const GrainBed& start, const Setting& setting) {
  World world = world_for(start, setting);
  dem::compute_forces(world);
  std::vector<State> states{{.bed = start}};
  for (long done = 0; done < setting.steps; done += setting.every) {
    double force = 0;
    for (long i = 0; i < setting.every; ++i) {
      dem::step(world);
      force += world.walls[dem::kFloor].force / static_cast<double>(setting.every);
    }
    states.push_back(
        {.time = setting.dt * static_cast<double>(done + setting.every), .bed = at_whole_step(world), .floor_force = force});
  }
  return states;
}

}  // namespace regolab::test
