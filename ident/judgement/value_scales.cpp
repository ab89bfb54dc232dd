#include "ident/judgement/value_scales.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/eigen.hpp"

namespace jointid::ident {

Eigen::VectorXd largest_of_kind(const Plan& plan, const std::vector<double>& values) {
  const auto kind_of = [&](std::size_t column) {
    const restrictions::Unknown& unknown = plan.restriction.unknowns[plan.columns->unknown_of(column)];
    return std::pair(unknown.kind, unknown.unit);
  };
  std::map<std::pair<restrictions::Kind, std::string>, double> largest;
  for (std::size_t c = 0; c < values.size(); ++c) largest[kind_of(c)] = std::max(largest[kind_of(c)], std::abs(values[c]));
  Eigen::VectorXd out(at(values.size()));
  for (std::size_t c = 0; c < values.size(); ++c) out[at(c)] = largest[kind_of(c)];
  return out;
}

}  // namespace jointid::ident
