#include "ident/plan/joint_impedance.hpp"

#include "base/complex.hpp"

namespace jointid::ident {

JointImpedance joint_at(const restrictions::Restriction& restriction, const UnknownColumns& columns, double omega0, double omega) {
  std::vector<std::size_t> own = columns.at(hertz(omega)), unknown_of;
  for (const std::size_t column : own) unknown_of.push_back(columns.unknown_of(column));
  return {restriction, std::move(own), unknown_of, omega0, omega};
}

}  // namespace jointid::ident
