#include "frf/set/merged_set.hpp"

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"
#include "frf/set/frf_source.hpp"
#include "frf/set/frf_system.hpp"
#include "frf/set/recorded_variance.hpp"

namespace jointid::frf {
namespace {

void add_dofs(std::vector<Dof>& to, const std::vector<Dof>& from) {
  for (const Dof& dof : from) {
    if (!has(to, dof)) to.push_back(dof);
  }
}

/// 0 where a set does not say it.
double fewest_averages(const std::vector<FrfSet>& sets) {
  return std::ranges::min(sets, {}, [](const FrfSet& set) { return set.header.averages; }).header.averages;
}

/// Columns of the factors of all sets that have a reference.
std::size_t rank_of(const std::vector<FrfSet>& sets, const Dof& reference) {
  std::size_t rank = 0;
  for (const FrfSet& set : sets) rank += has(set.header.reference, reference) ? set.factor.rank : 0;
  return rank;
}

/// NaN: nothing is known yet.
void make_room_for_covariance(const std::vector<FrfSet>& sets, FrfSet& out) {
  if (std::ranges::none_of(sets, &FrfSet::has_covariance)) return;
  out.header.averages = fewest_averages(sets);
  if (std::ranges::any_of(sets, [](const FrfSet& set) { return !set.covariance.empty(); })) {
    out.covariance.assign(out.header.lines() * pair_count(out.header.response.size()) * out.header.reference.size(), {nan, nan});
    return;
  }
  for (const Dof& reference : out.header.reference) out.factor.rank = std::max(out.factor.rank, rank_of(sets, reference));
  out.factor.rows.assign(out.values.size() * out.factor.rank, {nan, nan});
  const auto needs_diagonal = [](const FrfSet& set) { return !set.factor.any() || !set.factor.diagonal.empty(); };
  if (std::ranges::any_of(sets, needs_diagonal)) out.factor.diagonal.assign(out.values.size(), nan);
}

/// Doubts of all sets, each once; where these are of several files, with the name of its own.
std::vector<std::string> all_doubts(const std::vector<FrfSet>& sets) {
  const std::string& first = sets.front().header.file;
  const bool one_file = std::ranges::all_of(sets, [&](const FrfSet& set) { return set.header.file == first; });
  std::vector<std::string> doubts;
  for (const FrfSet& set : sets) {
    for (const std::string& doubt : set.header.doubts) {
      const std::string told = one_file ? doubt : set.header.file + ": " + doubt;
      if (std::ranges::find(doubts, told) == doubts.end()) doubts.push_back(told);
    }
  }
  return doubts;
}

FrfSet empty_union(const std::vector<FrfSet>& sets) {
  FrfSet out;
  out.header = sets.front().header;
  out.header.doubts = all_doubts(sets);
  for (const FrfSet& set : sets) {
    add_dofs(out.header.response, set.header.response);
    add_dofs(out.header.reference, set.header.reference);
    for (const Node& node : set.header.nodes) {
      const bool known = std::ranges::any_of(out.header.nodes, [&](const Node& other) { return other.id == node.id; });
      if (!known) out.header.nodes.push_back(node);
    }
  }
  const bool noise = std::ranges::all_of(sets, knows_noise);
  out.header.noise = noise ? NoiseRecord::variance : NoiseRecord::none;
  out.header.averages = 0.0;
  out.header.repeats = 0;
  out.values.assign(out.header.lines() * out.header.entries(), {nan, nan});
  if (noise) out.variance = out.values;
  if (noise) make_room_for_covariance(sets, out);
  return out;
}

void require_same_lines(const FrfSet& first, const FrfSet& set) {
  const auto partners = match_lines(first.header.frequency_hz, set.header.frequency_hz);
  if (first.header.lines() == set.header.lines() && std::ranges::find(partners, npos) == partners.end()) return;
  fail(set.header, "frequency", "its lines, " + range_text(set.header.frequency_hz) + ", are not those of " + first.header.file + ", " +
       range_text(first.header.frequency_hz), "measure or convert them to one axis");
}

/// What places of a set are in the union.
struct Places {
  std::vector<std::size_t> row, column;
  std::vector<double> row_sign;
};

Places places_of(const FrfSet& set, const FrfSet& out) {
  Places places;
  for (const Dof& response : set.header.response) {
    places.row.push_back(find_coordinate(out.header.response, response));
    places.row_sign.push_back(response.sign * out.header.response[places.row.back()].sign);
  }
  for (const Dof& reference : set.header.reference) places.column.push_back(find_coordinate(out.header.reference, reference));
  return places;
}

/// Errors of different sets are independent; a set without covariances tells the variances alone.
void put_covariance(const FrfSet& set, FrfSet& out) {
  const Places places = places_of(set, out);
  const std::vector<Complex> covariance = covariance_pairs(set);
  const std::size_t columns = set.header.reference.size(), pairs = pair_count(set.header.response.size()),
                    all_columns = out.header.reference.size(), all_pairs = pair_count(out.header.response.size());
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t r = 0; r < places.row.size(); ++r) {
        for (std::size_t s = 0; s <= r; ++s) {
          const std::size_t row = places.row[r], other = places.row[s];
          if (std::isnan(set.values[set.index(line, r, c)].real()) || std::isnan(set.values[set.index(line, s, c)].real())) continue;
          Complex value = 0.0;
          if (!covariance.empty()) {
            value = places.row_sign[r] * places.row_sign[s] * covariance[(line * pairs + pair_index(r, s)) * columns + c];
          } else if (r == s) {
            const Complex variance = recorded_variance(set, set.index(line, r, c));
            value = variance.real() + variance.imag();
          }
          out.covariance[(line * all_pairs + pair_index(std::max(row, other), std::min(row, other))) * all_columns + places.column[c]] =
              row < other ? std::conj(value) : value;
        }
      }
    }
  }
}

