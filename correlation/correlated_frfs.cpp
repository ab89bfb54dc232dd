#include "correlation/correlated_frfs.hpp"

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "correlation/common_places.hpp"
#include "correlation/criteria.hpp"
#include "frf/set/recorded_variance.hpp"

namespace jointid::correlation {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Two sets, and how they meet.
struct Both {
  Both(const frf::FrfSet& first, const frf::FrfSet& second)
      : one(first),
        other(second),
        common(common_of(first.header, second.header)),
        knows_noise(frf::knows_noise(first) || frf::knows_noise(second)) {}

  Complex first(const Match& line, const Match& response, const Match& reference) const {
    return one.values[one.index(line.one, response.one, reference.one)];
  }

  Complex second(const Match& line, const Match& response, const Match& reference) const {
    return response.sign * reference.sign * other.values[other.index(line.other, response.other, reference.other)];
  }

  /// Of the difference: real and imaginary part.
  Complex variance(const Match& line, const Match& response, const Match& reference) const {
    Complex sum{};
    if (frf::knows_noise(one)) sum += frf::recorded_variance(one, one.index(line.one, response.one, reference.one));
    if (frf::knows_noise(other)) sum += frf::recorded_variance(other, other.index(line.other, response.other, reference.other));
    return sum;
  }

  const frf::FrfSet &one, &other;
  Common common;
  bool knows_noise;
};

/// A mean of what there is; NaN of nothing.
struct Mean {
  double sum = 0.0, count = 0.0;

  void add(double value) {
    if (!std::isfinite(value)) return;
    sum += value;
    count += 1.0;
  }

  double value() const { return count > 0.0 ? sum / count : not_known; }
};

void add_difference(Complex difference, Complex variance, FrfAgreement& out) {
  if (!(variance.real() > 0.0) || !(variance.imag() > 0.0)) return;
  out.chi_square += std::pow(difference.real(), 2) / variance.real() + std::pow(difference.imag(), 2) / variance.imag();
  out.freedom += 2.0;
}

FrfAgreement agreement(const Both& sets, const Match& response, const Match& reference) {
  FrfAgreement out{.response = sets.one.header.response[response.one], .reference = sets.one.header.reference[reference.one]};
  std::vector<Complex> a, b;
  Mean lacs, coherences, squares;
  for (const Match& line : sets.common.lines) {
    const Complex first = sets.first(line, response, reference), second = sets.second(line, response, reference);
    if (!is_number(first) || !is_number(second)) continue;
    a.push_back(first);
    b.push_back(second);
    lacs.add(lac(first, second));
    coherences.add(coherence_criterion(first, second));
    squares.add(std::pow(20.0 * std::log10(std::abs(second) / std::abs(first)), 2));
    if (sets.knows_noise) add_difference(second - first, sets.variance(line, response, reference), out);
  }
  out.lines = a.size();
  out.frac = frac(a, b);
  out.lac = lacs.value();
  out.coherence = coherences.value();
  out.error_db = std::sqrt(squares.value());
  if (out.freedom == 0.0) out.chi_square = not_known;
  return out;
}

/// The FRFs of one line to one reference, of both.
struct Columns {
  std::vector<Complex> one, other;
};

Columns columns_of(const Both& sets, const Match& line, const Match& reference) {
  Columns out;
  for (const Match& response : sets.common.responses) {
    out.one.push_back(sets.first(line, response, reference));
    out.other.push_back(sets.second(line, response, reference));
  }
  return out;
}

}  // namespace

CorrelatedFrfs correlate(const frf::FrfSet& one, const frf::FrfSet& other) {
  const Both sets(one, other);
  CorrelatedFrfs out;
  for (const Match& response : sets.common.responses) {
    for (const Match& reference : sets.common.references) out.frfs.push_back(agreement(sets, response, reference));
  }
  for (const FrfAgreement& each : out.frfs) {
    if (each.freedom == 0.0) continue;
    out.chi_square += each.chi_square;
    out.freedom += each.freedom;
  }
  for (const Match& line : sets.common.lines) {
    Mean shape, amplitude;
    for (const Match& reference : sets.common.references) {
      const Columns columns = columns_of(sets, line, reference);
      shape.add(frac(columns.one, columns.other));
      amplitude.add(amplitude_criterion(columns.one, columns.other));
    }
    out.lines.push_back({one.header.frequency_hz[line.one], shape.value(), amplitude.value()});
  }
  return out;
}

ShapesOverLines shapes_over_lines(const frf::FrfSet& one, const frf::FrfSet& other, const frf::Dof& reference) {
  const Both sets(one, other);
  const std::vector<Match> found = common_dofs({reference}, other.header.reference);
  const std::size_t place = frf::find_coordinate(one.header.reference, reference);
  if (place == frf::npos || found.empty()) {
    std::vector<frf::Dof> valid;
    for (const Match& each : sets.common.references) valid.push_back(one.header.reference[each.one]);
    throw InputError({.kind = ErrorKind::data,
                      .file = "",
                      .place = "FDAC",
                      .problem = reference.name() + " is no reference of both " + one.header.file + " and " + other.header.file,
                      .remedy = "name one of " + some_names(valid)});
  }
  const Match both{place, found.front().other, 1.0};
  const auto n = static_cast<Eigen::Index>(sets.common.responses.size()),
             lines = static_cast<Eigen::Index>(sets.common.lines.size());
  Eigen::MatrixXcd a(n, lines), b(n, lines);
  ShapesOverLines out;
  for (Eigen::Index line = 0; line < lines; ++line) {
    const Match& at = sets.common.lines[static_cast<std::size_t>(line)];
    const Columns columns = columns_of(sets, at, both);
    a.col(line) = Eigen::Map<const Eigen::VectorXcd>(columns.one.data(), n);
    b.col(line) = Eigen::Map<const Eigen::VectorXcd>(columns.other.data(), n);
    out.frequency_hz.push_back(one.header.frequency_hz[at.one]);
  }
  out.fdac = fdac(a, b);
  return out;
}

}  // namespace jointid::correlation
