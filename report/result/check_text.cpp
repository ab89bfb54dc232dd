#include "report/result/check_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "report/text/table.hpp"
#include "report/text/words.hpp"

namespace jointid::report {
namespace {

std::string verdict_text(const ident::CheckResult& result) {
  switch (result.verdict) {
    case ident::Verdict::clean:
      return "clean: reciprocity, driving points and the agreement of parts and assembly show no mistake\n";
    case ident::Verdict::suspicious:
      return "suspicious: something may be wrong with the data\n";
    case ident::Verdict::wrong:
      return "wrong: something is wrong with the data\n";
  }
  return {};
}

std::string in_percent_of_one(double confidence) { return std::to_string(static_cast<int>(100.0 * confidence)) + " %"; }

/// Each line after four blanks.
std::string indented(const std::string& lines) {
  std::string text = "    ";
  for (const char c : lines) text += c == '\n' ? "\n    " : std::string(1, c);
  return text + "\n";
}

/// Mean over the lines, and the lowest with its frequency.
std::string over_lines(const std::vector<double>& values, const std::vector<double>& frequency_hz) {
  if (values.empty()) return "–";
  const auto lowest = std::ranges::min_element(values);
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return fmt::format("{:.3f}, lowest {:.3f} at {:g} Hz", mean, *lowest,
                     frequency_hz[static_cast<std::size_t>(lowest - values.begin())]);
}

std::string lowest_channel(const virtualpoint::SideConsistency& side) {
  const auto lowest = std::ranges::min_element(side.specific);
  return fmt::format("{:.3f} {}", *lowest, side.dofs[static_cast<std::size_t>(lowest - side.specific.begin())].name());
}

/// How well the modes of virtual points explain the FRFs of their channels.
std::string virtual_points_text(const std::vector<virtualpoint::Consistency>& points) {
  if (points.empty()) return {};
  Table table({{"virtual point", Align::left},
               {"file", Align::left},
               {"", Align::left},
               {"lowest of a channel", Align::left},
               {"overall", Align::left},
               {"rigidity", Align::left}});
  for (const virtualpoint::Consistency& point : points) {
    for (const auto& [side, word] : {std::pair(&point.sensors, "sensors"), std::pair(&point.impacts, "impacts")}) {
      if (!side->any()) continue;
      table.add({point.point, point.file, std::to_string(side->dofs.size()) + " " + word, lowest_channel(*side),
                 over_lines(side->overall, point.frequency_hz), over_lines(point.rigidity, point.frequency_hz)});
    }
  }
  return "\nconsistency of virtual points (1: the virtual point explains the channels fully)\n\n" + table.text();
}

std::string note_paragraphs(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += "\nnote: " + note + "\n";
  return text;
}

/// A letter for the size of a difference: . below 3 %, then tens of percent, # from 95 %.
char size_letter(double share) {
  if (share < 0.03) return '.';
  const int tens = static_cast<int>(std::lround(10.0 * share));
  return tens > 9 ? '#' : static_cast<char>('0' + tens);
}

bool is_doubted(const ident::CheckResult& result, const std::string& file) {
  return std::ranges::any_of(result.suspects, [&](const ident::Suspect& suspect) { return suspect.file == file; });
}

/// H_ij − H_ji of files under suspicion, a letter for each pair.
std::string reciprocity_text(const ident::CheckResult& result) {
  constexpr std::size_t most = 40;
  std::string text;
  for (const ident::ReciprocityMap& map : result.reciprocity) {
    if (map.overall < 0.05 || map.rms.empty() || map.dofs.size() > most || !is_doubted(result, map.file)) continue;
    text += fmt::format("\nH_ij − H_ji over H in {}, {:.2g} % rms (. below 3 %, digits in tens of percent, # from 95 %)\n",
                        map.file, 100.0 * map.overall);
    for (std::size_t i = 0; i < map.dofs.size(); ++i) {
      text += fmt::format("{:>12}  ", map.dofs[i].name());
      for (std::size_t j = 0; j < map.dofs.size(); ++j) text += i == j ? '-' : size_letter(map.rms[i][j]);
      text += "\n";
    }
  }
  return text;
}

}  // namespace

std::string check_text(const ident::CheckResult& result) {
  std::string text = verdict_text(result);
  const std::string rest = reciprocity_text(result) + note_paragraphs(result.notes) + virtual_points_text(result.virtual_points);
  if (result.suspects.empty()) return text + rest;
  Table table(
      {{"", Align::right}, {"kind", Align::left}, {"file", Align::left}, {"DOFs", Align::left}, {"confidence", Align::right}});
  std::string details;
  for (std::size_t i = 0; i < result.suspects.size(); ++i) {
    const ident::Suspect& suspect = result.suspects[i];
    const std::string number = std::to_string(i + 1);
    table.add({number, ident::name(suspect.kind), suspect.file.empty() ? "–" : suspect.file,
               suspect.dofs.empty() ? "–" : dofs_text(suspect), in_percent_of_one(suspect.confidence)});
    details += "\n" + number + ". " + suspect.evidence + "\n";
    details += suspect.remedy.empty() ? "   remedy: measure again\n" : "   correction:\n" + indented(suspect.remedy);
  }
  return text + "\n" + table.text() + details + rest;
}

}  // namespace jointid::report