/// The same into factors: columns of this set's from `first` on, [C] of the union, which is moved behind them; the others are zero.
void put_factor(const FrfSet& set, std::vector<std::size_t>& first, FrfSet& out) {
  const Places places = places_of(set, out);
  const std::size_t rank = set.factor.rank, columns = set.header.reference.size(), all_rank = out.factor.rank,
                    all_columns = out.header.reference.size();
  const auto put_error = [&](std::size_t line, std::size_t r, std::size_t c) {
    const std::size_t from = set.index(line, r, 0), column = places.column[c], to = out.index(line, places.row[r], 0);
    for (std::size_t k = 0; k < all_rank; ++k) out.factor.rows[to * all_rank + k * all_columns + column] = 0.0;
    for (std::size_t k = 0; k < rank; ++k) {
      out.factor.rows[to * all_rank + (first[column] + k) * all_columns + column] =
          places.row_sign[r] * set.factor.rows[from * rank + k * columns + c];
    }
    const Complex variance = recorded_variance(set, from + c);
    double own = set.factor.any() ? 0.0 : variance.real() + variance.imag();
    if (!set.factor.diagonal.empty()) own = set.factor.diagonal[from + c];
    if (!out.factor.diagonal.empty()) out.factor.diagonal[to + column] = own;
  };
  const auto is_unknown = [&](std::size_t line, std::size_t r, std::size_t c) {
    if (rank > 0) return std::isnan(set.factor.rows[set.index(line, r, 0) * rank + c].real());
    return std::isnan(recorded_variance(set, set.index(line, r, c)).real());
  };
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t r = 0; r < places.row.size(); ++r) {
      for (std::size_t c = 0; c < columns; ++c) {
        if (!std::isnan(set.values[set.index(line, r, c)].real()) && !is_unknown(line, r, c)) put_error(line, r, c);
      }
    }
  }
  for (const std::size_t column : places.column) first[column] += rank;
}

