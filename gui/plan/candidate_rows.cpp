#include "gui/plan/candidate_rows.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

QString factor(double value) { return std::isfinite(value) ? q(digits(value, "%.3g")) : Said::tr("no longer determined"); }

/// How much of the bound goes: 0 to 1.
double gain(const tasks::BoundChange& change) { return std::clamp(1.0 - change.mean, 0.0, 1.0); }

}  // namespace

CellRows candidate_rows(const tasks::BoundReport& report) {
  CellRows out{
      {Said::tr("candidate"), Said::tr("bounds times (mean)"), Said::tr("bounds times (worst)"), Said::tr("benefit")}, {}, {}};
  std::vector<tasks::BoundChange> ranked = report.with_more;
  std::ranges::stable_sort(ranked, {}, [](const tasks::BoundChange& change) { return std::pair(change.mean, change.worst); });
  for (const tasks::BoundChange& change : ranked) {
    Cell bar;
    bar.bar = {{0.0, gain(change), gain(change)}};
    out.cells.push_back({Cell{q(change.what)}, Cell{factor(change.mean)}, Cell{factor(change.worst)}, bar});
  }
  return out;
}

std::vector<frf::Dof> parse_dofs(const QString& text) {
  std::vector<frf::Dof> dofs;
  for (const QString& name : text.split(',', Qt::SkipEmptyParts)) {
    if (!name.trimmed().isEmpty()) dofs.push_back(frf::Dof::parse(name.trimmed().toStdString()));
  }
  return dofs;
}

}  // namespace jointid::gui
