/// A job's row as columns in one order, read the same way by the writer at start and by readers.
#pragma once
#include "store/database.h"
#include "vocab/job.h"

namespace regolab {

#define REGOLAB_JOB_COLUMNS                                                                                                 \
  "j.id, j.stage_key, j.stage, j.parent, j.seed, j.confining_stress_pa, j.friction_angle_rad, j.normal_stiffness_n_per_m, " \
  "j.normal_damping, j.tangential_stiffness_n_per_m, j.tangential_damping, j.largest_diameter_m, j.particle_kind, "         \
  "j.rotation, j.damping_is_ratio, j.grain_density_kg_per_m3, j.gravity_m_per_s2, j.clusters, j.box_length_m, "             \
  "j.box_width_m, j.settle_stiffness_number, j.stress_stiffness_number, j.mass_floor, j.step_fraction, j.inertial_number, " \
  "j.axial_strain, j.state, j.lease_token, j.worker, j.attempts, j.deaths, j.deaths_anywhere, j.death_steps, j.detail, "    \
  "j.bed, j.checkpoint, r.stage_end, r.wall_s, r.steps, j.most_damping_ratio, j.plate_width_m, j.plate_thickness_m, j.effects, " \
  "j.isotropic_servo_steps"

inline constexpr int kJobColumns = 44;

/// `first` = index of the first of REGOLAB_JOB_COLUMNS; `r` is a LEFT JOIN of result.
JobRecord read_job(const Statement& row, int first);

}  // namespace regolab
