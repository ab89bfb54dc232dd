#include "problems/solid/solid_matrices.hpp"

#include <array>
#include <utility>
#include <vector>

namespace jointid::problems {

models::StructureMatrices solid_matrices(const Solid& solid, const Block& block) {
  std::array<double, 3> edge{};
  for (std::size_t i = 0; i < 3; ++i) edge[i] = block.size[i] / block.elements[i];
  const Matrix stiffness = brick_stiffness(solid, edge), mass = brick_mass(solid, edge);
  const auto node = [&](int i, int j, int k) { return static_cast<int>(block.node(i, j, k) - block.first_node); };
  std::vector<Eigen::Triplet<double>> k_elements, m_elements;
  for (int k = 0; k < block.elements[2]; ++k) {
    for (int j = 0; j < block.elements[1]; ++j) {
      for (int i = 0; i < block.elements[0]; ++i) {
        const std::array<int, 8> nodes = {node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
                                          node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
        for (std::size_t a = 0; a < 24; ++a) {
          for (std::size_t b = 0; b < 24; ++b) {
            const int row = 3 * nodes[a / 3] + static_cast<int>(a % 3), column = 3 * nodes[b / 3] + static_cast<int>(b % 3);
            k_elements.emplace_back(row, column, 0.5 * (stiffness[a][b] + stiffness[b][a]));
            m_elements.emplace_back(row, column, 0.5 * (mass[a][b] + mass[b][a]));
          }
        }
      }
    }
  }
  const int n = 3 * (block.elements[0] + 1) * (block.elements[1] + 1) * (block.elements[2] + 1);
  models::StructureMatrices out;
  for (auto [to, from] : {std::pair(&out.stiffness, &k_elements), std::pair(&out.mass, &m_elements)}) {
    to->resize(n, n);
    to->setFromTriplets(from->begin(), from->end());
  }
  return out;
}

}  // namespace jointid::problems
