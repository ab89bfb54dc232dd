#include "friction/joint/joint_mesh.hpp"

#include <stdexcept>
#include <utility>

namespace jointid::friction {

JointMesh uniform_mesh(MemberKind kind, std::size_t count, const Member& whole, std::shared_ptr<const Element> interface) {
  if (count == 0) throw std::invalid_argument("finite-element joint: no members");
  JointMesh mesh;
  mesh.kind = kind;
  mesh.members.assign(count, {whole.length / static_cast<double>(count), whole.stiffness});
  mesh.interface.assign(count + 1, std::move(interface));
  return mesh;
}

}  // namespace jointid::friction
