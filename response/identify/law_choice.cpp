#include "response/identify/law_choice.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"

namespace jointid::response {
namespace {

[[noreturn]] void fail_laws(std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = "",
                    .place = "laws",
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

std::vector<Joint> start_of(const std::vector<DirectStep>& steps, const std::vector<std::string>& laws,
                            const std::vector<Joint>& beside) {
  if (laws.size() != beside.size()) {
    fail_laws(std::to_string(laws.size()) + " laws for " + std::to_string(beside.size()) + " joints", "name one for each joint");
  }
  std::vector<Joint> joints;
  for (std::size_t j = 0; j < laws.size(); ++j) {
    try {
      joints.push_back(fit_forces(steps, j, laws[j], beside[j]).joint);
    } catch (const std::invalid_argument& wrong) {
      fail_laws(wrong.what(), "");
    }
    if (!joints.back().friction) fail_laws("no start of " + laws[j] + " suits joint " + std::to_string(j + 1), "give its values");
  }
  return joints;
}

/// Whether the numbers are those of a minimum.
bool is_minimum(const LawFit& fit) {
  return fit.status == LawFitStatus::converged || fit.status == LawFitStatus::harmonics_not_enough;
}

std::vector<DirectStep> direct_steps(const Receptance& structure, const std::vector<MeasuredState>& states) {
  std::vector<DirectStep> steps;
  for (const MeasuredState& state : states) steps.push_back(direct_step(structure, state));
  return steps;
}

}  // namespace

std::vector<Joint> law_start(const Receptance& structure, const std::vector<MeasuredState>& states,
                             const std::vector<std::string>& laws, const std::vector<Joint>& beside) {
  return start_of(direct_steps(structure, states), laws, beside);
}

std::vector<LawCandidate> compare_laws(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
                                       const std::vector<std::vector<std::string>>& candidates, const std::vector<Joint>& beside,
                                       const LawFitOptions& options) {
  const std::vector<DirectStep> steps = direct_steps(*structure, states);
  std::vector<LawCandidate> fitted;
  for (const std::vector<std::string>& laws : candidates) {
    fitted.push_back({laws, fit_laws(structure, states, LawUnknowns(start_of(steps, laws, beside)), options)});
  }
  std::ranges::stable_sort(fitted, {}, [](const LawCandidate& each) { return std::pair(!is_minimum(each.fit), each.fit.aic); });
  return fitted;
}

std::size_t chosen_law(const std::vector<LawCandidate>& compared) {
  constexpr double as_good = 2.0;
  std::size_t chosen = 0;
  for (std::size_t i = 1; i < compared.size() && is_minimum(compared[i].fit); ++i) {
    const LawFit& fit = compared[i].fit;
    if (fit.aic > compared[0].fit.aic + as_good) break;
    if (fit.values.size() < compared[chosen].fit.values.size()) chosen = i;
  }
  return chosen;
}

}  // namespace jointid::response
