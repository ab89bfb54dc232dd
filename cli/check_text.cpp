#include "cli/check_text.hpp"

#include <nlohmann/json.hpp>

#include "cli/json_value.hpp"
#include "cli/table.hpp"

namespace jointid::cli {
namespace {

std::string dof_names(const std::vector<frf::Dof>& dofs) {
  std::string names;
  for (const frf::Dof& dof : dofs) names += (names.empty() ? "" : " ") + dof.name();
  return names.empty() ? "–" : names;
}

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
    table.add({number, ident::name(suspect.kind), suspect.file.empty() ? "–" : suspect.file, dof_names(suspect.dofs),
               in_percent_of_one(suspect.confidence)});
    details += "\n" + number + ". " + suspect.evidence + "\n";
    details += suspect.remedy.empty() ? "   measure it again\n" : "   to mend it:\n" + indented(suspect.remedy);
  }
  return text + "\n" + table.text() + details;
}

std::string check_json(const ident::CheckResult& result) {
  Json json = {{"verdict", ident::name(result.verdict)}};
  json["suspects"] = Json::array();
  for (const ident::Suspect& suspect : result.suspects) {
    Json dofs = Json::array();
    for (const frf::Dof& dof : suspect.dofs) dofs.push_back(dof.name());
    json["suspects"].push_back({{"kind", ident::name(suspect.kind)},
                                {"file", suspect.file},
                                {"dofs", dofs},
                                {"evidence", suspect.evidence},
                                {"confidence", value(suspect.confidence)},
                                {"remedy", suspect.remedy.empty() ? Json(nullptr) : Json(suspect.remedy)}});
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace jointid::cli
