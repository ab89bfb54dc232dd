#pragma once

#include <algorithm>
#include <cmath>

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
      for (std::size_t line = 0; line < set.header.lines(); ++line) largest = std::max(largest, std::abs(set.values[set.index(line, r, c)]));
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

/// The exact FRFs of a problem with that noise told.
inline problems::Measurement with_hammer_noise(const problems::Problem& problem) {
  problems::Measurement out;
  for (const frf::FrfSet& set : problem.substructures) out.substructures.push_back(with_hammer_noise(set));
  out.assembly = with_hammer_noise(problem.assembly);
  return out;
}

}  // namespace jointid::ident
