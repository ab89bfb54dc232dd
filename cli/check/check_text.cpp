#include "cli/check/check_text.hpp"

#include "cli/text/table.hpp"
#include "cli/text/words.hpp"

namespace jointid::cli {
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

}  // namespace

std::string check_text(const ident::CheckResult& result) {
  std::string text = verdict_text(result);
  if (result.suspects.empty()) return text;
  Table table(
      {{"", Align::right}, {"kind", Align::left}, {"file", Align::left}, {"DOFs", Align::left}, {"confidence", Align::right}});
  std::string details;
  for (std::size_t i = 0; i < result.suspects.size(); ++i) {
    const ident::Suspect& suspect = result.suspects[i];
    const std::string number = std::to_string(i + 1);
    table.add({number, ident::name(suspect.kind), suspect.file.empty() ? "–" : suspect.file,
               suspect.dofs.empty() ? "–" : dofs_text(suspect), in_percent_of_one(suspect.confidence)});
    details += "\n" + number + ". " + suspect.evidence + "\n";
    details += suspect.remedy.empty() ? "   measure it again\n" : "   to mend it:\n" + indented(suspect.remedy);
  }
  return text + "\n" + table.text() + details;
}

}  // namespace jointid::cli
