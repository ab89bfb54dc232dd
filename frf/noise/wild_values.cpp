#include "frf/noise/wild_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace jointid::frf {
namespace {

constexpr double large_factor = 500.0, small_factor = 1000.0, rounding = 1e-10, no_resonance = 1e5, rise = 1.3, opposite = 0.7,
                 agreement = 1.0;
constexpr std::size_t fewest_neighbours = 3, most_runs = 100'000;

bool is_number(Complex h) { return !std::isnan(h.real()) && !std::isnan(h.imag()); }
bool is_infinite(Complex h) { return std::isinf(h.real()) || std::isinf(h.imag()); }

/// The lower middle one.
double typical_of(std::span<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<std::size_t> mirrors_of(const FrfHeader& header) {
  const std::size_t columns = header.reference.size();
  std::vector<std::size_t> row_of, column_of;  // of each reference its row, of each response its column
  for (const Dof& dof : header.reference) row_of.push_back(find_coordinate(header.response, dof));
  for (const Dof& dof : header.response) column_of.push_back(find_coordinate(header.reference, dof));
  std::vector<std::size_t> out(header.entries(), npos);
  for (std::size_t entry = 0; entry < out.size(); ++entry) {
    const std::size_t row = row_of[entry % columns], column = column_of[entry / columns];
    if (row != npos && column != npos && row * columns + column != entry) out[entry] = row * columns + column;
  }
  return out;
}

}  // namespace

WildSearch::WildSearch(const FrfHeader& header)
    : header_(header),
      mirror_(mirrors_of(header)),
      missing_(header.entries(), 0),
      open_(header.entries(), {npos, npos, npos, npos}) {
  for (auto& line : values_) line.resize(header.entries());
  for (auto& line : magnitudes_) line.resize(header.entries());
}

void WildSearch::add(std::span<const Complex> values) {
  const std::size_t entries = header_.entries();
  for (std::size_t at = 0; at + entries <= values.size(); at += entries) add_line(values.subspan(at, entries));
}

void WildSearch::add_line(std::span<const Complex> values) {
  const std::size_t line = lines_++;
  const bool counts = header_.frequency_hz[line] > 0.0;
  counted_lines_ += counts ? 1 : 0;
  std::ranges::copy(values, values_[line % kept].begin());
  std::vector<double>& magnitudes = magnitudes_[line % kept];
  double& maximum = maxima_[line % kept] = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double larger = std::max(std::abs(values[i].real()), std::abs(values[i].imag()));
    const bool finite = is_number(values[i]) && !std::isinf(larger);
    magnitudes[i] = finite && counts ? larger : std::numeric_limits<double>::quiet_NaN();
    maximum = finite && counts && larger > maximum ? larger : maximum;
    if (finite || !counts) continue;
    const bool infinite = is_infinite(values[i]);
    note(infinite ? WildKind::infinite : WildKind::not_a_number, line, i, 0.0);
    missing_[i] += infinite ? 0 : 1;
  }
  if (line >= reach) judge(judged_++);
}

/// Few values are looked at closely: those that a factor of some hundred stands between and the largest or least of their
/// neighbours.
void WildSearch::judge(std::size_t line) {
  if (!(header_.frequency_hz[line] > 0.0)) return;
  const std::size_t first = line - std::min(line, reach), last = std::min(line + reach, lines_ - 1);
  const std::vector<double>& own = magnitudes_[line % kept];
  std::vector<double> least(own.size(), std::numeric_limits<double>::infinity()), largest(own.size(), 0.0);
  for (std::size_t n = first; n <= last; ++n) {
    if (n == line) continue;
    const std::vector<double>& other = magnitudes_[n % kept];
    for (std::size_t i = 0; i < own.size(); ++i) {
      least[i] = other[i] < least[i] ? other[i] : least[i];
      largest[i] = other[i] > largest[i] ? other[i] : largest[i];
    }
  }
  std::vector<double> maxima;
  for (std::size_t n = first; n <= last; ++n) {
    if (n != line) maxima.push_back(maxima_[n % kept]);
  }
  const double floor = maxima.empty() ? 0.0 : rounding * typical_of(maxima);
  constexpr double close = 0.5 * large_factor;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i] > close * least[i] || own[i] * close < largest[i]) judge(line, i, floor);
  }
}

