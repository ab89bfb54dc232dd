#include "tasks/response/part_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/text.hpp"
#include "dense/eigen.hpp"

namespace jointid::tasks {
namespace {

constexpr double active = 0.02;           ///< share of the largest |H| by which −Im H may be negative before it is told
constexpr double most_asymmetry = 0.1;    ///< rms of H − Hᵀ over that of H: what noise of 7 % makes
constexpr double most_deviations = 4.0;   ///< of stated noise
constexpr double few_lines = 0.05;        ///< share: a cause leaves no more of them
constexpr double one_factor = 0.3;        ///< rms of what a factor leaves, in parts of the FRF
constexpr std::size_t most_flipped = 12;  ///< DOFs of which the signs are tried

/// FRFs of one part between the DOFs that are response and reference, as those of directions +.
struct SquarePart {
  std::string name;
  std::vector<frf::Dof> dofs;
  std::vector<double> hz;
  std::vector<Eigen::MatrixXcd> lines, variances;  ///< no variances where they are not known
};

SquarePart square_part(const response::FrfReceptance& measured, const frf::FrfSystem& parts, std::size_t source) {
  SquarePart part = {
      .name = parts.source(source).header().file, .dofs = {}, .hz = measured.frequency_hz(), .lines = {}, .variances = {}};
  if (part.name.empty()) part.name = fmt::format("part {}", source + 1);
  std::vector<Eigen::Index> rows, columns;
  std::vector<int> row_signs, column_signs;
  for (std::size_t r = 0; r < measured.row_dofs().size(); ++r) {
    const frf::Dof& dof = measured.row_dofs()[r];
    const std::size_t c = frf::find_coordinate(measured.column_dofs(), dof);
    if (c == frf::npos || frf::has(part.dofs, dof) || parts.source_of(dof) != source) continue;
    part.dofs.push_back({dof.node, dof.direction, 1});
    rows.push_back(at(r));
    columns.push_back(at(c));
    row_signs.push_back(dof.sign);
    column_signs.push_back(measured.column_dofs()[c].sign);
  }
  Eigen::MatrixXd signs(at(rows.size()), at(rows.size()));
  for (Eigen::Index i = 0; i < signs.rows(); ++i) {
    for (Eigen::Index j = 0; j < signs.cols(); ++j)
      signs(i, j) = row_signs[static_cast<std::size_t>(i)] * column_signs[static_cast<std::size_t>(j)];
  }
  for (std::size_t line = 0; line < part.hz.size(); ++line) {
    part.lines.emplace_back(signs.cwiseProduct(measured.measured(line)(rows, columns)));
    if (!measured.variances().empty()) part.variances.emplace_back(measured.variances()[line](rows, columns));
  }
  return part;
}

/// H_ij and H_ji over all lines.
struct Pair {
  Eigen::Index i = 0, j = 0;
  double difference = 0.0, size = 0.0, noise = 0.0;  ///< Σ|H_ij − H_ji|², half of Σ|H_ij|² + |H_ji|², variances of the difference
  double upper = 0.0, lower = 0.0, product = 0.0;  ///< Σ|H_ij|², Σ|H_ji|², Re Σ H_ij conj(H_ji)

