#include "report/text/variances_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "report/text/table.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t most_files = 20;

/// Those of the same origin, under the name of the first.
std::vector<std::pair<std::string, std::string>> by_origin(const std::vector<ident::VarianceSource>& files) {
  std::vector<std::pair<std::string, std::string>> out;
  std::vector<std::size_t> count;
  for (const ident::VarianceSource& each : files) {
    const auto found = std::ranges::find(out, each.origin, &std::pair<std::string, std::string>::second);
    if (found == out.end()) {
      out.emplace_back(each.file, each.origin);
      count.push_back(1);
    } else {
      ++count[static_cast<std::size_t>(found - out.begin())];
    }
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (count[i] > 1) out[i].first += fmt::format(" and {} more", count[i] - 1);
  }
  return out;
}

/// A sentence of each file, the same one once.
std::string notes_of(const std::vector<ident::VarianceSource>& files) {
  std::vector<std::string> notes;
  for (const ident::VarianceSource& each : files) {
    if (!each.note.empty() && std::ranges::find(notes, each.note) == notes.end()) notes.push_back(each.note);
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(most_files, notes.size()); ++i) text += "  " + notes[i] + "\n";
  if (notes.size() > most_files) text += fmt::format("  {} more notes: --json\n", notes.size() - most_files);
  return text;
}

}  // namespace

std::string variances_text(const std::vector<ident::VarianceSource>& files) {
  if (files.empty()) return "";
  Table table({{"file", Align::left}, {"", Align::left}});
  if (files.size() > most_files) {
    for (const auto& [file, origin] : by_origin(files)) table.add({file, origin});
  } else {
    for (const ident::VarianceSource& each : files) table.add({each.file, each.origin});
  }
  return "\nvariances of the FRFs\n" + table.text() + notes_of(files);
}

}  // namespace jointid::report