std::optional<WildSearch::Typical> WildSearch::typical(std::size_t line, std::size_t entry) const {
  const double f = header_.frequency_hz[line];
  std::array<double, 2 * reach> above{}, below{};
  std::size_t count = 0;
  for (std::size_t n = line - std::min(line, reach); n <= std::min(line + reach, lines_ - 1); ++n) {
    if (n == line || std::isnan(magnitude(n, entry))) continue;
    const double fall = (header_.frequency_hz[n] / f) * (header_.frequency_hz[n] / f), of = std::abs(value(n, entry));
    above[count] = of * std::max(1.0, fall);
    below[count++] = of * std::min(1.0, fall);
  }
  if (count < fewest_neighbours) return std::nullopt;
  return Typical{typical_of(std::span(above).first(count)), typical_of(std::span(below).first(count))};
}

void WildSearch::judge(std::size_t line, std::size_t entry, double floor) {
  const auto about = typical(line, entry);
  if (!about) return;
  const auto [under, over] = *about;
  const double size = std::abs(value(line, entry));
  if (under > 0.0 && size > std::max(large_factor * under, floor)) {
    const bool resonates = size <= no_resonance * under && is_resonance(line, entry);
    if (!resonates && !passes_joints(line, entry)) note(WildKind::large, line, entry, size / under);
  } else if (over > floor && size * small_factor < over && is_dropout(line, entry, over) && !mirror_falls(line, entry)) {
    note(WildKind::small, line, entry, size / over);
  }
}

const WildSearch::Ratios& WildSearch::ratios(std::size_t line) {
  constexpr double large = 0.01;
  if (ratios_ && ratios_->line == line) return *ratios_;
  ratios_ = Ratios{.line = line};
  std::vector<double> typicals;
  for (std::size_t i = 0; i < header_.entries(); ++i) {
    const auto about = std::isnan(magnitude(line, i)) ? std::nullopt : typical(line, i);
    typicals.push_back(about ? about->under : 0.0);
    ratios_->own.push_back(typicals[i] > 0.0 ? std::abs(value(line, i)) / typicals[i] : 0.0);
    ratios_->largest = std::max(ratios_->largest, typicals[i]);
  }
  std::vector<double> of_large;
  for (std::size_t i = 0; i < header_.entries(); ++i) {
    if (ratios_->own[i] > 0.0) ratios_->sorted.push_back(ratios_->own[i]);
    if (ratios_->own[i] > 0.0 && typicals[i] >= large * ratios_->largest) of_large.push_back(ratios_->own[i]);
  }
  std::ranges::sort(ratios_->sorted);
  if (!of_large.empty()) ratios_->of_large = typical_of(of_large);
  return *ratios_;
}

/// Each joint that a wave passes multiplies what it loses on the lines beside, so that no number is too large for a long row.
/// FRFs about the force hardly change.
bool WildSearch::passes_joints(std::size_t line, std::size_t entry) {
  constexpr double high = 10.0, of_the_same_kind = 0.01;
  const Ratios& all = ratios(line);
  const double own = all.own[entry];
  const auto others_above = [&](double least) {
    const auto count = static_cast<std::size_t>(all.sorted.end() - std::ranges::upper_bound(all.sorted, least));
    return count - (own > least ? 1 : 0);
  };
  return std::abs(value(line, entry)) < large_factor * all.largest && all.of_large < large_factor &&
         3 * others_above(high) >= all.sorted.size() - 1 && others_above(of_the_same_kind * own) > 1;
}

bool WildSearch::is_resonance(std::size_t line, std::size_t entry) {
  if (line < 2 || line + 2 >= lines_) return others_rise(line, entry);
  const Complex left = value(line - 1, entry), right = value(line + 1, entry);
  return std::abs(left) >= rise * std::abs(value(line - 2, entry)) &&
         std::abs(right) >= rise * std::abs(value(line + 2, entry)) && std::abs(left + right) < opposite * std::abs(left - right);
}

std::optional<bool> WildSearch::rises(std::size_t line, std::size_t entry) const {
  constexpr double high = 10.0;
  double beside = 0.0;
  if (line > 0 && magnitude(line - 1, entry) > beside) beside = magnitude(line - 1, entry);
  if (line + 1 < lines_ && magnitude(line + 1, entry) > beside) beside = magnitude(line + 1, entry);
  if (!(beside > 0.0) || std::isnan(magnitude(line, entry))) return std::nullopt;
  return magnitude(line, entry) > high * beside;
}