  double asymmetry() const { return size > 0.0 ? std::sqrt(difference / size) : 0.0; }
  double factor() const { return lower > 0.0 ? product / lower : 0.0; }
  /// rms of H_ij − factor · H_ji, in parts of H_ij.
  double left() const { return upper > 0.0 ? std::sqrt(std::max(0.0, 1.0 - factor() * product / upper)) : 1.0; }
};

Pair pair_of(const SquarePart& part, Eigen::Index i, Eigen::Index j) {
  Pair pair = {.i = i, .j = j};
  for (std::size_t line = 0; line < part.lines.size(); ++line) {
    const Complex a = part.lines[line](i, j), b = part.lines[line](j, i);
    pair.difference += std::norm(a - b);
    pair.upper += std::norm(a);
    pair.lower += std::norm(b);
    pair.product += (a * std::conj(b)).real();
    if (part.variances.empty()) continue;
    const Complex both = part.variances[line](i, j) + part.variances[line](j, i);
    pair.noise += both.real() + both.imag();
  }
  pair.size = 0.5 * (pair.upper + pair.lower);
  return pair;
}

/// What would make H_ij of H_ji.
std::string explained(const Pair& pair) {
  if (pair.left() > one_factor) return "no factor makes them one: exchanged labels, or another set-up";
  if (std::abs(pair.factor() + 1.0) < 0.2) return "signs: a sensor or a hammer turned round";
  return fmt::format("{:.3g} times as large: a gain, or a unit", pair.factor());
}

std::optional<std::string> not_reciprocal(const SquarePart& part) {
  double difference = 0.0, size = 0.0, noise = 0.0;
  Pair worst;
  for (Eigen::Index i = 0; i < at(part.dofs.size()); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const Pair pair = pair_of(part, i, j);
      difference += pair.difference;
      size += pair.size;
      noise += pair.noise;
      if (pair.asymmetry() > worst.asymmetry()) worst = pair;
    }
  }
  const double most = std::max(most_asymmetry * most_asymmetry * size, 2.0 * noise);
  if (!(difference > most)) return std::nullopt;
  const auto name = [&](Eigen::Index k) { return part.dofs[static_cast<std::size_t>(k)].name(); };
  return fmt::format(
      "{}: the FRFs are not reciprocal, they differ from their transposes by {:.2g} of their size (rms); most of all {}/{} "
      "from {}/{}: {}",
      part.name, std::sqrt(difference / size), name(worst.i), name(worst.j), name(worst.j), name(worst.i), explained(worst));
}

using Change = std::function<Eigen::MatrixXcd(const Eigen::MatrixXcd&, double omega)>;

/// Lines on which the part would feed energy: −Im H with an eigenvalue below 0 by more than noise. At 0 Hz nothing is known.
std::vector<double> active_lines_hz(const SquarePart& part, const Change& change) {
  std::vector<double> found;
  for (std::size_t line = 0; line < part.lines.size(); ++line) {
    if (part.hz[line] == 0.0) continue;
    const Eigen::MatrixXcd h = change(part.lines[line], angular(part.hz[line]));
    const double size = h.cwiseAbs().maxCoeff(), share = size / part.lines[line].cwiseAbs().maxCoeff();
    double margin = active * size;
    if (!part.variances.empty()) {
      const Eigen::MatrixXcd& variance = part.variances[line];
      const double deviation = std::sqrt(std::max(variance.real().maxCoeff(), variance.imag().maxCoeff()));
      margin = std::max(margin, most_deviations * std::sqrt(static_cast<double>(h.rows())) * deviation * share);
    }
    const Eigen::MatrixXd lost = -0.5 * (h.imag() + h.imag().transpose());
    if (dense::symmetric_eigenvalues(lost).minCoeff() < -margin) found.push_back(part.hz[line]);
  }
  return found;
}

/// The single mistakes that are tried: what each would be put right by, and its name.
std::vector<std::pair<Change, std::string>> changes(const SquarePart& part) {
  std::vector<std::pair<Change, std::string>> all = {
      {[](const Eigen::MatrixXcd& h, double) -> Eigen::MatrixXcd { return -h; },
       "−H would be: signs turned round, phases counted the other way, or accelerances taken for receptances"},
      {[](const Eigen::MatrixXcd& h, double omega) -> Eigen::MatrixXcd { return h / Complex(0.0, omega); },
       "H/iω would be: mobilities taken for receptances"}};
  for (std::size_t k = 0; part.dofs.size() > 1 && part.dofs.size() <= most_flipped && k < part.dofs.size(); ++k) {
    all.emplace_back(
        [row = at(k)](const Eigen::MatrixXcd& h, double) {
          Eigen::MatrixXcd flipped = h;
          flipped.row(row) *= -1.0;
          return flipped;
        },
        fmt::format("with the other sign of {} they would be: a sensor or a hammer turned round", part.dofs[k].name()));
  }
  return all;
}

std::optional<std::string> not_passive(const SquarePart& part) {
  const std::vector<double> lines = active_lines_hz(part, [](const Eigen::MatrixXcd& h, double) { return h; });
  if (lines.empty()) return std::nullopt;
  const double all = static_cast<double>(part.lines.size());
  std::string cause = "channels with a time delay, exchanged labels or noise can do that";
  if (static_cast<double>(lines.size()) > few_lines * all) {
    for (const auto& [change, words] : changes(part)) {
      const double left = static_cast<double>(active_lines_hz(part, change).size());
      if (left > few_lines * all || left > 0.2 * static_cast<double>(lines.size())) continue;
      cause = words;
      break;
    }
  }
  return fmt::format("{}: the FRFs at {} are not passive on {} of {} lines (−Im H < 0), first at {:.6g} Hz; {}", part.name,
                     comma_list(frf::names(part.dofs)), lines.size(), part.lines.size(), lines.front(), cause);
}

}  // namespace

std::vector<std::string> part_doubts(const response::FrfReceptance& measured, const frf::FrfSystem& parts) {
  std::vector<std::string> doubts;
  for (std::size_t source = 0; source < parts.source_count(); ++source) {
    const SquarePart part = square_part(measured, parts, source);
    for (const std::string& doubt : parts.source(source).header().doubts) doubts.push_back(part.name + ": " + doubt);
    if (part.dofs.empty()) continue;
    for (const auto& doubt : {not_reciprocal(part), not_passive(part)}) {
      if (doubt) doubts.push_back(*doubt);
    }
  }
  return doubts;
}

}  // namespace jointid::tasks
