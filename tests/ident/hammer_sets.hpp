#pragma once

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "frf/noise/variance_law.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {

/// A set of exact FRFs that says of its noise: 2 % of the hammer's signal, common to all responses, and of each sensor 0.2 % of its
/// largest FRF.
inline frf::FrfSet with_hammer_noise(frf::FrfSet set) {
  constexpr double hammer = 0.02, sensor = 0.002;
  const std::size_t rows = set.header.response.size(), columns = set.header.reference.size(), pairs = frf::pair_count(rows);
  set.coherence.clear();
  set.header.noise = frf::NoiseRecord::variance;
  set.header.averages = 0.0;
  set.variance.resize(set.values.size());
  set.covariance.resize(set.header.lines() * pairs * columns);
  for (std::size_t c = 0; c < columns; ++c) {
    for (std::size_t r = 0; r < rows; ++r) {
      double largest = 0.0;
      for (std::size_t line = 0; line < set.header.lines(); ++line)
        largest = std::max(largest, std::abs(set.values[set.index(line, r, c)]));
      for (std::size_t line = 0; line < set.header.lines(); ++line) {
        const Complex own = set.values[set.index(line, r, c)];
        for (std::size_t s = 0; s <= r; ++s) {
          Complex value = hammer * hammer * own * std::conj(set.values[set.index(line, s, c)]);
          if (r == s) value += sensor * sensor * largest * largest;
          set.covariance[(line * pairs + frf::pair_index(r, s)) * columns + c] = value;
          if (r == s) set.variance[set.index(line, r, c)] = 0.5 * Complex(value.real(), value.real());
        }
      }
    }
  }
  return set;
}

/// The same told by a factor, one column and a diagonal, in place of pairs.
inline frf::FrfSet factored(frf::FrfSet set) {
  const std::size_t rows = set.header.response.size(), columns = set.header.reference.size(), pairs = frf::pair_count(rows);
  set.factor.rank = 1;
  for (std::size_t i = 0; i < set.values.size(); ++i) {
    const std::size_t line = i / (rows * columns), r = i / columns % rows, c = i % columns;
    const double shared = std::norm(0.02 * set.values[i]);
    set.factor.rows.push_back(0.02 * set.values[i]);
    set.factor.diagonal.push_back(set.covariance[(line * pairs + frf::pair_index(r, r)) * columns + c].real() - shared);
  }
  set.covariance.clear();
  return set;
}

/// A set with errors: `hammer` of every FRF common to all responses to a blow, beside noise of each sensor, `sensor` of the rms of its
/// FRFs; `covariances`: it knows what they have in common, else their variances.
inline frf::FrfSet with_drawn_hammer_noise(const frf::FrfSet& exact, double hammer, double sensor, const RandomStream& stream,
                                           bool covariances) {
  frf::FrfSet out = exact;
  const std::size_t rows = out.header.response.size(), columns = out.header.reference.size();
  out.coherence.clear();
  out.header.noise = frf::NoiseRecord::variance;
  out.header.averages = 0.0;
  out.variance.assign(out.values.size(), 0.0);
  if (covariances) {
    out.factor = {.rank = 1, .rows = std::vector<Complex>(out.values.size()), .diagonal = std::vector<double>(out.values.size())};
  }
  const auto quantity = [&](std::size_t line) {
    return std::sqrt(frf::squared_factor(out.header.quantity, out.header.frequency_hz[line]));
  };
  const auto draw = [&](std::uint64_t at) {
    const auto pair = normal_numbers(stream, at);
    return Complex(pair[0], pair[1]) / std::sqrt(2.0);
  };
  for (std::size_t r = 0; r < rows; ++r) {
    double square = 0.0;
    for (std::size_t line = 0; line < out.header.lines(); ++line) {
      for (std::size_t c = 0; c < columns; ++c) square += std::norm(exact.values[out.index(line, r, c)] / quantity(line));
    }
    const double own = sensor * std::sqrt(square / static_cast<double>(out.header.lines() * columns));
    for (std::size_t i = 0; i < out.header.lines() * columns; ++i) {
      const std::size_t line = i / columns, at = out.index(line, r, i % columns);
      const Complex shared = hammer * exact.values[at];
      const double alone = own * quantity(line), half = 0.5 * (std::norm(shared) + alone * alone);
      out.values[at] += shared * draw(2 * i) + alone * draw(2 * at + 1);
      out.variance[at] = {half, half};
      if (!covariances) continue;
      out.factor.rows[at] = shared;
      out.factor.diagonal[at] = alone * alone;
    }
  }
  return out;
}

/// The exact FRFs of a problem with that noise told.
inline problems::Measurement with_hammer_noise(const problems::Problem& problem) {
  problems::Measurement out;
  for (const frf::FrfSet& set : problem.substructures) out.substructures.push_back(with_hammer_noise(set));
  out.assembly = with_hammer_noise(problem.assembly);
  return out;
}

}  // namespace jointid::ident
