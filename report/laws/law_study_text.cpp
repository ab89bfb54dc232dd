#include "report/laws/law_study_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "laws/task/identify_laws.hpp"
#include "report/json_value.hpp"
#include "report/text/notes.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

using laws::StudiedValue;

double coverage(const StudiedValue& value) { return static_cast<double>(value.covered) / static_cast<double>(value.trials); }

std::string counts(const std::map<std::string, std::size_t>& of) {
  return comma_list(of, [](const auto& counted) { return counted.first + " " + std::to_string(counted.second); });
}

}  // namespace

Table law_values_table(const laws::LawStudy& study) {
  Table table({{"joint", Align::left},
               {"", Align::left},
               {"truth"},
               {"unit", Align::left},
               {"bound"},
               {"rms error"},
               {"rms/bound"},
               {"bias"},
               {"coverage"},
               {"trials"}});
  for (const StudiedValue& value : study.values) {
    if (!std::isfinite(value.truth)) continue;
    const bool told = value.trials > 0, bounded = std::isfinite(value.bound);
    table.add({value.joint, value.name, number(value.truth, value.bound), value.unit,
               bounded ? fmt::format("{:.2g}", value.bound) : "–", told ? fmt::format("{:.2g}", value.rms_error) : "–",
               told && bounded ? fmt::format("{:.2f}", value.rms_error / value.bound) : "–",
               told ? fmt::format("{:.1g}", value.bias) : "–", told ? fmt::format("{:.3f}", coverage(value)) : "–",
               std::to_string(value.trials)});
  }
  return table;
}

std::string law_study_summary(const laws::LawStudy& study) {
  std::string text = fmt::format("{} trials, {} usable; laws {}: {}\n", study.trials, study.usable,
                                 study.assumed ? "assumed" : "found from the measured levels", laws::laws_text(study.laws));
  text += "status: " + counts(study.statuses) + "\n";
  if (!study.chosen.empty()) {
    text += "model selection (AIC): " + counts(study.chosen) + "\n";
    text += fmt::format("the true laws in {} of {} trials, others equally good in {}, the true ones ruled out in {}\n",
                        study.right, study.usable, study.undecided, study.missed);
  }
  return text + fmt::format("χ² over its freedom {}, data that contradict each other in {} trials\n",
                            study.usable > 0 ? fmt::format("{:.3f}", study.chi_square) : "–", study.contradicting);
}

std::string law_study_text(const laws::LawScene& scene, const laws::LawStudy& study) {
  std::string text = (scene.title.empty() ? "" : scene.title + "\n") + law_study_summary(study) + "\n";
  text += law_values_table(study).text() + "\n";
  text += notes_text(study.notes);
  return text;
}

std::string law_study_json(const laws::LawStudy& study) {
  Json out = {{"laws", study.laws},
              {"assumed", study.assumed},
              {"trials", study.trials},
              {"usable", study.usable},
              {"contradicting", study.contradicting},
              {"chosen", study.chosen},
              {"right", study.right},
              {"undecided", study.undecided},
              {"missed", study.missed},
              {"statuses", study.statuses},
              {"chi_square", value(study.chi_square)},
              {"values", Json::array()},
              {"notes", study.notes}};
  for (const StudiedValue& each : study.values) {
    out["values"].push_back({{"joint", each.joint},
                             {"name", each.name},
                             {"unit", each.unit},
                             {"truth", value(each.truth)},
                             {"bound", value(each.bound)},
                             {"bias", value(each.bias)},
                             {"rms_error", value(each.rms_error)},
                             {"coverage", each.trials > 0 ? value(coverage(each)) : Json()},
                             {"trials", each.trials}});
  }
  return json_text(out);
}

std::string law_study_csv(const laws::LawStudy& study) {
  std::string text = csv_line({"joint", "quantity", "unit", "truth", "bound", "bias", "rms error", "covered", "trials"});
  for (const StudiedValue& each : study.values) {
    text += csv_line({each.joint, each.name, each.unit, csv_number(each.truth), csv_number(each.bound), csv_number(each.bias),
                      csv_number(each.rms_error), std::to_string(each.covered), std::to_string(each.trials)});
  }
  return text;
}

}  // namespace jointid::report
