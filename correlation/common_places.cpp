#include "correlation/common_places.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/set/frf_system.hpp"

namespace jointid::correlation {

std::string some_names(const std::vector<frf::Dof>& dofs) {
  constexpr std::size_t most = 6;
  const std::vector<frf::Dof> first(dofs.begin(), dofs.begin() + static_cast<std::ptrdiff_t>(std::min(most, dofs.size())));
  const std::string text = comma_list(frf::names(first));
  return dofs.size() > most ? text + ", … " + std::to_string(dofs.size()) + " in all" : text;
}

void fail_nothing_common(const std::string& one_file, const std::string& other_file, const std::string& what,
                         const std::string& one, const std::string& other) {
  throw InputError({.kind = ErrorKind::data,
                    .file = other_file,
                    .place = what,
                    .problem = "none is that of " + one_file + ": " + other + " here, " + one + " there",
                    .remedy = "name files of one structure; `jointid info` lists what a file holds"});
}

std::vector<Match> common_dofs(const std::vector<frf::Dof>& one, const std::vector<frf::Dof>& other) {
  std::vector<Match> out;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const std::size_t j = frf::find_coordinate(other, one[i]);
    if (j != frf::npos) out.push_back({i, j, static_cast<double>(one[i].sign * other[j].sign)});
  }
  return out;
}

std::vector<Match> common_lines(const std::vector<double>& one_hz, const std::vector<double>& other_hz) {
  constexpr double tolerance = 1e-6;
  std::vector<Match> out;
  std::size_t j = 0;
  for (std::size_t i = 0; i < one_hz.size(); ++i) {
    while (j < other_hz.size() && other_hz[j] < one_hz[i] * (1.0 - tolerance)) ++j;
    if (j < other_hz.size() && std::abs(other_hz[j] - one_hz[i]) <= tolerance * one_hz[i]) out.push_back({i, j});
  }
  return out;
}

Common common_of(const frf::FrfHeader& one, const frf::FrfHeader& other) {
  Common out{common_dofs(one.response, other.response), common_dofs(one.reference, other.reference),
             common_lines(one.frequency_hz, other.frequency_hz)};
  if (out.responses.empty())
    fail_nothing_common(one.file, other.file, "responses", some_names(one.response), some_names(other.response));
  if (out.references.empty())
    fail_nothing_common(one.file, other.file, "references", some_names(one.reference), some_names(other.reference));
  if (out.lines.empty())
    fail_nothing_common(one.file, other.file, "frequency lines", frf::range_text(one.frequency_hz),
                        frf::range_text(other.frequency_hz));
  return out;
}

}  // namespace jointid::correlation
