#include "friction/joint/joint_mesh.hpp"

#include "base/error.hpp"

namespace jointid::friction {

JointMesh uniform_mesh(MemberKind kind, std::size_t count, const Member& whole, const std::shared_ptr<const Element>& interface) {
  if (count == 0) refuse("finite-element joint: no members");
  JointMesh mesh;
  mesh.kind = kind;
  mesh.members.assign(count, {whole.length / static_cast<double>(count), whole.stiffness});
  mesh.interface.assign(count + 1, interface);
  return mesh;
}

}  // namespace jointid::friction
