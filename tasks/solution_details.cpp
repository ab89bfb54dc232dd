#include "tasks/solution_details.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::tasks {
namespace {

/// Numbers of lines to solve with: fewer where a solution takes long.
std::size_t line_counts(std::size_t unknowns) {
  const double size = static_cast<double>(std::max<std::size_t>(1, unknowns));
  return static_cast<std::size_t>(std::clamp(2e8 / (size * size * size), 20.0, 400.0));
}

/// The one that has to be there, then some spread over the structure, then those that are met worst.
std::vector<FrfEntry> entries_of(const ident::Plan& plan, const EntryErrors& errors, const DetailChoice& choice) {
  std::vector<FrfEntry> entries = choose_entries(plan, choice.frfs - std::min(choice.worst, choice.frfs));
  for (const std::size_t place : worst_first(errors.rms_db)) {
    const std::size_t columns = errors.references.size();
    const FrfEntry entry{errors.responses[place / columns], errors.references[place % columns]};
    if (entries.size() < choice.frfs && std::ranges::find(entries, entry) == entries.end()) entries.push_back(entry);
  }
  if (!choice.first) return entries;
  std::erase(entries, *choice.first);
  entries.insert(entries.begin(), *choice.first);
  return entries;
}

}  // namespace

SolutionDetails solution_details(const ident::Plan& plan, const ident::Solution& solution, const DetailChoice& choice,
                                 const ident::Control& control) {
  SolutionDetails out;
  if (!solution.bands.empty()) {
    out.errors = entry_errors(plan, solution.bands, control);
    out.regenerated = regenerate(plan, solution.bands, entries_of(plan, out.errors, choice), control);
    out.all_used = out.regenerated.frequency_hz.size() == plan.lines.size();
  }
  if (!solution.quality.empty()) out.quality = quality_by_line(plan, line_counts(solution.unknowns.size()), control);
  return out;
}

void mark_interrupted(ident::Solution& best) {
  const std::string when = best.fit.iterations > 0 ? " after " + std::to_string(best.fit.iterations) + " iterations" : "";
  best.status = ident::Status::not_converged;
  best.message = "Interrupted" + when + ": these are the best values so far." + (best.message.empty() ? "" : " ") + best.message;
}

std::vector<std::size_t> worst_first(const std::vector<double>& errors) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (std::isfinite(errors[i])) places.push_back(i);
  }
  std::ranges::stable_sort(places, std::greater{}, [&](std::size_t i) { return errors[i]; });
  return places;
}

}  // namespace jointid::tasks
