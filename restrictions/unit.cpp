#include "restrictions/unit.hpp"

namespace jointid::restrictions {
namespace {

std::string mass_unit(int rotations) {
  return rotations == 0 ? "kg" : rotations == 1 ? "kg*m" : "kg*m^2";
}

}  // namespace

std::string unit(Kind kind, const frf::Dof& row, const frf::Dof& column) {
  if (kind == Kind::mass) return mass_unit(length_power(row, column) + 1);
  const std::string second = kind == Kind::viscous_damping ? "*s" : "";
  if (row.is_rotation() && !column.is_rotation()) return "N" + second;
  return (row.is_rotation() ? "N*m" : "N") + second + (column.is_rotation() ? "/rad" : "/m");
}

int length_power(const frf::Dof& row, const frf::Dof& column) {
  return static_cast<int>(row.is_rotation()) + static_cast<int>(column.is_rotation()) - 1;
}

void SharedUnit::add(Kind kind, const frf::Dof& row, const frf::Dof& column) {
  const int power = length_power(row, column);
  if (text_.empty()) {
    text_ = unit(kind, row, column);
    length_power_ = power;
  } else if (power != length_power_) {
    text_ = "mixed";
  }
}

}  // namespace jointid::restrictions
