/// The list of effects. README of worker/effects says how each law is derived, and why it is this one.
#include "vocab/effects.h"

namespace regolab {
namespace {

constexpr std::string_view kRollingVariants[] = {"elastic_plastic", "iwashita_oda"};
constexpr std::string_view kCohesionVariants[] = {"constant", "jkr"};
constexpr unsigned kTests = acts::kStress | acts::kPenetration;

constexpr EffectInfo kTable[] = {
    {EffectId::kRollingResistance, "rolling_resistance", 1, acts::kEverywhere, "mu_r", "1", 0, 2, 0.02, 0.5, true,
     "rolling spring k_r = 2.25 K_N (mu_r R*)^2, moment at most mu_r R* F_n", "repose and sigma1 up at every sigma3, density down",
     "Ai and others 2011 (EPSD); Luo 2024"},
    {EffectId::kRollingVariant, "rolling_variant", 1, acts::kEverywhere, "law", "1", 0, 1, 0, 1, false,
     "elastic_plastic as above; iwashita_oda: k_r = K_T R*^2 and a dashpot eta_T R*^2 until it rolls", "little besides its strength",
     "Iwashita and Oda 1998", EffectId::kRollingResistance, kRollingVariants},
    {EffectId::kCohesion, "cohesion", 1, acts::kEverywhere, "c* = F_c/d^2", "Pa", 0, 1e5, 20, 20000, true,
     "grains in touch attract with F_c = c* d^2, d = 2 d_a d_b/(d_a + d_b), down to 0 over a gap of 0.02 d",
     "repose up to a cliff, density down, sigma1 up by a constant in Pa", "Rumpf 1962; JSC-1 1.0 kPa, FJS-1 8.0 kPa (article)"},
    {EffectId::kCohesionVariant, "cohesion_variant", 1, acts::kEverywhere, "law", "1", 0, 1, 0, 1, false,
     "constant as above; jkr: F_c sqrt(1 + overlap/(0.02 d)), the neck widens as it is pressed", "little besides its strength",
     "Johnson, Kendall and Roberts 1971, in shape", EffectId::kCohesion, kCohesionVariants},
    {EffectId::kHertzianContact, "hertzian_contact", 1, acts::kEverywhere, "h", "1", 0, 1, 0.05, 1, false,
     "F = K u ((1 - h) + h sqrt(u/u_0)), u_0 the overlap of a mean contact under 5 kPa (bed: its own weight); K_T and dashpots alike",
     "E50 grows with sigma3; strength stays", "Mindlin and Deresiewicz 1953; Mlynarczyk 2023"},
    {EffectId::kWallFriction, "wall_friction", 1, acts::kEverywhere, "mu_w", "1", 0, 2, 0.05, 0.8, true,
     "Coulomb friction of side walls, stress platens, and (where rougher than the grains) the penetration plate",
     "repose and sigma1 up; plate stresses differ", "baseline walls are smooth (protocols, section 2)"},
    {EffectId::kSizeDistribution, "size_distribution", 1, acts::kSettle, "w", "1", -1, 1.3, -1, 1.3, false,
     "diameters d_min + (L_S - d_min) u^(2^w), d_min = L_S/5 2^-w, u uniform: w > 0 finer and wider, w < 0 coarser and narrower",
     "density up and contacts per particle down with w", "Nguyen 2015; Easter 2024"},
    {EffectId::kBoundaryCompliance, "boundary_compliance", 1, acts::kStress, "c", "1", 0, 99, 1, 50, true,
     "the six walls of the stress test have stiffness K/(1 + c), dashpots at the same share of critical",
     "E50 down; more volume taken in at the walls", "Qu and others 2019"},
    {EffectId::kLateralStressOffset, "lateral_stress_offset", 1, acts::kStress, "p_0", "Pa", -5000, 20000, -800, 5000, false,
     "from the start of shear on the side walls hold sigma3 + p_0 (raised with the plate's speed), while sigma3 is reported",
     "sigma1 up by a constant in Pa (K_p p_0)", "Fukushima 1984: a membrane doubles sigma3 at 2 to 5 kPa"},
    {EffectId::kLoadingRate, "loading_rate", 1, kTests, "log10 of the factor", "1", -1, 2, 0.3, 1.5, false,
     "axial strain rate, and plate speed, times 10^x", "sigma1 up, most at low sigma3", "inertial number, da Cruz 2005"},
    {EffectId::kPreparationFriction, "preparation_friction", 1, acts::kSettle, "x", "1", 0, 1, 0.1, 0.9, false,
     "while settling, friction between grains and with the floor times (1 - x)", "density and peak up, residual stays",
     "tapping; Agnolin and Roux 2007"},
    {EffectId::kPreparationGravity, "preparation_gravity", 1, acts::kSettle, "log10 of the ratio", "1", -2, 2, -1, 1, false,
     "the bed falls under g 10^x (K softened for it) and comes to rest under g", "density a little", "variant of preparation"},
    {EffectId::kBreakage, "breakage", 1, acts::kStress, "b = 100 kPa/strength", "1", 0, 1000, 0.1, 50, true,
     "a cluster falls apart into its spheres when a contact presses one of them with more than strength d^2",
     "more volume taken in, peak down at high sigma3", "McDowell and Bolton 1998"},
    {EffectId::kFrameCompliance, "frame_compliance", 1, acts::kStress, "1/k_f", "1/Pa", 0, 5e-5, 1e-7, 5e-6, true,
     "axial strain read as strain + (sigma1 - sigma1 at its start)/k_f", "E50 down, strain at peak up; never density or repose",
     "apparatus; no DEM run"},
    {EffectId::kSeating, "seating", 1, acts::kStress, "x_0", "1", 0, 0.05, 0.001, 0.02, true,
     "axial strain read x_0 too large: the plate travels before it meets the specimen", "a foot at the start of the curve",
     "apparatus; no DEM run"},
    {EffectId::kLoadCellOffset, "load_cell_offset", 1, acts::kStress, "F_0", "Pa", -5000, 20000, -1000, 3000, false,
     "axial stress read as sigma1 + F_0", "sigma1 up by a constant in Pa", "apparatus; no DEM run"},
    {EffectId::kLoadCellGain, "load_cell_gain", 1, acts::kStress, "g", "1", -0.5, 1, -0.1, 0.1, false,
     "axial stress read as (1 + g) sigma1", "sigma1 up by the same share at every sigma3", "apparatus; no DEM run"},
    {EffectId::kGrainDensity, "grain_density", 1, acts::kFabric | kTests, "x", "1", -0.3, 0.3, -0.05, 0.05, false,
     "grains weigh (1 + x) of the density stated: bulk density from their mass, void ratio from the density stated",
     "bulk density up, void ratio down; penetration force in proportion", "article: 2.84 to 3.03 g/cm3"},
};
static_assert(std::size(kTable) == kEffectCount);

}  // namespace

std::span<const EffectInfo> all_effects() { return kTable; }

}  // namespace regolab
