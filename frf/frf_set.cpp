#include "frf/frf_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "frf/header_failure.hpp"

namespace jointid::frf {
namespace {

void require_distinct(const FrfHeader& header, const std::vector<Dof>& dofs, const char* role) {
  if (dofs.empty()) fail(header, role, "no DOFs", "a set needs at least one response and one reference");
  std::set<std::int64_t> seen;
  for (const Dof& dof : dofs) {
    if (!seen.insert(coordinate_key(dof)).second) {
      fail(header, role, "DOF " + dof.name() + " appears twice", "keep one of the two, or rename its node");
    }
  }
}

}  // namespace

void validate(const FrfHeader& header) {
  const std::vector<double>& axis = header.frequency_hz;
  if (axis.empty()) fail(header, "frequency", "no lines", "the file holds no FRF data");
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const std::string place = "frequency line " + std::to_string(i + 1);
    if (!std::isfinite(axis[i]) || axis[i] < 0.0) {
      fail(header, place, fmt::format("{} Hz is not a frequency", axis[i]), "remove or correct that line");
    }
    if (i > 0 && axis[i] <= axis[i - 1]) {
      fail(header, place, fmt::format("{} Hz does not follow {} Hz", axis[i], axis[i - 1]),
           "frequencies must increase from line to line");
    }
  }
  require_distinct(header, header.response, "response DOFs");
  require_distinct(header, header.reference, "reference DOFs");
}

std::size_t find_coordinate(const std::vector<Dof>& dofs, const Dof& dof) {
  const auto found =
      std::find_if(dofs.begin(), dofs.end(), [&](const Dof& other) { return other.same_coordinate(dof); });
  return found == dofs.end() ? npos : static_cast<std::size_t>(found - dofs.begin());
}

}  // namespace jointid::frf
