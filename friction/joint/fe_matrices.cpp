#include "friction/joint/fe_matrices.hpp"

#include <array>
#include <vector>

namespace jointid::friction {
namespace {

std::vector<double> bar(const Member& m) {
  const double k = m.stiffness / m.length;
  return {k, -k, -k, k};
}

std::vector<double> beam(const Member& m) {
  const double l = m.length, k = m.stiffness / (l * l * l);
  return {12 * k,     6 * l * k,     -12 * k,    6 * l * k,      //
          6 * l * k,  4 * l * l * k, -6 * l * k, 2 * l * l * k,  //
          -12 * k,    -6 * l * k,    12 * k,     -6 * l * k,     //
          6 * l * k,  2 * l * l * k, -6 * l * k, 4 * l * l * k};
}

}  // namespace

Eigen::SparseMatrix<double> member_matrix(const JointMesh& mesh) {
  const int stride = mesh.kind == MemberKind::bar ? 1 : 2, size = 2 * stride;
  std::vector<Eigen::Triplet<double>> entries = {{0, 0, mesh.end_spring}};
  for (std::size_t i = 0; i < mesh.members.size(); ++i) {
    const auto block = mesh.kind == MemberKind::bar ? bar(mesh.members[i]) : beam(mesh.members[i]);
    const int first = static_cast<int>(i) * stride;
    for (int r = 0; r < size; ++r) {
      for (int c = 0; c < size; ++c) entries.emplace_back(first + r, first + c, block[static_cast<std::size_t>(r * size + c)]);
    }
  }
  const auto rows = static_cast<Eigen::Index>(mesh.members.size() + 1) * stride;
  Eigen::SparseMatrix<double> matrix(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double tributary_length(const JointMesh& mesh, std::size_t node) {
  double length = 0.0;
  if (node > 0 && mesh.interface[node - 1]) length += 0.5 * mesh.members[node - 1].length;
  if (node + 1 < mesh.interface.size() && mesh.interface[node + 1]) length += 0.5 * mesh.members[node].length;
  return length;
}

}  // namespace jointid::friction
