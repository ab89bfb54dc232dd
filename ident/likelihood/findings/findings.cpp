#include "ident/likelihood/findings/findings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/text.hpp"

namespace jointid::ident {
namespace {

constexpr double bad = 0.1;  ///< relative error
constexpr double hardly_seen = 5.0, loose = 0.5, held = 0.01;  ///< effect, deformation: see JointVisibility
constexpr std::size_t most_lines = 3;
constexpr double hardly_counts = 3.0;  // about where a line counts for less than half

std::string listed(const std::vector<std::string>& names) {
  std::string out = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) out += (i + 1 == names.size() ? " and " : ", ") + names[i];
  return out;
}

void add_weak(const Identifiability& found, std::vector<Finding>& out) {
  for (const WeakCombination& weak : found.weakest) {
    if (weak.worst.deviation >= bad) out.push_back({FindingKind::weak_combination, text(weak)});
  }
  if (out.empty()) return;
  out.back().text +=
      " Tie such unknowns in the joint's matrices, give priors, or measure what separates them: `jointid plan "
      "SCENE --bound` predicts what a sensor or other lines would change.";
}

/// How to identify what is left of a stiff joint.
std::string rigid_remedy(const std::vector<std::array<std::string, 2>>& pairs) {
  if (pairs.empty()) return "couple the coordinates that move together rigidly and identify the rest.";
  std::string list;
  for (const auto& [one, two] : pairs) list += (list.empty() ? "[\"" : ", [\"") + one + "\", \"" + two + "\"]";
  return "couple rigidly what it holds together and identify the rest; under [joint]: couple_first = [" + list + "].";
}

void add_joint(const Identifiability& found, std::vector<Finding>& out) {
  if (found.largest_relative_error < bad) return;
  const auto [effect, deformation] = found.joint;
  if (effect && *effect < hardly_seen && deformation && *deformation > loose) {
    out.push_back({FindingKind::soft_joint,
                   "The joint is soft: half of the FRFs of assembly and substructures differ by no more than " +
                       digits(*effect, "%.2g") +
                       " times their errors. Use lower frequencies, more accurate FRFs, "
                       "another support or less mass so that the joint takes part in the motion. Where the assembly's FRFs are "
                       "all that is wanted, such a joint can be left out."});
  }
  if (deformation && *deformation < held) {
    out.push_back(
        {FindingKind::stiff_joint,
         "The joint is stiff: it makes the interface responses of the parts nearly dependent, and the combination that is "
         "least determined does only " +
             digits(*deformation, "%.1g") +
             " times the work that it would do on the free parts. Use higher frequencies, add mass or a support "
             "so that the joint deforms, tie unknowns, or " +
             rigid_remedy(found.stiff_pairs)});
  }
}

void add_nonlinear(const Identifiability& found, IntervalKind intervals, std::vector<Finding>& out) {
  if (found.largest_relative_error < nonlinear_error || intervals == IntervalKind::bootstrap) return;
  out.push_back({FindingKind::nonlinear, "Standard errors reach " + percent(found.largest_relative_error) +
                                             ": over such a range the problem is not linear and the Cramér–Rao intervals can be "
                                             "wrong. Set bootstrap = 200 in [identify]."});
}

/// The lines that fit worst, in the order of their χ² over degrees of freedom, which is above `least`.
std::string worst_lines(const ChiSquare& chi_square, const std::vector<double>& frequency_hz, double least) {
  std::vector<std::size_t> order(std::min(chi_square.by_line.size(), frequency_hz.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return !(chi_square.by_line[i] > least); });
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return chi_square.by_line[a] > chi_square.by_line[b]; });
  std::vector<std::string> lines;
  for (const std::size_t i : order) {
    if (lines.size() == most_lines) break;
    lines.push_back(digits(frequency_hz[i], "%.6g") + " Hz (" + digits(chi_square.by_line[i], "%.3g") + ")");
  }
  return lines.empty() ? "" : " Worst, with chi-square per degree of freedom: " + listed(lines) + ".";
}

void add_misfit(const Fit& fit, const std::vector<double>& frequency_hz, double likely, std::vector<Finding>& out) {
  if (!fit.chi_square) return;
  const ChiSquare& chi_square = *fit.chi_square;
  const double freedom = chi_square.degrees_of_freedom;
  if (!(chi_square.value > std::max(likely * freedom, freedom + 5.0 * std::sqrt(2.0 * std::max(freedom, 1.0))))) {
    if (chi_square.outlying_lines == 0) return;
    out.push_back(
        {FindingKind::misfit, std::to_string(chi_square.outlying_lines) +
                                  " outlier lines are set aside: they have little weight in the joint, and none in χ²." +
                                  worst_lines(chi_square, frequency_hz, hardly_counts)});
    return;
  }
  out.push_back({FindingKind::misfit, "Joint model, variances or some lines do not fit: chi-square is " +
                                          digits(chi_square.value, "%.4g") + " for " + digits(freedom, "%.4g") +
                                          " degrees of freedom, so the stated errors are too small." +
                                          worst_lines(chi_square, frequency_hz, 1.0)});
}

}  // namespace

std::string text(const LinearCombination& combination) {
  double largest = 0.0;
  for (const double factor : combination.factors) largest = std::max(largest, std::abs(factor));
  std::string out;
  for (std::size_t i = 0; i < combination.names.size(); ++i) {
    const double factor = combination.factors[i] / largest;
    if (std::abs(factor) < 0.05) continue;
    const std::string size = digits(std::abs(factor), "%.2g");
    if (!out.empty()) out += factor < 0.0 ? " - " : " + ";
    if (out.empty() && factor < 0.0) out += "-";
    out += (size == "1" ? "" : size + "*") + combination.names[i];
  }
  return out;
}

std::string text(const WeakCombination& weak) {
  const std::vector<std::string>& names = weak.worst.names;
  if (!weak.best) return names.front() + " is known only to " + percent(weak.worst.deviation) + ".";
  const std::string correlation = names.size() == 2 ? " (correlation " + digits(*weak.correlation, "%.3f") + ")" : "";
  return listed(names) + " move together" + correlation + ": relative to their sizes the data fix " + text(*weak.best) + " to " +
         percent(weak.best->deviation) + ", but " + text(weak.worst) + " only to " + percent(weak.worst.deviation) + ".";
}

std::vector<Finding> findings_of(const Identifiability& found, const Fit& fit, IntervalKind intervals,
                                 const std::vector<double>& frequency_hz, double likely) {
  std::vector<Finding> out;
  add_weak(found, out);
  add_joint(found, out);
  add_nonlinear(found, intervals, out);
  add_misfit(fit, frequency_hz, likely, out);
  return out;
}

}  // namespace jointid::ident
