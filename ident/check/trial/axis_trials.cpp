#include "ident/check/trial/axis_trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ident/check/test/screening.hpp"
#include "ident/check/test/slope_fit.hpp"
#include "ident/check/trial/axis_shift.hpp"

namespace jointid::ident {
namespace {

using Files = std::vector<CheckedFile>;

constexpr std::array<double, 16> grid = {-0.03, -0.02, -0.015, -0.01,  -0.0075, -0.005, -0.003, -0.002,
                                         0.002, 0.003, 0.005,  0.0075, 0.01,    0.015,  0.02,   0.03};
constexpr double step = 1e-3, least_stretch = 0.002, least_deviations = 1.5;
constexpr double least_score_of_axis = 0.55;  // between lines, FRFs are smoothed, too
constexpr std::size_t most_lines = 16, least_lines = 8;
constexpr double most_work = 3e5;                        ///< products of complex numbers per test, about
constexpr std::size_t most_rows = 10, most_columns = 5;  ///< beside the joint's, per part
constexpr std::size_t most_searched = 8;                 ///< columns of a part, the joint's included, over the grid

const Dofs& side(const CheckedFile& file, bool references) { return references ? file.references : file.responses; }

/// The joint's coordinates and, of each part, up to `most` others that the assembly has too.
Dofs some_of(const Files& files, const Dofs& joint, bool references, std::size_t most) {
  Dofs chosen = joint;
  for (const CheckedFile& part : files) {
    if (part.assembly) continue;
    Dofs others;
    for (const frf::Dof& dof : side(part, references)) {
      const bool common = std::ranges::any_of(
          files, [&](const CheckedFile& file) { return file.assembly && frf::has(side(file, references), dof); });
      if (common && !frf::has(joint, dof)) others.push_back(dof);
    }
    for (const std::size_t i : spread_lines(others.size(), most)) chosen.push_back(others[i]);
  }
  return chosen;
}

/// The test with at most `most` columns on the part, and as many outside of it.
SpanSetup with_fewer_columns(const SpanSetup& setup, std::size_t most) {
  SpanSetup fewer = setup;
  fewer.part_columns.clear();
  fewer.assembly_columns.clear();
  fewer.outer_columns.clear();
  for (const std::size_t i : spread_lines(setup.part_columns.size(), most)) {
    fewer.part_columns.push_back(setup.part_columns[i]);
    fewer.assembly_columns.push_back(setup.assembly_columns[i]);
  }
  for (const std::size_t i : spread_lines(setup.outer_columns.size(), most))
    fewer.outer_columns.push_back(setup.outer_columns[i]);
  return fewer;
}

/// What the search looks at: fewer rows and columns, and the tests of one direction.
struct Sample {
  Files files;
  std::vector<SpanSetup> setups;
  std::vector<SpanSetup> searched;  ///< over the grid
  std::vector<std::size_t> lines;
  Files at_lines;

  Sample(const Files& all, const Dofs& joint) {
    const auto is_of_references = [](const SpanSetup& setup) { return setup.transposed; };
    const std::vector<SpanSetup> possible = span_setups(all, joint);
    const bool references = !possible.empty() && std::ranges::all_of(possible, is_of_references);
    const Dofs rows = some_of(all, joint, references, most_rows), columns = some_of(all, joint, !references, most_columns);
    for (const CheckedFile& file : all) files.push_back(references ? part_of(file, columns, rows) : part_of(file, rows, columns));
    setups = span_setups(files, joint);
    std::erase_if(setups, [&](const SpanSetup& setup) { return setup.transposed != references; });
    for (const SpanSetup& setup : setups) searched.push_back(with_fewer_columns(setup, most_searched));
    lines = spread_lines(all.front().frfs.size(), lines_for(setups, most_lines, most_work));
    for (const CheckedFile& file : files) at_lines.push_back(ident::at_lines(file, lines));
  }