/// What references of one set have in common that no other set has, too.
void put_reference_correlation(const std::vector<FrfSet>& sets, FrfSet& out) {
  const std::size_t size = out.header.reference.size();
  const auto is_of_one = [&](const Dof& reference) {
    return std::ranges::count_if(sets, [&](const FrfSet& set) { return has(set.header.reference, reference); }) == 1;
  };
  for (const FrfSet& set : sets) {
    if (set.reference_correlation.empty()) continue;
    const std::vector<Dof>& own = set.header.reference;
    for (std::size_t line = 0; line < set.header.lines(); ++line) {
      for (std::size_t c = 0; c < own.size(); ++c) {
        for (std::size_t d = 0; d < own.size(); ++d) {
          if (c == d || !is_of_one(own[c]) || !is_of_one(own[d])) continue;
          if (out.reference_correlation.empty()) {
            out.reference_correlation.assign(out.header.lines() * size * size, 0.0);
            for (std::size_t i = 0; i < out.header.lines() * size; ++i) out.reference_correlation[i * size + i % size] = 1.0;
          }
          const std::size_t row = find_coordinate(out.header.reference, own[c]),
                            column = find_coordinate(out.header.reference, own[d]);
          out.reference_correlation[(line * size + row) * size + column] =
              set.reference_correlation[(line * own.size() + c) * own.size() + d];
        }
      }
    }
  }
}

/// Between FRFs to one reference that are of different sets.
void put_independence(FrfSet& out) {
  const std::size_t rows = out.header.response.size(), columns = out.header.reference.size(), pairs = pair_count(rows);
  for (std::size_t line = 0; line < out.header.lines(); ++line) {
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t s = 0; s < r; ++s) {
          Complex& value = out.covariance[(line * pairs + pair_index(r, s)) * columns + c];
          const bool known = !std::isnan(out.values[out.index(line, r, c)].real()) && !std::isnan(out.values[out.index(line, s, c)].real());
          if (known && std::isnan(value.real())) value = 0.0;
        }
      }
    }
  }
}

void put(const FrfSet& set, FrfSet& out) {
  for (std::size_t r = 0; r < set.header.response.size(); ++r) {
    const Dof& response = set.header.response[r];
    const std::size_t row = find_coordinate(out.header.response, response);
    for (std::size_t c = 0; c < set.header.reference.size(); ++c) {
      const Dof& reference = set.header.reference[c];
      const std::size_t column = find_coordinate(out.header.reference, reference);
      const double sign = response.sign * out.header.response[row].sign * reference.sign * out.header.reference[column].sign;
      for (std::size_t line = 0; line < set.header.lines(); ++line) {
        const std::size_t from = set.index(line, r, c), to = out.index(line, row, column);
        if (std::isnan(set.values[from].real())) continue;
        if (!std::isnan(out.values[to].real())) {
          fail(set.header, "FRF " + response.name() + " / " + reference.name(), "another file has it, too", "keep it in one file");
        }
        out.values[to] = sign * set.values[from];
        if (!out.variance.empty()) out.variance[to] = recorded_variance(set, from);
      }
    }
  }
}

}  // namespace

FrfSet merged(std::vector<FrfSet> sets) {
  if (sets.size() == 1) return std::move(sets.front());
  for (const FrfSet& set : sets) require_same_lines(sets.front(), set);
  FrfSet out = empty_union(sets);
  for (const FrfSet& set : sets) put(set, out);
  std::vector<std::size_t> first(out.header.reference.size());
  for (const FrfSet& set : sets) {
    if (out.factor.any()) put_factor(set, first, out);
  }
  if (out.header.noise == NoiseRecord::variance) put_reference_correlation(sets, out);
  if (out.covariance.empty()) return out;
  for (const FrfSet& set : sets) put_covariance(set, out);
  put_independence(out);
  return out;
}

}  // namespace jointid::frf
