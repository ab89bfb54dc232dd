#include "study/order_statistics.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace jointid::study {
namespace {

constexpr unsigned word = 64, bits_per_pass = 11;
constexpr std::uint64_t sign = std::uint64_t{1} << (word - 1);

/// Integers in the order of the numbers: negative ones have all bits turned, the others the sign.
std::uint64_t image_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

double number_of(std::uint64_t image) {
  return std::bit_cast<double>((image & sign) != 0 ? image & ~sign : ~image);
}

/// Images that agree in their leading bits, and where they stand in the sorted column.
struct Group {
  std::uint64_t leading = 0;
  std::size_t first = 0, count = 0;

  bool holds(std::size_t place) const { return place >= first && place - first < count; }
};

/// The groups that hold the places, in ascending order, with `known` leading bits.
struct Candidates {
  unsigned known = 0;
  std::vector<Group> groups;

  std::size_t count() const {
    std::size_t sum = 0;
    for (const Group& group : groups) sum += group.count;
    return sum;
  }

  /// Calls visit(group number, image) for every number in one of the groups.
  template <class Visit>
  void each(const ColumnPass& column, const Visit& visit) const {
    column([&](std::span<const double> numbers) {
      for (const double x : numbers) {
        if (std::isnan(x)) continue;
        const std::uint64_t image = image_of(x), leading = known == 0 ? 0 : image >> (word - known);
        const auto found = std::ranges::lower_bound(groups, leading, {}, &Group::leading);
        if (found != groups.end() && found->leading == leading) visit(static_cast<std::size_t>(found - groups.begin()), image);
      }
    });
  }
};

/// A pass that gets to know the next bits.
Candidates narrowed(const Candidates& from, const ColumnPass& column, std::span<const std::size_t> places) {
  const unsigned bits = std::min(bits_per_pass, word - from.known), below = word - from.known - bits;
  const std::size_t bins = std::size_t{1} << bits;
  std::vector<std::size_t> histogram(from.groups.size() * bins, 0);
  from.each(column, [&](std::size_t group, std::uint64_t image) { ++histogram[group * bins + ((image >> below) & (bins - 1))]; });
  Candidates to{.known = from.known + bits, .groups = {}};
  for (std::size_t g = 0; g < from.groups.size(); ++g) {
    Group bin{.leading = from.groups[g].leading << bits, .first = from.groups[g].first, .count = 0};
    for (std::size_t b = 0; b < bins; ++b, ++bin.leading, bin.first += bin.count) {
      bin.count = histogram[g * bins + b];
      if (std::ranges::any_of(places, [&](std::size_t place) { return bin.holds(place); })) to.groups.push_back(bin);
    }
  }
  return to;
}

/// The images of each group, sorted.
std::vector<std::vector<std::uint64_t>> sorted(const Candidates& candidates, const ColumnPass& column) {
  std::vector<std::vector<std::uint64_t>> images(candidates.groups.size());
  for (std::size_t g = 0; g < images.size(); ++g) images[g].reserve(candidates.groups[g].count);
  candidates.each(column, [&](std::size_t group, std::uint64_t image) { images[group].push_back(image); });
  for (auto& group : images) std::ranges::sort(group);
  return images;
}

}  // namespace

std::size_t count_numbers(const ColumnPass& column) {
  std::size_t count = 0;
  column([&](std::span<const double> numbers) {
    count += static_cast<std::size_t>(std::ranges::count_if(numbers, [](double x) { return !std::isnan(x); }));
  });
  return count;
}

std::vector<double> order_statistics(const ColumnPass& column, std::span<const std::size_t> places, std::size_t most_kept) {
  Candidates candidates{.known = 0, .groups = {{.leading = 0, .first = 0, .count = count_numbers(column)}}};
  while (candidates.known < word && candidates.count() > most_kept) candidates = narrowed(candidates, column, places);
  const bool all_known = candidates.known == word;
  const auto images = all_known ? std::vector<std::vector<std::uint64_t>>() : sorted(candidates, column);
  std::vector<double> out;
  for (const std::size_t place : places) {
    const auto group = std::ranges::find_if(candidates.groups, [&](const Group& g) { return g.holds(place); });
    const auto number = static_cast<std::size_t>(group - candidates.groups.begin());
    out.push_back(number_of(all_known ? group->leading : images[number][place - group->first]));
  }
  return out;
}

}  // namespace jointid::study