  Files shifted(std::size_t f, double epsilon) const {
    Files result = at_lines;
    result[f].frfs = shifted_frfs(files[f], lines, epsilon);
    return result;
  }

  bool concerns(const SpanSetup& setup, std::size_t f) const { return setup.part == f || setup.assembly == f; }

  double misfit(std::size_t f, double epsilon) const {
    const Files at = shifted(f, epsilon);
    double sum = 0.0;
    for (const SpanSetup& setup : searched) {
      if (concerns(setup, f)) sum += std::log(span_test(setup, at, SpanDetail::level).level + 1e-3);
    }
    return sum;
  }
};

/// How many standard deviations a stretch by one step of least squares, from residuals at ±`step`, is away from none.
double deviations_of_stretch(const Sample& sample, std::size_t f) {
  const Files low = sample.shifted(f, -step), high = sample.shifted(f, step);
  SlopeFit fit;
  for (const SpanSetup& setup : sample.setups) {
    if (!sample.concerns(setup, f)) continue;
    const SpanTest a = span_test(setup, low, SpanDetail::residuals), b = span_test(setup, high, SpanDetail::residuals);
    for (std::size_t l = 0; l < a.residuals.size(); ++l) {
      if (a.residuals[l].size() == 0 || b.residuals[l].size() == 0) continue;
      const Eigen::MatrixXcd change = b.residuals[l] - a.residuals[l], middle = 0.5 * (a.residuals[l] + b.residuals[l]);
      fit.add(-change.conjugate().cwiseProduct(middle).sum().real(), change.squaredNorm());
    }
  }
  return fit.is_told() ? std::abs(fit.slope()) / std::max(fit.scatter(), 1e-300) : 0.0;
}

/// The stretch that fits best; 0: none, or not within the grid.
double best_stretch(const Sample& sample, std::size_t f) {
  double best = 0.0, least = sample.misfit(f, 0.0);
  const auto consider = [&](double epsilon) {
    const double sum = sample.misfit(f, epsilon);
    if (!(sum < least)) return;
    least = sum;
    best = epsilon;
  };
  for (const double epsilon : grid) consider(epsilon);
  if (std::abs(best) == grid.back()) return 0.0;  // at an end of the grid it is no minimum
  for (double width = 0.25 * std::abs(best); width > 0.01 * std::abs(best); width *= 0.5) {
    const double middle = best;
    consider(middle - width);
    consider(middle + width);
  }
  return std::abs(best) < least_stretch ? 0.0 : best;
}

void shift_all(CheckedFile& file, double epsilon) {
  file.frfs = shifted_frfs(file, spread_lines(file.frfs.size(), file.frfs.size()), epsilon);
}

}  // namespace

std::vector<MistakeTrial> axis_trials(const std::vector<CheckedFile>& all, const Dofs& joint) {
  std::vector<MistakeTrial> out;
  if (all.front().frfs.size() < least_lines) return out;
  const Sample sample(all, joint);
  for (std::size_t f = 0; f < all.size(); ++f) {
    const double deviations = deviations_of_stretch(sample, f);
    const double best = deviations < least_deviations ? 0.0 : best_stretch(sample, f);
    if (best == 0.0) continue;
    out.push_back(
        {.kind = SuspectKind::axis,
         .files = {f},
         .dofs = {},
         .what = fmt::format("resonances agree with the other files when the frequencies of the file are divided by {:.5g}",
                             1.0 + best),
         .remedy = remedy_in(all[f].name, fmt::format("frequency_scale = {:.6g}", 1.0 / (1.0 + best))),
         .undo = [f, best](Files& files) { shift_all(files[f], best); },
         .bonus = 0.01 * std::min(deviations, 25.0),
         .least_score = least_score_of_axis,
         .only_span = true,
         .leave = [f](Files& files) { shift_all(files[f], 0.0); }});
  }
  return out;
}

}  // namespace jointid::ident
