#include "problems/structure/structure.hpp"

#include <utility>

#include "base/error.hpp"

namespace jointid::problems {
namespace {

std::vector<frf::Dof> without(std::vector<frf::Dof> dofs, std::size_t index) {
  dofs.erase(dofs.begin() + static_cast<std::ptrdiff_t>(index));
  return dofs;
}

Matrix dense(const Structure& structure, Kind kind) {
  const std::size_t n = structure.size();
  Matrix result(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) result[i][j] = structure.matrix(kind)[i * n + j];
  }
  return result;
}

void require_distinct(const std::vector<frf::Dof>& dofs) {
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    if (frf::find_coordinate(dofs, dofs[i]) == i && dofs[i].sign == 1) continue;
    throw InputError({.kind = ErrorKind::usage,
                      .file = {},
                      .place = "structure",
                      .problem = "DOF " + dofs[i].name() + " appears twice or has a minus sign",
                      .remedy = "number the nodes of all parts differently"});
  }
}

}  // namespace

Matrix scaled(Matrix matrix, double factor) {
  for (std::vector<double>& row : matrix) {
    for (double& value : row) value *= factor;
  }
  return matrix;
}

Structure::Structure(std::vector<frf::Node> nodes, std::vector<frf::Dof> dofs)
    : nodes_(std::move(nodes)), dofs_(std::move(dofs)) {
  require_distinct(dofs_);
  for (std::vector<double>& matrix : matrices_) matrix.assign(size() * size(), 0.0);
}

std::size_t Structure::index(const frf::Dof& dof) const {
  const std::size_t found = frf::find_coordinate(dofs_, dof);
  if (found != frf::npos) return found;
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "structure",
                    .problem = "it has no DOF " + dof.name(),
                    .remedy = "use one of its " + std::to_string(size()) + " DOFs"});
}

void Structure::add(Kind kind, const std::vector<frf::Dof>& at, const Matrix& element) {
  std::vector<double>& matrix = matrices_[static_cast<std::size_t>(kind)];
  std::vector<std::size_t> place;
  for (const frf::Dof& dof : at) place.push_back(index(dof));
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (std::size_t j = 0; j < at.size(); ++j) {
      matrix[place[i] * size() + place[j]] += at[i].sign * at[j].sign * element[i][j];
    }
  }
}

void Structure::add(Kind kind, const restrictions::Spring& spring, double value) {
  if (spring.second) {
    add(kind, {spring.first, *spring.second}, {{value, -value}, {-value, value}});
  } else {
    add(kind, {spring.first}, {{value}});
  }
}

void Structure::add_proportional_damping(double loss_factor) {
  std::vector<double>& damping = matrices_[static_cast<std::size_t>(Kind::hysteretic_damping)];
  for (std::size_t i = 0; i < damping.size(); ++i) damping[i] += loss_factor * matrix(Kind::stiffness)[i];
}

Structure merged(const Structure& a, const Structure& b) {
  std::vector<frf::Node> nodes = a.nodes();
  nodes.insert(nodes.end(), b.nodes().begin(), b.nodes().end());
  std::vector<frf::Dof> dofs = a.dofs();
  dofs.insert(dofs.end(), b.dofs().begin(), b.dofs().end());
  Structure result(std::move(nodes), std::move(dofs));
  for (const Kind kind : restrictions::all_kinds) {
    result.add(kind, a.dofs(), dense(a, kind));
    result.add(kind, b.dofs(), dense(b, kind));
  }
  return result;
}

Structure tied(const Structure& structure, const frf::Dof& kept, const frf::Dof& removed) {
  const std::size_t gone = structure.index(removed);
  std::vector<frf::Dof> renamed = structure.dofs();
  renamed[gone] = structure.dofs()[structure.index(kept)];
  Structure result(structure.nodes(), without(structure.dofs(), gone));
  for (const Kind kind : restrictions::all_kinds) result.add(kind, renamed, dense(structure, kind));
  return result;
}

}  // namespace jointid::problems