/// A resonance that falls on one line lifts most FRFs.
bool WildSearch::others_rise(std::size_t line, std::size_t entry) {
  if (!rise_ || rise_->line != line) {
    rise_ = Rise{.line = line};
    for (std::size_t i = 0; i < header_.entries(); ++i) {
      const std::optional<bool> rise = rises(line, i);
      rise_->compared += rise ? 1U : 0U;
      rise_->risen += rise.value_or(false) ? 1U : 0U;
    }
  }
  const std::optional<bool> own = rises(line, entry);
  const std::size_t risen = rise_->risen - (own.value_or(false) ? 1 : 0), others = rise_->compared - (own ? 1 : 0);
  return risen > 0 && 3 * risen >= others;
}

bool WildSearch::mirror_falls(std::size_t line, std::size_t entry) const {
  constexpr double low = 30.0;
  const std::size_t mirror = mirror_[entry];
  if (mirror == npos || line == 0 || line + 1 >= lines_) return false;
  return low * magnitude(line, mirror) < std::min(magnitude(line - 1, mirror), magnitude(line + 1, mirror));
}

bool WildSearch::is_dropout(std::size_t line, std::size_t entry, double typical) const {
  const auto nearest = [&](int step) {
    for (std::size_t k = 1; k <= reach; ++k) {
      if ((step < 0 && k > line) || (step > 0 && line + k >= lines_)) break;
      const std::size_t n = step < 0 ? line - k : line + k;
      if (magnitude(n, entry) * small_factor > typical) return std::optional(value(n, entry));
    }
    return std::optional<Complex>();
  };
  const auto left = nearest(-1), right = nearest(+1);
  return left && right && std::abs(*left - *right) <= agreement * 0.5 * std::abs(*left + *right);
}

/// Goes on with a run, or begins one.
void WildSearch::note(WildKind kind, std::size_t line, std::size_t entry, double factor) {
  std::size_t& run = open_[entry][static_cast<std::size_t>(kind)];
  if (run != npos && found_[run].last_line + 1 == line) {
    WildValue& known = found_[run];
    known.last_line = line;
    known.factor = kind == WildKind::small ? std::min(known.factor, factor) : std::max(known.factor, factor);
    return;
  }
  if (found_.size() >= most_runs) {
    run = npos;
    ++more_;
    return;
  }
  run = found_.size();
  const std::size_t columns = header_.reference.size();
  found_.push_back({kind, entry / columns, entry % columns, line, line, value(line, entry), factor});
}

/// Runs of all FRFs on the same lines become one.
void WildSearch::join_common(std::vector<WildValue>& runs) const {
  const auto filled =
      static_cast<std::size_t>(std::ranges::count_if(missing_, [&](std::size_t n) { return n < counted_lines_; }));
  const auto place = [](const WildValue& run) { return std::tuple(run.kind, run.line, run.last_line); };
  std::map<std::tuple<WildKind, std::size_t, std::size_t>, std::size_t> counts;
  for (const WildValue& run : runs) ++counts[place(run)];
  std::vector<WildValue> joined;
  for (WildValue& run : runs) {
    std::size_t& count = counts[place(run)];
    if (filled < 2 || count < filled) {
      if (count > 0 || filled < 2) joined.push_back(run);
      continue;
    }
    count = 0;
    run.response = run.reference = npos;
    joined.push_back(run);
  }
  runs = std::move(joined);
}

WildValues WildSearch::finish() {
  for (; judged_ < lines_; ++judged_) judge(judged_);
  const std::size_t columns = header_.reference.size();
  std::erase_if(found_, [&](const WildValue& run) {
    return run.kind == WildKind::not_a_number && missing_[run.response * columns + run.reference] == counted_lines_;
  });
  join_common(found_);
  std::ranges::stable_sort(found_, {},
                           [](const WildValue& run) { return std::tuple(run.kind, run.line, run.response, run.reference); });
  WildValues out{std::move(found_), more_, true};
  if (out.found.size() > most_wild_values) {
    out.more += out.found.size() - most_wild_values;
    out.found.resize(most_wild_values);
  }
  return out;
}

}  // namespace jointid::frf
