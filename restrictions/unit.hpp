#pragma once

#include <string>

#include "restrictions/joint_spec.hpp"

namespace jointid::restrictions {

/// Unit of element (row, column) of a joint matrix from its DOFs: force (N) or moment (N*m) of the row over the motion
/// (m or rad), acceleration or velocity of the column. K and D: "N/m", "N/rad", "N", "N*m/rad"; C: the same times s,
/// "N*s/m", …; M: "kg", "kg*m", "kg*m^2".
std::string unit(Kind kind, const frf::Dof& row, const frf::Dof& column);

/// Power of m in the unit, the radian counting as 1: elements of one matrix with the same power can share an unknown.
int length_power(const frf::Dof& row, const frf::Dof& column);

/// The unit of an unknown that stands at several elements: that of the first, or "mixed" when they differ by more than
/// the radian (N and N/rad are one unit: a symmetric matrix has both).
class SharedUnit {
 public:
  void add(Kind kind, const frf::Dof& row, const frf::Dof& column);
  std::string text() const { return text_; }

 private:
  std::string text_;
  int length_power_ = 0;
};

}  // namespace jointid::restrictions
