#pragma once

#include <Eigen/Core>
#include <vector>

#include "ident/likelihood/line/line_layout.hpp"

namespace jointid::ident {

/// Columns of X of a line in two kinds. No element of D joins two lone ones, such as coordinates without a force of their own: these can
/// be eliminated one by one. The others and Y are the core.
struct ArrowLayout {
  /// An element of D that joins a lone column with one of the core.
  struct Touch {
    std::size_t core, element;
    bool lone_is_second;  ///< its column in D
  };
  struct Lone {
    std::size_t column;
    Eigen::Index first;  ///< among the unknowns of lone columns
    std::vector<Touch> touches;
  };

  std::vector<Lone> lone;
  std::vector<std::size_t> core;         ///< ascending
  std::vector<Eigen::Index> core_first;  ///< [n] in the core; −1: a lone column
  std::vector<std::size_t> core_pairs;   ///< elements of D within the core
  Eigen::Index lone_size = 0, core_x = 0, y = 0;

  explicit ArrowLayout(const LineLayout& layout);

  Eigen::Index core_size() const { return core_x + y; }
};

}  // namespace jointid::ident
