#include "tasks/couple/couple_frfs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/statistics.hpp"
#include "frf/hdf5/hdf5_file.hpp"

namespace jointid::tasks {
namespace {

using ComplexValues = std::vector<std::complex<double>>;
using Entry = std::array<std::size_t, 2>;  ///< indices of response and reference

constexpr std::size_t lines_at_once = 64;
constexpr double same_frequency = 1e-6;  ///< of the frequency

/// Point FRFs, then the others row by row.
std::vector<Entry> choose(const frf::FrfHeader& header, std::size_t most) {
  std::vector<Entry> out, others;
  for (std::size_t r = 0; r < header.response.size(); ++r) {
    const std::size_t point = frf::find_coordinate(header.reference, header.response[r]);
    if (point != frf::npos) out.push_back({r, point});
    for (std::size_t c = 0; c < header.reference.size() && others.size() < most; ++c) {
      if (c != point) others.push_back({r, c});
    }
  }
  out.insert(out.end(), others.begin(), others.end());
  out.resize(std::min(most, out.size()));
  return out;
}

std::vector<std::size_t> distinct(const std::vector<Entry>& entries, std::size_t role) {
  std::vector<std::size_t> out;
  for (const Entry& entry : entries) {
    if (std::ranges::find(out, entry[role]) == out.end()) out.push_back(entry[role]);
  }
  return out;
}

std::size_t place(const std::vector<std::size_t>& among, std::size_t index) {
  return static_cast<std::size_t>(std::ranges::find(among, index) - among.begin());
}

/// Entries over all lines, a piece of lines at a time; read(block, values) fills a block.
template <class Read>
std::vector<ComplexValues> read_entries(const frf::FrfHeader& header, const std::vector<Entry>& entries, Read read) {
  const std::vector<std::size_t> rows = distinct(entries, 0), columns = distinct(entries, 1);
  std::vector<ComplexValues> out(entries.size());
  for (std::size_t first = 0; first < header.lines(); first += lines_at_once) {
    std::vector<std::size_t> lines;
    for (std::size_t line = first; line < std::min(first + lines_at_once, header.lines()); ++line) lines.push_back(line);
    const frf::Block block{lines, rows, columns};
    ComplexValues values(block.size());
    read(block, values);
    for (std::size_t e = 0; e < entries.size(); ++e) {
      const std::size_t at = place(rows, entries[e][0]) * columns.size() + place(columns, entries[e][1]);
      for (std::size_t i = 0; i < lines.size(); ++i) out[e].push_back(values[i * rows.size() * columns.size() + at]);
    }
  }
  return out;
}

/// Of each frequency the line of `axis` that is the same, or npos. Both ascend.
std::vector<std::size_t> lines_at(const std::vector<double>& axis, const std::vector<double>& frequency_hz) {
  std::vector<std::size_t> out;
  for (const double f : frequency_hz) {
    const auto at = std::ranges::lower_bound(axis, f * (1.0 - same_frequency));
    out.push_back(at != axis.end() && *at <= f * (1.0 + same_frequency) ? static_cast<std::size_t>(at - axis.begin())
                                                                        : frf::npos);
  }
  return out;
}

std::vector<ComplexValues> read_values(frf::FrfSource& source, const std::vector<Entry>& entries) {
  return read_entries(source.header(), entries,
                      [&](const frf::Block& block, ComplexValues& values) { source.read(block, values); });
}

std::vector<PredictedFrf> predicted(frf::FrfSource& source, frf::FrfSource* all_conditions, std::size_t most) {
  const frf::FrfHeader& header = source.header();
  const std::vector<Entry> entries = choose(header, most);
  std::vector<ComplexValues> values = read_values(source, entries), variances, with_all;
  if (header.noise == frf::NoiseRecord::variance) {
    variances =
        read_entries(header, entries, [&](const frf::Block& block, ComplexValues& to) { source.read_variance(block, to); });
  }
  if (all_conditions != nullptr) with_all = read_values(*all_conditions, entries);
  std::vector<PredictedFrf> out;
  for (std::size_t e = 0; e < entries.size(); ++e) {
    out.push_back({header.response[entries[e][0]], header.reference[entries[e][1]], std::move(values[e]), {}, {}, {}});
    if (!variances.empty()) out.back().variance = std::move(variances[e]);
    if (!with_all.empty()) out.back().with_all = std::move(with_all[e]);
  }
  return out;
}

/// A set that outlives the source.
std::unique_ptr<frf::FrfSource> source_on(const frf::FrfSet& set) {
  return frf::from_shared(std::shared_ptr<const frf::FrfSet>(std::shared_ptr<void>(), &set));
}

}  // namespace

std::vector<PredictedFrf> read_predicted(const CoupleResult& result, std::size_t most) {
  const auto all = result.with_all ? frf::open_hdf5(result.with_all->path) : nullptr;
  return predicted(*frf::open_hdf5(result.result.path), all.get(), most);
}

std::vector<PredictedFrf> predicted_of(const CoupledSets& coupled, std::size_t most) {
  if (coupled.frfs.header.lines() == 0) return {};
  const auto all = coupled.with_all ? source_on(*coupled.with_all) : nullptr;
  return predicted(*source_on(coupled.frfs), all.get(), most);
}

void compare_with(frf::FrfSource& measured, const std::vector<double>& frequency_hz, std::vector<PredictedFrf>& frfs) {
  const frf::FrfHeader& header = measured.header();
  const std::vector<std::size_t> lines = lines_at(header.frequency_hz, frequency_hz);
  for (PredictedFrf& frf : frfs) {
    const std::size_t response = frf::find_coordinate(header.response, frf.response),
                      reference = frf::find_coordinate(header.reference, frf.reference);
    if (response == frf::npos || reference == frf::npos) continue;
    const double sign =
        frf.response.sign * frf.reference.sign * header.response[response].sign * header.reference[reference].sign;
    const ComplexValues all = read_values(measured, {{response, reference}}).front();
    frf.measured.assign(frequency_hz.size(), {nan, nan});
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i] != frf::npos) frf.measured[i] = sign * all[lines[i]];
    }
  }
}

double error_db(const PredictedFrf& frf) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < frf.measured.size(); ++i) {
    const double level = 20.0 * std::log10(std::abs(frf.value[i]) / std::abs(frf.measured[i]));
    if (!std::isfinite(level)) continue;
    sum += level * level;
    ++count;
  }
  return count == 0 ? nan : std::sqrt(sum / static_cast<double>(count));
}

}  // namespace jointid::tasks
