/// The article's eight microscopic parameters and what is fixed beside them [article Sec. 2.1, 3.1.1, Table 2]. SI.
#pragma once

namespace regolab {

/// N_E: spheres per cluster; 12 stands for the mixture by number, one third each of 2, 4 and 6 [article Table 2].
enum class ParticleKind { kTwo = 2, kFour = 4, kSix = 6, kMixture = 12 };

/// P_RA: random rotation of each cluster about its parent centre after replacement; kXZ turns about x first, then z.
enum class Rotation { kNone = 0, kX = 1, kZ = 2, kXZ = 3 };

/// How eta is read: N s/m as printed, or a fraction of the critical damping of each contact.
enum class DampingUnit { kAbsolute = 0, kRatio = 1 };

struct Micro {
  double friction_angle = 0;          ///< theta_F [rad]
  double normal_stiffness = 0;        ///< K_N [N/m]
  double normal_damping = 0;          ///< eta_N [N s/m, or 1 when damping_unit is kRatio]
  double tangential_stiffness = 0;    ///< K_T [N/m]
  double tangential_damping = 0;      ///< eta_T [N s/m or 1]
  double largest_diameter = 0;        ///< L_S [m]; diameters are uniform by number in [L_S/5, L_S]
  ParticleKind kind = ParticleKind::kSix;       ///< N_E
  Rotation rotation = Rotation::kNone;          ///< P_RA
  DampingUnit damping_unit = DampingUnit::kAbsolute;
  double grain_density = 2930;        ///< rho_P [kg/m3]
  double gravity = 1.63;              ///< magnitude [m/s2]

  bool operator==(const Micro&) const = default;
};

}  // namespace regolab
