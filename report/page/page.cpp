#include "report/page/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/page/assets.hpp"
#include "report/page/escape.hpp"
#include "report/page/plot_json.hpp"
#include "report/page/tables_html.hpp"

namespace jointid::report {
namespace {

constexpr const char* head =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
    "script-src 'unsafe-inline'\">\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
    "<meta name=\"color-scheme\" content=\"light dark\">\n";

std::string element(const char* name, const char* attributes, std::string_view inside) {
  return fmt::format("<{0}{1}>{2}</{0}>\n", name, attributes, inside);
}

std::string style() { return std::string(assets::uPlot_min_css) + "\n" + std::string(assets::page_css); }

/// In a function of its own, so that its names do not meet the browser's. The licence of the library asks to stand with it.
std::string program() {
  std::string out = "/* uPlot:\n" + std::string(assets::LICENSE) + "\n*/\n(function () {\n";
  for (const std::string_view part : {assets::uPlot_iife_min_js, assets::look_js, assets::plots_js, assets::touch_js,
                                      assets::page_js, assets::selfcheck_js}) {
    out += part;
  }
  return out + "})();\n";
}

std::string list(const std::vector<std::string>& items) {
  std::string out;
  for (const std::string& item : items) out += (out.empty() ? "" : ",\n") + item;
  return "[" + out + "]";
}

}  // namespace

ReportPage::ReportPage(std::string title, std::string subtitle)
    : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

void ReportPage::status(const StatusBanner& banner) { banner_ = to_html(banner); }

void ReportPage::section(const std::string& title) {
  sections_.push_back(element("h2", "", report::html(title)));
}

void ReportPage::append(const std::string& html) {
  if (sections_.empty()) sections_.emplace_back();
  sections_.back() += html;
}

void ReportPage::add(const Text& text) { append(to_html(text)); }
void ReportPage::add(const Facts& facts) { append(to_html(facts)); }
void ReportPage::add(const HeatMap& map) { append(to_html(map)); }

void ReportPage::add(const Table& table, const std::string& title, const RowLimit& limit) {
  append(to_html(table, title, limit.most));
  if (table.rows().size() <= limit.most) return;
  const std::string rest = limit.rest.empty() ? "" : "; " + limit.rest;
  add(Text{fmt::format("First {} of {} rows{}.", limit.most, table.rows().size(), rest)});
}

void ReportPage::add(const MatrixTable& matrix) { append(to_html(matrix)); }
void ReportPage::add(const ComparedTable& table) { append(to_html(table)); }
void ReportPage::add(const Bars& bars) { append(to_html(bars)); }

void ReportPage::add(const PlotGroup& group) {
  if (std::ranges::all_of(group.choices, [](const Choice& choice) { return choice.plots.empty(); })) return;
  append(fmt::format("<div class=\"plots\" data-group=\"{}\"><noscript>The plots need JavaScript.</noscript></div>\n",
                     groups_.size()));
  groups_.push_back(plot_json(group));
}

std::string ReportPage::html() const {
  std::string out = head + element("title", "", report::html(title_)) + element("style", "", style()) +
                    element("script", "", assets::errors_js) + "</head>\n<body>\n<header>\n" +
                    element("h1", "", report::html(title_)) + element("p", "", report::html(subtitle_)) +
                    "</header>\n" + banner_ + "<main>\n";
  for (const std::string& section : sections_) out += element("section", "", section);
  out += "</main>\n" + element("footer", "", "jointid " JOINTID_VERSION);
  if (!groups_.empty()) {
    out += element("script", " type=\"application/json\" id=\"plots\"", script_json(list(groups_)));
    out += element("script", "", program());
  }
  return out + "</body>\n</html>\n";
}

}  // namespace jointid::report
