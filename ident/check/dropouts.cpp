#include "ident/check/dropouts.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/text.hpp"
#include "ident/check/test/reference_groups.hpp"

namespace jointid::ident {
namespace {

constexpr double dropout_confidence = 0.75;

using Lines = std::map<std::size_t, double>;

/// Lines that contradict the others, which agree. A group of references that differs does so at resonances most of all: no
/// dropouts.
std::vector<std::size_t> contradicting_lines(const Agreement& test, bool has_groups) {
  if (!(test.freedom > 0.0) || is_one_number(test)) return {};
  std::vector<std::size_t> lines = test.outlying_lines();
  if (lines.empty() || test.without(lines).contradicts()) return {};
  if (has_groups && !group_that_differs(test.cells).empty()) return {};
  return lines;
}

/// How far all FRFs of a file jump on a line, on average.
double mean_jump(const CheckedFile& file, std::size_t line) {
  double sum = 0.0, count = 0.0;
  for (const frf::Dof& response : file.responses) {
    for (const frf::Dof& reference : file.references) {
      const double each = jump(file, response, reference, line);
      if (!std::isfinite(each)) continue;
      sum += each;
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : 0.0;
}

/// "308, 324 and 2 more"
std::string frequencies(const CheckedFile& file, const Lines& lines) {
  constexpr std::size_t most = 6;
  std::string text;
  std::size_t count = 0;
  for (const auto& [line, ratio] : lines) {
    if (count < most) text += (count > 0 ? ", " : "") + digits(file.frequency_hz[line], "%.6g");
    ++count;
  }
  return count > most ? text + " and " + std::to_string(count - most) + " more" : text;
}

/// Ranges of neighbouring lines.
std::string ranges(const CheckedFile& file, const Lines& lines) {
  std::string text;
  for (auto first = lines.begin(); first != lines.end();) {
    auto last = first;
    for (auto next = std::next(last); next != lines.end() && next->first == last->first + 1; ++next) last = next;
    text += (text.empty() ? "[" : ", [") + digits(file.frequency_hz[first->first], "%.9g") + ", " +
            digits(file.frequency_hz[last->first], "%.9g") + "]";
    first = std::next(last);
  }
  return "[frequency]\nexclude = [" + text + "]";
}

}  // namespace

double jump(const CheckedFile& file, const frf::Dof& response, const frf::Dof& reference, std::size_t line) {
  const std::size_t r = place_of(file.responses, response), c = place_of(file.references, reference);
  if (r == frf::npos || c == frf::npos || line == 0 || line + 1 >= file.frfs.size()) return 0.0;
  const auto size = [&](std::size_t l) { return std::log(std::abs(file.frfs[l](at(r), at(c))) + 1e-300); };
  return std::abs(size(line) - 0.5 * (size(line - 1) + size(line + 1)));
}

bool is_one_number(const Agreement& test) { return test.worst_share > 0.6 && test.worst_ratio > 50.0; }

Agreement Dropouts::take_out(std::size_t file, Agreement mirror) {
  const std::vector<std::size_t> lines = contradicting_lines(mirror, true);
  for (const std::size_t line : lines) lines_[file][line] = mirror.by_line[line];
  return lines.empty() ? std::move(mirror) : mirror.without(lines);
}

Agreement Dropouts::take_out(const SpanSetup& setup, Agreement span) {
  const std::vector<std::size_t> lines = contradicting_lines(span, false);
  for (const std::size_t line : lines) {
    const auto known = [&](std::size_t file) { return lines_.contains(file) && lines_.at(file).contains(line); };
    if (known(setup.part) || known(setup.assembly)) continue;
    const bool of_part = mean_jump(files_[setup.part], line) > mean_jump(files_[setup.assembly], line);
    lines_[of_part ? setup.part : setup.assembly][line] = span.by_line[line];
  }
  return lines.empty() ? std::move(span) : span.without(lines);
}

std::vector<Suspect> Dropouts::suspects() const {
  std::vector<Suspect> found;
  for (const auto& [f, lines] : lines_) {
    const CheckedFile& file = files_[f];
    const double worst = std::ranges::max_element(lines, {}, [](const auto& each) { return each.second; })->second;
    found.push_back(
        {.kind = SuspectKind::outlier,
         .file = file.name,
         .dofs = {},
         .evidence = std::to_string(lines.size()) + " of " + std::to_string(file.frfs.size()) + " lines, at " +
                     frequencies(file, lines) + " Hz, are off by up to " + digits(std::sqrt(worst)) +
                     " times what noise makes of the others, which agree: a dropout, an overload, or no excitation there",
         .confidence = dropout_confidence,
         .remedy = ranges(file, lines)});
  }
  return found;
}

}  // namespace jointid::ident
