#include "report/series/contact_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/page/limits.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/text/notes.hpp"

namespace jointid::report {

Table contact_table(const tasks::ContactResult& report) {
  const oscillation::FrictionLaw& law = report.law;
  const auto pm = [](double value, double error) { return fmt::format("{} ± {:.1g}", number(value, error), error); };
  Table table({{"", Align::left}, {"", Align::left}});
  table.add({"slipping samples", fmt::format("{}", law.slip_samples)});
  table.add({"sticking samples", fmt::format("{}", law.stick_samples)});
  table.add({"μ_K", pm(law.kinetic, law.kinetic_error)});
  if (law.falls) {
    table.add({"μ_S − μ_K", pm(law.drop, law.drop_error)});
    table.add({"α s/m", pm(law.decay, law.decay_error)});
  } else {
    table.add({"falling law", "not better than a constant (AIC)"});
  }
  table.add({"μ_S at least", law.static_bound ? number(*law.static_bound) : "–"});
  table.add({"scatter of μ", number(law.scatter)});
  return table;
}

std::vector<std::string> contact_remarks(const tasks::ContactResult& report) {
  std::vector<std::string> out;
  if (report.missing > 0) out.push_back(fmt::format("{} samples with a missing channel are left out", report.missing));
  if (!report.law.remark.empty()) out.push_back(report.law.remark);
  return out;
}

std::string contact_json(const tasks::ContactResult& report) {
  const oscillation::FrictionLaw& law = report.law;
  Json out = {{"status", "ok"},
              {"slip_samples", law.slip_samples},
              {"stick_samples", law.stick_samples},
              {"missing", report.missing},
              {"kinetic", value(law.kinetic)},
              {"kinetic_error", value(law.kinetic_error)},
              {"falls", law.falls},
              {"drop", value(law.drop)},
              {"drop_error", value(law.drop_error)},
              {"decay", value(law.decay)},
              {"decay_error", value(law.decay_error)},
              {"static_bound", value(law.static_bound)},
              {"scatter", value(law.scatter)},
              {"remarks", contact_remarks(report)}};
  return json_text(out);
}

std::string contact_csv(const tasks::ContactResult& report) {
  std::string text = csv_line({"relative velocity [m/s]", "friction coefficient"});
  for (std::size_t i = 0; i < report.velocity.size(); ++i)
    text += csv_line({csv_number(report.velocity[i]), csv_number(report.force[i] / report.normal[i])});
  return text;
}

PlotGroup contact_law_plots(const tasks::ContactResult& report) {
  const oscillation::FrictionLaw& law = report.law;
  ScatterPlot plot;
  plot.title = "Friction coefficient over relative velocity";
  plot.x = {"relative velocity (m/s)", false};
  plot.y = {"f/N", false};
  PointGroup points{"samples", {}};
  const std::size_t step = std::max<std::size_t>(1, report.velocity.size() / most_points);
  for (std::size_t i = 0; i < report.velocity.size(); i += step)
    points.points.push_back({report.velocity[i], report.force[i] / report.normal[i], ""});
  plot.groups.push_back(std::move(points));
  const double most = *std::ranges::max_element(report.velocity);
  for (int k = 0; k <= 100 && most > 0.0; ++k) {
    const double v = most * k / 100.0;
    plot.front.push_back({v, law.kinetic + law.drop * std::exp(-law.decay * v), ""});
  }
  plot.front_name = "law, forwards";
  return {"", {{"", {plot}}}};
}

std::string contact_summary(const tasks::ContactResult& report) {
  return report.law.falls ? "A law that falls with speed." : "A constant coefficient.";
}

std::string contact_text(const tasks::ContactResult& report) {
  std::string text;
  text += notes_text(contact_remarks(report));
  return text + "μ(V) = μ_K + (μ_S − μ_K) exp(−αV)\n" + contact_table(report).text();
}

std::string contact_page(const tasks::ContactResult& report) {
  ReportPage page(report.file, "jointid series friction");
  const std::vector<std::string> remarks = contact_remarks(report);
  page.status(status_banner(remarks.empty() ? "ok" : "doubtful", contact_summary(report), remarks));
  page.section("Law");
  page.add(contact_table(report));
  page.add(contact_law_plots(report));
  page.add(
      Text{"Sticking samples only bound μ_S from below; μ(V) = μ_K + (μ_S − μ_K) exp(−αV) is fitted to slipping report.", true});
  return page.html();
}

}  // namespace jointid::report
