#include "problems/structure/brick.hpp"

#include <cmath>
#include <numbers>

namespace jointid::problems {
namespace {

using Triple = std::array<double, 3>;
constexpr std::size_t corners = 8, brick_dofs = 24;

/// Corners of the cube −1 … 1.
constexpr std::array<Triple, corners> cube = {{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                               {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

Matrix empty_matrix() { return Matrix(brick_dofs, std::vector<double>(brick_dofs)); }

/// Calls add(point) at the Gauss points of the cube, whose weights are 1.
template <class Add>
void for_each_gauss_point(Add add) {
  for (const Triple& corner : cube)
    add({corner[0] / std::numbers::sqrt3, corner[1] / std::numbers::sqrt3, corner[2] / std::numbers::sqrt3});
}

/// N of corner i and its derivative by x, y or z.
double shape(std::size_t i, const Triple& at) {
  return (1.0 + cube[i][0] * at[0]) * (1.0 + cube[i][1] * at[1]) * (1.0 + cube[i][2] * at[2]) / 8.0;
}
double shape_derivative(std::size_t i, std::size_t axis, const Triple& at, const Triple& size) {
  double product = cube[i][axis] / 8.0;
  for (std::size_t other = 0; other < 3; ++other) {
    if (other != axis) product *= 1.0 + cube[i][other] * at[other];
  }
  return product * 2.0 / size[axis];
}

double volume(const Triple& size) { return size[0] * size[1] * size[2]; }

}  // namespace

/// σ_ab = λ δ_ab ε_cc + 2μ ε_ab: element (i a, j b) is ∫ λ N_i,a N_j,b + μ (N_i,b N_j,a + δ_ab N_i,c N_j,c).
Matrix brick_stiffness(const Solid& solid, const Triple& size) {
  const double nu = solid.poissons_ratio;
  const double lambda = solid.youngs_modulus * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  const double mu = solid.youngs_modulus / (2.0 * (1.0 + nu));
  Matrix result = empty_matrix();
  for_each_gauss_point([&](const Triple& at) {
    std::array<Triple, corners> n{};
    for (std::size_t i = 0; i < corners; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) n[i][axis] = shape_derivative(i, axis, at, size);
    }
    for (std::size_t i = 0; i < corners; ++i) {
      for (std::size_t j = 0; j < corners; ++j) {
        const double gradients = n[i][0] * n[j][0] + n[i][1] * n[j][1] + n[i][2] * n[j][2];
        for (std::size_t a = 0; a < 3; ++a) {
          for (std::size_t b = 0; b < 3; ++b) {
            const double density = lambda * n[i][a] * n[j][b] + mu * (n[i][b] * n[j][a] + (a == b ? gradients : 0.0));
            result[3 * i + a][3 * j + b] += density * volume(size) / 8.0;
          }
        }
      }
    }
  });
  return result;
}

Matrix brick_mass(const Solid& solid, const Triple& size) {
  Matrix result = empty_matrix();
  for_each_gauss_point([&](const Triple& at) {
    for (std::size_t i = 0; i < corners; ++i) {
      for (std::size_t j = 0; j < corners; ++j) {
        const double mass = solid.density * shape(i, at) * shape(j, at) * volume(size) / 8.0;
        for (std::size_t a = 0; a < 3; ++a) result[3 * i + a][3 * j + a] += mass;
      }
    }
  });
  return result;
}

namespace {

std::vector<frf::Dof> solid_dofs(std::int64_t node) {
  return {{.node = node, .direction = frf::Direction::x},
          {.node = node, .direction = frf::Direction::y},
          {.node = node, .direction = frf::Direction::z}};
}

/// Calls use(i, j, k) for 0 ≤ i < counts[0] …, i fastest.
template <class Use>
void for_each_place(const std::array<int, 3>& counts, Use use) {
  for (int k = 0; k < counts[2]; ++k) {
    for (int j = 0; j < counts[1]; ++j) {
      for (int i = 0; i < counts[0]; ++i) use(i, j, k);
    }
  }
}

std::vector<frf::Dof> brick_dofs_at(const Block& block, int i, int j, int k) {
  std::vector<frf::Dof> dofs;
  for (const Triple& corner : cube) {
    const auto one = [&](std::size_t axis) { return corner[axis] > 0.0 ? 1 : 0; };
    for (const frf::Dof& dof : solid_dofs(block.node(i + one(0), j + one(1), k + one(2)))) dofs.push_back(dof);
  }
  return dofs;
}

}  // namespace

Structure solid_block(const Solid& solid, const Block& block) {
  const std::array<int, 3>& n = block.elements;
  const Triple edge = {block.size[0] / n[0], block.size[1] / n[1], block.size[2] / n[2]};
  std::vector<frf::Node> nodes;
  std::vector<frf::Dof> dofs;
  for_each_place({n[0] + 1, n[1] + 1, n[2] + 1}, [&](int i, int j, int k) {
    const std::int64_t id = block.node(i, j, k);
    nodes.push_back({.id = id, .position = {block.origin[0] + i * edge[0], block.origin[1] + j * edge[1], block.origin[2] + k * edge[2]}});
    for (const frf::Dof& dof : solid_dofs(id)) dofs.push_back(dof);
  });
  Structure result(std::move(nodes), std::move(dofs));
  const Matrix stiffness = brick_stiffness(solid, edge), mass = brick_mass(solid, edge);
  for_each_place(n, [&](int i, int j, int k) {
    const std::vector<frf::Dof> at = brick_dofs_at(block, i, j, k);
    result.add(Kind::stiffness, at, stiffness);
    result.add(Kind::mass, at, mass);
  });
  return result;
}

}  // namespace jointid::problems
