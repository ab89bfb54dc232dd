#include <fmt/format.h>

#include "report/page/escape.hpp"
#include "report/page/tables_html.hpp"

namespace jointid::report {
namespace {

const char* class_of(Trust trust) {
  switch (trust) {
    case Trust::good: return "good";
    case Trust::doubtful: return "unsure";
    case Trust::bad: break;
  }
  return "bad";
}

std::string suspect_html(const SuspectLines& suspect) {
  std::string where = suspect.file;
  if (!suspect.dofs.empty()) where += (where.empty() ? "" : ", ") + suspect.dofs;
  std::string out = "<li><strong>" + html(suspect.kind) + "</strong>";
  if (!where.empty()) out += " <span class=\"where\">" + html(where) + "</span>";
  if (!suspect.evidence.empty()) out += "<p>" + html(suspect.evidence) + "</p>";
  if (!suspect.remedy.empty()) out += "<pre>" + html(suspect.remedy) + "</pre>";
  return out + "</li>\n";
}

}  // namespace

std::string to_html(const StatusBanner& banner) {
  std::string out = fmt::format("<div class=\"verdict {}\" role=\"status\"><strong class=\"word\">{}</strong>", class_of(banner.trust),
                                html(banner.word));
  if (!banner.message.empty()) out += "<p>" + html(banner.message) + "</p>";
  for (const std::string& remark : banner.remarks) out += "<p>" + html(remark) + "</p>";
  if (!banner.suspects.empty()) {
    out += "<p class=\"suspected\">Suspected, most likely first:</p><ol>\n";
    for (const SuspectLines& suspect : banner.suspects) out += suspect_html(suspect);
    out += "</ol>";
  }
  return out + "</div>\n";
}

}  // namespace jointid::report
