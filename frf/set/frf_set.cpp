#include "frf/set/frf_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/error.hpp"

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

/// Throws InputError unless the factor and its diagonal are as long as the header says, and all there is.
void require_factor(const FrfSet& set) {
  if (!set.factor.any()) return;
  if (!set.covariance.empty()) {
    fail(set.header, "covariance", "it is given, and a factor of it, too", "give one of them");
  }
  const std::size_t entries = set.header.lines() * set.header.entries();
  const auto require = [&](const char* what, std::size_t count, std::size_t wanted) {
    if (count == wanted) return;
    fail(set.header, what, fmt::format("{} numbers, where lines, responses and references make {}", count, wanted),
         "give one for each [line, response, column of the factor, reference]; of the diagonal [line, response, reference]");
  };
  require("factor of the covariance", set.factor.rows.size(), entries * set.factor.rank);
  if (!set.factor.diagonal.empty()) require("diagonal of the covariance", set.factor.diagonal.size(), entries);
}

}  // namespace

void fail(const FrfHeader& header, std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = header.file,
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

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

bool any_own_axes(const std::vector<Node>& nodes) {
  return std::ranges::any_of(nodes, [](const Node& node) { return node.axes.has_value(); });
}

std::size_t find_coordinate(const std::vector<Dof>& dofs, const Dof& dof) {
  const auto found =
      std::find_if(dofs.begin(), dofs.end(), [&](const Dof& other) { return other.same_coordinate(dof); });
  return found == dofs.end() ? npos : static_cast<std::size_t>(found - dofs.begin());
}

void validate(const FrfSet& set) {
  validate(set.header);
  const std::size_t lines = set.header.lines(), responses = set.header.response.size(), references = set.header.reference.size();
  const std::size_t wanted = lines * responses * references, pairs = lines * pair_count(responses) * references;
  if (!set.covariance.empty() && set.covariance.size() != pairs) {
    fail(set.header, "covariance",
         fmt::format("{} numbers, where {} lines, responses and references make {}", set.covariance.size(), lines, pairs),
         "give one for each line, pair of responses (r, s ≤ r) and reference");
  }
  require_factor(set);
  if (!set.reference_correlation.empty() &&
      (!set.has_covariance() || set.reference_correlation.size() != lines * references * references)) {
    fail(set.header, "reference_correlation",
         fmt::format("{} numbers, where {} lines and {} references, squared, make {}{}", set.reference_correlation.size(), lines,
                     references, lines * references * references, set.has_covariance() ? "" : ", and there are no covariances"),
         "give one for each line and two references, beside covariances");
  }
  const auto require = [&](const char* what, std::size_t count, bool optional) {
    if (count == wanted || (optional && count == 0)) return;
    fail(set.header, what,
         std::to_string(count) + " numbers, where " + std::to_string(lines) + " lines × " + std::to_string(responses) + " responses × " +
             std::to_string(references) + " references are " + std::to_string(wanted),
         "give one for each, [line, response, reference], NaN where not measured");
  };
  require("values", set.values.size(), false);
  require("variance", set.variance.size(), true);
  require("coherence", set.coherence.size(), true);
}

}  // namespace jointid::frf
