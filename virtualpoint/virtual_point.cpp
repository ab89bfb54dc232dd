#include "virtualpoint/virtual_point.hpp"

namespace jointid::virtualpoint {

std::vector<frf::Dof> dofs(const VirtualPoint& point) {
  std::vector<frf::Dof> out;
  for (const InterfaceMode mode : point.modes) out.push_back(dof_of(mode, point.number));
  return out;
}

std::string name(const VirtualPoint& point) { return "VP" + std::to_string(point.number); }

}  // namespace jointid::virtualpoint
