#pragma once

#include "ident/plan/joint_effect.hpp"
#include "ident/plan/line.hpp"

namespace jointid::tasks {

/// Chunks of the lines that both systems have: FRFs of the substructures and of the assembly, line by line.
class LinePairs {
 public:
  LinePairs(const std::vector<ident::Line>& lines, ident::Rectangle substructures, ident::Rectangle assembly);

  /// Reads the lines [first, last).
  void read(std::size_t first, std::size_t last);

  /// Of the i-th line of the last read().
  minimise::View substructures(std::size_t i) const { return substructures_.line(i); }
  minimise::View assembly(std::size_t i) const { return assembly_.line(i); }

 private:
  const std::vector<ident::Line>& lines_;
  ident::Rectangle substructures_, assembly_;
};

}  // namespace jointid::tasks
