#pragma once

#include <map>
#include <string>
#include <vector>

#include "ident/result/solution.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

/// More unknowns than this, of several joints, are shown joint by joint.
inline constexpr std::size_t most_unknowns_in_full = 200;

/// Whether a solution is shown joint by joint in place of all its unknowns and of matrices over all joint coordinates.
bool is_shown_by_joint(const ident::Solution& solution);

/// What a solution says of one joint.
struct JointSummary {
  /// Some unknowns of a joint that can be compared in size.
  struct Size {
    std::string unit;
    double largest = 0.0;
  };
  std::string name;
  std::size_t unknowns = 0, undetermined = 0;
  std::map<std::string, Size> by_kind;  ///< "K" → its first unit
  std::string worst;                    ///< unknown with the largest error over its value; empty: no errors
  double worst_error = -1.0;            ///< that; values below a tenth of the largest of their joint, matrix and unit count as that
};

/// In the order of the unknowns.
std::vector<JointSummary> joint_summaries(const ident::Solution& solution);

/// How many joints and unknowns, how many the data do not determine, and which joints the table has.
std::string joints_head(const ident::Solution& solution);

/// A line for each joint: its largest stiffness as number and bar, damping, the worst error and what the data do not determine; of many
/// joints the worst.
Table joints_table(const ident::Solution& solution);

/// Both as text.
std::string joints_text(const ident::Solution& solution);

}  // namespace jointid::report
