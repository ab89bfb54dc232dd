#include "ident/check/rigid_mass.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "dense/eigen.hpp"
#include "ident/check/test/span_test.hpp"
#include "ident/check/trial/mistake_trial.hpp"
#include "ident/check/trial/mistaken_units.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;

constexpr double least_eigenvalue = 0.02;  ///< of the largest: smaller ones are noise
constexpr double most_imaginary = 0.3;     ///< of the real part
constexpr double most_bend = 0.1;          ///< of log m over the lines
constexpr double heavier = 1.15;           ///< than weighed: what neither geometry nor elasticity makes
constexpr double unit_tolerance = 0.15;    ///< of the logarithm
constexpr double sure = 0.95, not_sure = 0.7;

struct Places {
  std::vector<Index> rows, columns;
};

/// Translations of one direction in both roles, of the direction that has most of them.
Places most_translations(const CheckedFile& file) {
  Places best;
  for (const frf::Direction direction : {frf::Direction::x, frf::Direction::y, frf::Direction::z}) {
    Places places;
    for (std::size_t r = 0; r < file.responses.size(); ++r) {
      const std::size_t c = place_of(file.references, file.responses[r]);
      if (file.responses[r].direction != direction || c == frf::npos) continue;
      places.rows.push_back(at(r));
      places.columns.push_back(at(c));
    }
    if (places.rows.size() > best.rows.size()) best = std::move(places);
  }
  return best;
}

/// 1ᵀA⁺1 of one line, or nothing where that is no mass.
std::optional<double> mass_at(const Eigen::MatrixXcd& receptance, double frequency_hz) {
  const double omega = angular(frequency_hz);
  const Eigen::MatrixXcd accelerance = -omega * omega * 0.5 * (receptance + receptance.transpose());
  if (!accelerance.allFinite() || accelerance.imag().norm() > most_imaginary * accelerance.real().norm()) return std::nullopt;
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(accelerance.real());
  const double largest = eigen.values[eigen.values.size() - 1];
  if (!(largest > 0.0)) return std::nullopt;
  double mass = 0.0;
  for (Index k = 0; k < eigen.values.size(); ++k) {
    if (eigen.values[k] > least_eigenvalue * largest) mass += std::pow(eigen.vectors.col(k).sum(), 2) / eigen.values[k];
  }
  return mass;
}

/// log m against f² by a straight line.
struct MassLine {
  std::vector<double> square, log_mass;

  std::optional<double> at_zero() const {
    const auto n = static_cast<double>(square.size());
    if (n < 3.0) return std::nullopt;
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < square.size(); ++i) {
      x += square[i] / n;
      y += log_mass[i] / n;
    }
    for (std::size_t i = 0; i < square.size(); ++i) {
      xx += std::pow(square[i] - x, 2);
      xy += (square[i] - x) * (log_mass[i] - y);
    }
    const double slope = xx > 0.0 ? xy / xx : 0.0;
    double left = 0.0;
    for (std::size_t i = 0; i < square.size(); ++i) left += std::pow(log_mass[i] - y - slope * (square[i] - x), 2) / n;
    if (std::abs(slope) * x > most_bend || std::sqrt(left) > most_bend) return std::nullopt;
    return std::exp(y - slope * x);
  }
};

}  // namespace

std::optional<double> rigid_body_mass(const CheckedFile& file) {
  const Places places = most_translations(file);
  if (places.rows.empty()) return std::nullopt;
  MassLine line;
  double first = 0.0;
  for (std::size_t l = 0; l < file.frfs.size(); ++l) {
    const double f = file.frequency_hz[l];
    if (!(f > 0.0)) continue;
    if (first == 0.0) first = f;
    if (f > 2.0 * first && line.square.size() >= 3) break;
    const auto mass = mass_at(file.frfs[l](places.rows, places.columns), f);
    if (!mass) return std::nullopt;
    line.square.push_back(f * f);
    line.log_mass.push_back(std::log(*mass));
  }
  return line.at_zero();
}

namespace {

/// Σ ln of what the span tests leave.
double disagreement(const std::vector<CheckedFile>& files, const Dofs& joint) {
  constexpr double least = 0.004;
  constexpr std::size_t lines = 24;
  std::vector<CheckedFile> some;
  for (const CheckedFile& file : files) some.push_back(at_lines(file, spread_lines(file.frfs.size(), lines)));
  double sum = 0.0;
  for (const SpanSetup& setup : span_setups(some, joint))
    sum += std::log(std::hypot(span_test(setup, some, SpanDetail::level).level, least));
  return sum;
}

void scale(CheckedFile& file, double factor) {
  for (Eigen::MatrixXcd& line : file.frfs) line *= factor;
  if (!file.noise) return;
  NoiseLaws laws = *file.noise;
  laws.constant *= factor * factor;
  file.noise = std::make_shared<const NoiseLaws>(std::move(laws));
}

/// Whether the other files are off by the same factor, as those agree that are so far.
bool is_of_all(const std::vector<CheckedFile>& files, std::size_t wrong, double factor, const Dofs& joint) {
  constexpr double clearly = 0.2;
  for (std::size_t f = 0; f < files.size(); ++f) {
    if (f == wrong || !files[f].mass) continue;
    const auto told = rigid_body_mass(files[f]);
    if (told && std::abs(std::log(*told / *files[f].mass * factor)) > std::abs(std::log(factor)) / 2.0) return false;
  }
  std::vector<CheckedFile> one = files;
  scale(one[wrong], factor);
  return disagreement(files, joint) < disagreement(one, joint) - clearly;
}

}  // namespace

std::vector<Suspect> find_wrong_masses(std::vector<CheckedFile>& files, const Dofs& joint) {
  std::vector<Suspect> found;
  for (std::size_t f = 0; f < files.size(); ++f) {
    CheckedFile& file = files[f];
    const auto told = file.mass ? rigid_body_mass(file) : std::nullopt;
    if (!told) continue;
    const double measured = *told / *file.mass;
    const auto [factor, words] = nearest_unit(measured, unit_tolerance);
    if (words.empty() && measured < heavier) continue;
    std::string evidence = fmt::format("the rigid-body lines are those of {:.3g} kg, where {:.4g} kg were weighed{}", *told, *file.mass,
                                       words.empty() ? "" : ": " + words);
    const std::string line = fmt::format("gain = {:.6g}", factor);
    std::string remedy = remedy_in(file.name, line);
    const bool of_all = files.size() > 1 && !words.empty() && is_of_all(files, f, factor, joint);
    if (of_all) evidence += "; the other files agree with it as they are, so that all are in that unit";
    for (std::size_t other = 0; other < files.size(); ++other) {
      if (other != f && !of_all) continue;
      scale(files[other], factor);
      if (other != f) remedy += "\n" + remedy_in(files[other].name, line);
    }
    found.push_back({.kind = words.empty() ? SuspectKind::gain : SuspectKind::unit,
                     .file = file.name,
                     .dofs = {},
                     .evidence = evidence,
                     .confidence = words.empty() ? not_sure : sure,
                     .remedy = remedy});
  }
  return found;
}

}  // namespace jointid::ident
