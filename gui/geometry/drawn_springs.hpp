#pragma once

#include <QString>
#include <cstdint>
#include <vector>

#include "tasks/joint/joint_springs.hpp"

namespace jointid::gui {

/// All springs between two nodes, drawn as one: by the one that is loosest beside the others of its direction.
struct DrawnSpring {
  std::int64_t first = 0, second = 0;  ///< nodes
  double share = 1.0;                  ///< of the median of those of its direction
  tasks::Tightness tightness = tasks::Tightness::alike;
  QString label;  ///< "0.31 ± 0.02"; of one like the others empty
  QString text;   ///< "118 – 201: 0.31 ± 0.02 of the others (K[118:+X,201:+X])"
};

/// By pair of nodes, in the order of the springs; springs to ground, and within a node, are left out.
std::vector<DrawnSpring> drawn_springs(const std::vector<tasks::JointSpring>& springs);

/// What is loose or doubtful, a sentence each; that all are alike where none is. Empty without springs.
QString springs_text(const std::vector<DrawnSpring>& springs);

}  // namespace jointid::gui
