#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"

namespace jointid::virtualpoint {

using Vector = std::array<double, 3>;

/// How an interface moves: the displacement field of a point at r = (x, y, z) from the virtual point, for a coordinate of 1.
/// Rigid are ux: (1,0,0) … and rx: (0,−z,y), ry: (z,0,−x), rz: (−y,x,0). Flexible are the extensions ex: (x,0,0) …, the torsions
/// tx: (0,−xz,xy), ty: (yz,0,−xy), tz: (−yz,xz,0), and the skewings sxy: (xy,0,0), sxz: (xz,0,0), syz: (0,yz,0), syx: (0,xy,0),
/// szx: (0,0,xz), szy: (0,0,yz). Source: pyFBS, class VPT (Bregar et al., J. Open Source Software 7 (2022) 3399); the rigid ones:
/// van der Seijs et al., Proc. ISMA 2013.
enum class InterfaceMode : std::uint8_t { ux, uy, uz, rx, ry, rz, ex, ey, ez, tx, ty, tz, sxy, sxz, syz, syx, szx, szy };

/// "ux", "uy", …, in the order of the enumerators.
const std::vector<std::string>& mode_names();

/// All six rigid ones, or those of the plane "XY", "YZ" or "XZ": two translations and the rotation about its normal.
std::vector<InterfaceMode> rigid_modes();
std::vector<InterfaceMode> plane_modes(const std::string& plane);

/// The displacement field at r, m per unit of the coordinate.
Vector displacement(InterfaceMode mode, const Vector& r);

/// The rotation of the interface by a mode: of the rigid rotations their axis, else 0, as in pyFBS.
Vector rotation(InterfaceMode mode);

/// The DOF that stands for a mode of virtual point `number`. Rigid modes are VP1:+X … VP1:+RZ, extensions and torsions VP1E:+X
/// (ex) … VP1E:+RZ (tz), skewings VP1S:+X, +RX (sxy, sxz), +Y, +RY (syz, syx), +Z, +RZ (szx, szy).
frf::Dof dof_of(InterfaceMode mode, std::int64_t number);

}  // namespace jointid::virtualpoint
