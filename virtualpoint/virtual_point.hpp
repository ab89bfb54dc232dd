#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"
#include "virtualpoint/interface_mode.hpp"

namespace jointid::virtualpoint {

/// A sensor or an impact at an interface.
struct Channel {
  frf::Dof dof;                       ///< as the scene names it; where the file has the other sign its FRFs are turned round
  std::optional<Vector> direction{};  ///< unit vector in global axes, of the DOF as it is named here; default: that of the DOF
  double weight = 1.0;                ///< > 0, of the square of its residual
};

/// An interface whose motion and loads are those of a few displacement modes, and the channels from which these are found.
struct VirtualPoint {
  std::int64_t number = 1;                     ///< of its name: VP1, VP2, …; 1 to frf::largest_virtual_point
  Vector position{};                           ///< m, global axes: the origin of its modes
  std::vector<InterfaceMode> modes{};          ///< its coordinates, none twice
  std::vector<Channel> sensors{};              ///< responses of a file; none: responses stay as they are
  std::vector<Channel> impacts{};              ///< references of a file
  std::map<std::int64_t, Vector> positions{};  ///< m, of nodes; those of the file count where a node is not here
};

/// Its DOFs, in the order of its modes.
std::vector<frf::Dof> dofs(const VirtualPoint& point);

/// "VP1"
std::string name(const VirtualPoint& point);

}  // namespace jointid::virtualpoint
