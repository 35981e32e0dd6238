/// A bed and its force chains as VTK PolyData (.vtp), read by ParaView. Appended raw data, 64-bit floats, SI.
#pragma once
#include <string>

#include "worker/stage/run_stage.h"

namespace regolab {

/// One vertex per sphere, at its centre [m]. Point arrays: radius [m], cluster (0-based), velocity [m/s],
/// contacts (number, walls included). In ParaView: Glyph or Point Gaussian, scaled by radius.
std::string bed_vtp(const BedView& bed);

/// One line per contact, from centre to centre, or from the centre to the touched point on a wall [m].
/// Cell arrays: normal_force [N], wall (-1 between spheres, else the wall's number).
std::string contacts_vtp(const BedView& bed);

}  // namespace regolab
