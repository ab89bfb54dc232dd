#include "impedance/line_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/statistics.hpp"
#include "dense/eigen.hpp"
#include "ident/check/check.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/errors/chi_square_law.hpp"

namespace jointid::impedance {
namespace {

void tell(Status status, const std::string& sentence, IdentifiedLines& out) {
  const auto rank = [](Status s) { return s == Status::ok ? 0 : s == Status::doubtful ? 1 : 2; };
  if (rank(status) > rank(out.status)) out.status = status;
  out.message += (out.message.empty() ? "" : " ") + sentence;
}

std::string band_text(const IdentifiedLines& out, std::size_t first, std::size_t last) {
  return fmt::format("{:.6g} to {:.6g} Hz", out.frequency_hz[first], out.frequency_hz[last]);
}

/// χ² over its degrees of freedom where it is highest over a run, beyond what chance leaves.
struct WorstRun {
  std::size_t first = 0, last = 0;
  double ratio = 0.0, excess = 0.0;
};

std::optional<WorstRun> worst_run(const std::vector<std::optional<LineValue>>& lines,
                                  const std::function<double(double)>& likely) {
  std::optional<WorstRun> worst;
  for (const std::size_t width : {3U, 5U, 10U, 20U}) {
    if (width > lines.size()) continue;
    for (std::size_t first = 0; first + width <= lines.size(); ++first) {
      double chi_square = 0.0, freedom = 0.0;
      for (std::size_t i = first; i < first + width; ++i) {
        if (!lines[i] || !(lines[i]->freedom > 0.0) || !std::isfinite(lines[i]->chi_square)) continue;
        chi_square += lines[i]->chi_square;
        freedom += lines[i]->freedom;
      }
      if (!(freedom > 0.0) || chi_square / freedom < 1.0) continue;
      const double ratio = chi_square / freedom, excess = ratio / likely(freedom);
      if (excess > 1.0 && (!worst || excess > worst->excess)) worst = WorstRun{first, first + width - 1, ratio, excess};
    }
  }
  return worst;
}

std::string structure_text(Structure structure) { return "structure \"" + name(structure) + "\""; }

/// What a free Z says of a structure that does not fit. It is fitted where the lines do not fit as they are, or first order shows that it
/// would explain more than chance.
void tell_structure(const LineScene& scene, const MakeFreeFit& free_fit, const std::function<double(double)>& likely,
                    IdentifiedLines& out) {
  if (scene.structure == Structure::symmetric) return;
  const auto contradicts = [&](const FreeFit& free) {
    const double more = out.freedom - free.freedom, fall = out.chi_square - free.chi_square;
    return !(fall / more <= likely(more));
  };
  const bool fits = out.chi_square / out.freedom <= likely(out.freedom);
  if (fits && !contradicts(free_fit(FreeFit::Kind::first_order))) return;
  const FreeFit free = free_fit(FreeFit::Kind::fitted);
  const double more = out.freedom - free.freedom, fall = out.chi_square - free.chi_square;
  if (!(more > 0.0) || !contradicts(free)) return;
  const bool free_fits = free.freedom > 0.0 && free.chi_square / free.freedom <= likely(free.freedom);
  const std::string evidence = fmt::format("a symmetric Z has χ² lower by {:.4g}, and {:.0f} is expected", fall, more);
  if (free.freedom <= 0.0) {
    tell(Status::doubtful,
         "The data contradict " + structure_text(scene.structure) + ": " + evidence +
             ". With FRFs at the joint alone, whether the structure or an FRF is wrong stays open.",
         out);
  } else {
    tell(Status::doubtful,
         "The data contradict " + structure_text(scene.structure) + ": " + evidence + "." +
             (free_fits ? " Take lines = \"masses\" or \"symmetric\"." : " But a symmetric Z does not fit either."),
         out);
  }
}

void judge_fit(const ident::Plan& plan, const LineScene& scene, const MakeFreeFit& free_fit, IdentifiedLines& out) {
  const auto& differences = ident::likelihood_plan(plan)->observations->mirror_differences();
  const auto likely = [&](double freedom) { return ident::likely_chi_square(plan, freedom, differences); };
  const FreeFit total = total_of(out.likelihood.lines);
  out.chi_square = total.chi_square;
  out.freedom = total.freedom;
  if (!(out.freedom > 0.0)) {
    tell(Status::doubtful,
         "Nothing can contradict this answer: there are as many unknowns as FRFs. Add FRFs at internal DOFs, or a structure "
         "such as lines = \"massless\".",
         out);
    return;
  }
  out.likely = likely(out.freedom);
  const bool estimated = out.likely > 1.001 * chi_square_quantile(out.freedom, 5.0) / out.freedom;
  const double ratio = out.chi_square / out.freedom, poor = estimated ? 4.0 : 2.0;
  const auto run = worst_run(out.likelihood.lines, likely);
  tell_structure(scene, free_fit, likely, out);
  if (ratio <= out.likely && !run) return;
  std::string sentence = fmt::format("χ²/f is {:.3g} where chance leaves {:.3g}", ratio, out.likely);
  if (run) sentence += fmt::format(", and {:.3g} from {}", run->ratio, band_text(out, run->first, run->last));
  tell(ratio > poor ? Status::poor_fit : Status::doubtful,
       sentence +
           ": Z and its intervals may be wrong there. Look for interface DOFs that are left out (rotations), a structure that "
           "does not fit, and faulty FRFs (`jointid check`).",
       out);
}

void judge_passivity(const WayResult& result, IdentifiedLines& out) {
  const auto run =
      bad_run(result.lines.size(), [&](std::size_t i) { return result.lines[i] && is_active(result.basis, *result.lines[i]); });
  if (!run) return;
  tell(Status::doubtful,
       "Z is not passive from " + band_text(out, run->first, run->second) +
           ": its imaginary part is negative beyond its error. Look for time delays, phases and signs of channels.",
       out);
}

/// Elements of a result by those of the likelihood, where both have the same structure.
void judge_closed_form(const WayResult& result, IdentifiedLines& out) {
  constexpr double apart = 5.0;
  const auto differs = [&](std::size_t i) {
    if (!result.lines[i] || !out.likelihood.lines[i]) return false;
    const Eigen::MatrixXcd difference =
        matrix_of(result.basis, result.lines[i]->z) - matrix_of(out.likelihood.basis, out.likelihood.lines[i]->z);
    for (std::size_t t = 0; t < result.basis.size(); ++t) {
      Eigen::Index r = 0, c = 0;
      result.basis[t].cwiseAbs().maxCoeff(&r, &c);
      const double variance = result.lines[i]->variance(static_cast<Eigen::Index>(t));
      if (std::norm(difference(r, c)) > apart * apart * variance) return true;
    }
    return false;
  };
  const auto run = bad_run(result.lines.size(), differs);
  if (!run) return;
  tell(Status::doubtful,
       "Way \"" + name(result.way) + "\" is more than five of its standard errors from the likelihood from " +
           band_text(out, run->first, run->second) + ": errors are too large for first order there. Use way = \"likelihood\".",
       out);
}

void note_lost(const WayResult& result, IdentifiedLines& out) {
  std::size_t lost = 0, missing = 0;
  for (const auto& line : result.lines) {
    missing += line ? 0U : 1U;
    if (!line) continue;
    bool small = false;
    for (Eigen::Index t = 0; t < line->z.size(); ++t) {
      const Eigen::MatrixXd& e = result.basis[static_cast<std::size_t>(t)];
      small = small || (e.diagonal().cwiseAbs().maxCoeff() > 0.0 && line->variance(t) > std::norm(line->z(t)));
    }
    lost += small ? 1 : 0;
  }
  if (lost > 0) {
    out.notes.push_back(
        fmt::format("On {} of {} lines a diagonal element is smaller than its standard error: the data do not see it there.",
                    lost, result.lines.size()));
  }
  if (missing > 0)
    out.notes.push_back(
        fmt::format("{} of {} lines lack an FRF that way \"{}\" needs.", missing, result.lines.size(), name(result.way)));
}

/// What the short check of the data finds. A number far from its neighbours is no finding where each line fits on its own.
void judge_data(const ident::Plan& plan, bool lines_fit, IdentifiedLines& out) {
  ident::CheckResult found = ident::quick_check(plan);
  if (lines_fit)
    std::erase_if(found.suspects, [](const ident::Suspect& suspect) { return suspect.kind == ident::SuspectKind::outlier; });
  if (found.suspects.empty()) return;
  ident::Solution told;
  ident::tell_check(found, told);
  if (told.status != Status::ok) tell(told.status, told.message, out);
}

}  // namespace

FreeFit total_of(const std::vector<std::optional<LineValue>>& lines) {
  FreeFit out;
  for (const auto& line : lines) {
    if (!line || !std::isfinite(line->chi_square)) continue;
    out.chi_square += line->chi_square;
    out.freedom += std::max(0.0, line->freedom);
  }
  return out;
}

std::optional<std::pair<std::size_t, std::size_t>> bad_run(std::size_t lines, const std::function<bool(std::size_t)>& is_bad) {
  constexpr std::size_t least = 3;
  std::optional<std::pair<std::size_t, std::size_t>> longest;
  for (std::size_t first = 0; first < lines; ++first) {
    std::size_t end = first;
    while (end < lines && is_bad(end)) ++end;
    if (end - first >= least && (!longest || end - first > longest->second - longest->first + 1)) longest = {first, end - 1};
    first = std::max(first, end);
  }
  return longest;
}

bool is_active(const Basis& basis, const LineValue& value) {
  constexpr double no_motion = 1e-9;
  const Eigen::MatrixXcd z = matrix_of(basis, value.z);
  const Eigen::VectorXd size = z.diagonal().cwiseAbs().cwiseSqrt();
  if (!(size.minCoeff() > 0.0) || !size.allFinite()) return false;
  const Eigen::VectorXd unit = size.cwiseInverse();
  Eigen::MatrixXd span = Eigen::MatrixXd::Zero(unit.size(), unit.size());
  for (const Eigen::MatrixXd& e : basis) {
    const Eigen::MatrixXd scaled = unit.asDiagonal() * e * unit.asDiagonal();
    span += scaled * scaled / std::max(scaled.squaredNorm(), 1e-300);
  }
  const dense::SymmetricEigen range = dense::symmetric_eigen(span);
  const auto moving = (range.values.array() > no_motion * range.values(range.values.size() - 1)).count();
  const Eigen::MatrixXd directions = unit.asDiagonal() * range.vectors.rightCols(moving);
  const dense::SymmetricEigen found = dense::symmetric_eigen(directions.transpose() * z.imag() * directions);
  const Eigen::VectorXd v = directions * found.vectors.col(0);
  Eigen::VectorXd along(value.z.size());
  for (Eigen::Index t = 0; t < along.size(); ++t) along(t) = v.dot(basis[static_cast<std::size_t>(t)] * v);
  const double variance = along.dot(value.covariance.bottomRightCorner(along.size(), along.size()) * along);
  const double limit = 1.0 + std::sqrt(static_cast<double>(basis.size()));
  return variance > 0.0 && found.values(0) < -limit * std::sqrt(variance);
}

void judge_lines(const ident::Plan& plan, const LineScene& scene, const MakeFreeFit& free_fit,
                 IdentifiedLines& out) {
  judge_fit(plan, scene, free_fit, out);
  const bool lines_fit = out.status == Status::ok && out.freedom > 0.0;
  const WayResult& result = out.ways.front();
  judge_passivity(result, out);
  if (result.way != Way::likelihood) judge_closed_form(result, out);
  judge_data(plan, lines_fit, out);
  note_lost(result, out);
  if (out.failed > 0) {
    tell(2 * out.failed > out.frequency_hz.size() ? Status::not_converged : Status::doubtful,
         fmt::format("The likelihood did not converge on {} of {} lines.", out.failed, out.frequency_hz.size()), out);
  }
  if (out.restarted > 0) out.notes.push_back(fmt::format("{} lines converged from their neighbours' values.", out.restarted));
}

}  // namespace jointid::impedance
