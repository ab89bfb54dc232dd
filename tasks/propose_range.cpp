#include "tasks/propose_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/control.hpp"
#include "base/error.hpp"
#include "base/statistics.hpp"
#include "base/text.hpp"

namespace jointid::tasks {
namespace {

using Range = std::array<double, 2>;
using Indices = std::vector<std::size_t>;

constexpr std::size_t most_per_side = 8;  // 64 FRFs of a file
constexpr double least_coherence = 0.5;
constexpr double largest_deviation = 0.5;  // over |H|

/// At most `most` of the numbers from `first` to before `end`, ends included.
Indices evenly(std::size_t first, std::size_t end, std::size_t most) {
  const std::size_t count = std::min(end - first, most);
  Indices all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(count == 1 ? first : first + i * (end - first - 1) / (count - 1));
  return all;
}

Range common_range(const std::vector<frf::FrfSource*>& files) {
  Range range = {0.0, std::numeric_limits<double>::infinity()};
  for (const frf::FrfSource* file : files) {
    const std::vector<double>& axis = file->header().frequency_hz;
    const double first = axis.front() > 0.0 || axis.size() == 1 ? axis.front() : axis[1];
    range = {std::max(range[0], first), std::min(range[1], axis.back())};
  }
  if (!(range[0] <= range[1])) {
    throw InputError({ErrorKind::data, "", "new scene", "the files have no frequencies in common",
                      "measure parts and assembly over the same lines"});
  }
  return range;
}

/// Whether the FRFs of each line are above their noise, by the median over FRFs.
std::vector<bool> good_lines(frf::FrfSource& file, const Indices& lines) {
  const frf::FrfHeader& header = file.header();
  const Indices responses = evenly(0, header.response.size(), most_per_side),
                references = evenly(0, header.reference.size(), most_per_side);
  const frf::Block block{lines, responses, references};
  std::vector<double> figures(block.size());
  if (header.noise == frf::NoiseRecord::coherence) {
    file.read_coherence(block, figures);
    for (double& figure : figures) figure = 1.0 - figure;
  } else {
    std::vector<Complex> values(block.size()), variances(block.size());
    file.read(block, values);
    file.read_variance(block, variances);
    for (std::size_t i = 0; i < figures.size(); ++i) {
      figures[i] = std::sqrt(variances[i].real() + variances[i].imag()) / std::abs(values[i]);
    }
  }
  const double limit = header.noise == frf::NoiseRecord::coherence ? 1.0 - least_coherence : largest_deviation;
  const std::size_t per_line = responses.size() * references.size();
  std::vector<bool> good;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    std::vector<double> of_line;
    for (std::size_t i = line * per_line; i < (line + 1) * per_line; ++i) {
      if (std::isfinite(figures[i])) of_line.push_back(figures[i]);
    }
    good.push_back(!of_line.empty() && median(of_line) <= limit);
  }
  return good;
}

/// The range without bad ends; unchanged where all is bad, or nothing is known.
Range without_noise(frf::FrfSource& file, Range range, std::size_t most_lines) {
  const std::vector<double>& axis = file.header().frequency_hz;
  if (file.header().noise == frf::NoiseRecord::none) return range;
  const auto begin = static_cast<std::size_t>(std::ranges::lower_bound(axis, range[0]) - axis.begin());
  const auto end = static_cast<std::size_t>(std::ranges::upper_bound(axis, range[1]) - axis.begin());
  if (begin >= end) return range;
  const Indices lines = evenly(begin, end, most_lines);
  const std::vector<bool> good = good_lines(file, lines);
  const auto first = std::ranges::find(good, true);
  if (first == good.end()) return range;
  const auto last = std::find(good.rbegin(), good.rend(), true);
  const double low = axis[lines[static_cast<std::size_t>(first - good.begin())]];
  const double high = axis[lines[static_cast<std::size_t>(good.rend() - last) - 1]];
  return {first == good.begin() ? range[0] : low, last == good.rbegin() ? range[1] : high};
}

std::string text(const Range& range) { return digits(range[0], "%.10g") + " to " + digits(range[1], "%.10g") + " Hz"; }

}  // namespace

ProposedRange propose_range(const std::vector<frf::FrfSource*>& files, const std::function<bool()>& interrupted,
                            std::size_t most_lines) {
  const Range common = common_range(files);
  Range range = common;
  bool known = false;
  for (frf::FrfSource* file : files) {
    stop_if(interrupted);
    known |= file->header().noise != frf::NoiseRecord::none;
    const Range own = without_noise(*file, common, most_lines);
    range = {std::max(range[0], own[0]), std::min(range[1], own[1])};
  }
  if (!(range[0] < range[1])) range = common;
  ProposedRange proposed;
  if (range[0] < range[1]) proposed.range_hz = range;
  std::string reason = "Range: " + text(common) + " is in all files";
  if (range != common)
    reason += "; outside " + text(range) + " noise rules (median coherence below 0.5, or deviation above half of |H|)";
  else
    reason += known ? ", and noise rules at neither end." : "; no file states its noise.";
  proposed.reasons.push_back(reason + (range != common ? "." : ""));
  return proposed;
}

}  // namespace jointid::tasks
