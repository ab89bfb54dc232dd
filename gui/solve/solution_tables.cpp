#include "gui/solve/solution_tables.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/text.hpp"
#include "gui/look/said.hpp"
#include "ident/admissible/constraint_phrases.hpp"
#include "ident/plan/expected_time.hpp"
#include "tasks/joint/joint_springs.hpp"

namespace jointid::gui {
namespace {

QString number(double value) { return q(digits(value, "%.5g")); }

QString listed(const std::vector<frf::Dof>& dofs) {
  QStringList names;
  for (const frf::Dof& dof : dofs) names << q(dof.name());
  return names.join(QStringLiteral(", "));
}

/// "viscous damping" of viscous_damping.
QString words(const std::string& key) { return q(key).replace('_', ' '); }

struct Rows {
  CellRows rows;

  void add(const QString& name, const QString& text) {
    if (!text.isEmpty()) rows.cells.push_back({Cell{name}, Cell{text}});
  }
  void add_all(const char* name, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) add(said(name), q(text));
  }
};

std::array<double, 2> interval(const ident::Estimate& estimate) {
  if (estimate.ci95) return *estimate.ci95;
  const double error = estimate.error_estimate.value_or(0.0);
  return {estimate.value - error, estimate.value + error};
}

/// Unknowns of one matrix and unit are drawn on one scale: "left.K N/m" of left.K(1,2) and left.K[4:+Y,5:+Y], which are in N/m.
std::string scale_key(const ident::Estimate& estimate) {
  const std::size_t bracket = estimate.name.find_first_of("([");
  const std::size_t end = bracket != std::string::npos ? bracket : estimate.name.rfind('.');
  return (end == std::string::npos ? std::string() : estimate.name.substr(0, end)) + " " + estimate.unit;
}

/// The largest of value and interval among the unknowns of each scale.
std::map<std::string, double> scales(const ident::Solution& solution) {
  std::map<std::string, double> largest;
  for (const auto& each : solution.unknowns) {
    const auto [low, high] = interval(each);
    for (const double value : {low, high, each.value}) {
      if (std::isfinite(value)) {
        double& scale = largest[scale_key(each)];
        scale = std::max(scale, std::abs(value));
      }
    }
  }
  return largest;
}

QString interval_text(const ident::Estimate& estimate) {
  if (estimate.ci95) return number((*estimate.ci95)[0]) + QStringLiteral(" … ") + number((*estimate.ci95)[1]);
  return estimate.error_estimate ? QStringLiteral("± ") + q(digits(*estimate.error_estimate)) : QStringLiteral("–");
}

/// Of an element that is an unknown by itself.
std::optional<double> error_of(const ident::Solution& solution, std::size_t band, restrictions::Kind kind, std::size_t i,
                               std::size_t j) {
  const auto& errors = solution.bands[band].errors;
  if (const auto found = errors.find(kind); found != errors.end()) return found->second[i][j];
  if (solution.bands.size() > 1) return std::nullopt;
  const std::string symbol = restrictions::symbol(kind);
  for (const auto& [row, column] : {std::pair(i, j), std::pair(j, i)}) {
    const std::string name = symbol + "(" + std::to_string(row + 1) + "," + std::to_string(column + 1) + ")";
    const auto found = std::ranges::find(solution.unknowns, name, &ident::Estimate::name);
    if (found != solution.unknowns.end()) return tasks::half_width(*found);
  }
  return std::nullopt;
}

/// Blank where an element is zero and no unknown.
Cell element_cell(double value, double largest, const std::optional<double>& error) {
  if (value == 0.0 && !error) return Cell{};
  const QString exact = q(digits(value, "%.17g"));
  Cell cell{number(value), exact, std::isfinite(value) ? 0.75 * value / largest : 0.0};
  if (error) cell.text += QStringLiteral("\n± ") + q(digits(*error));
  cell.copied = exact;
  return cell;
}

void add_fit(const ident::Solution& solution, Rows& out) {
  const ident::Fit& fit = solution.fit;
  out.add(Said::tr("lines"), QString::number(fit.lines));
  if (fit.asm_frf_error) out.add(Said::tr("assembly FRF error"), number(*fit.asm_frf_error) + QStringLiteral(" dB"));
  if (fit.chi_square) {
    const auto& found = *fit.chi_square;
    out.add(Said::tr("χ² / degrees of freedom"), number(found.value / found.degrees_of_freedom));
    out.add(Said::tr("outlier lines"), QString::number(found.outlying_lines));
  }
  if (fit.misfit) out.add(Said::tr("misfit"), number(*fit.misfit));
  for (const auto& [kind, quality] : solution.quality) {
    out.add(words(restrictions::key(kind)),
            Said::tr("RJCF %1, ARVF %2, relative error %3 (rms)")
                .arg(number(quality.rjcf), number(quality.arvf), q(percent(quality.rms_relative_error))));
  }
}

}  // namespace

CellRows plan_rows(const ident::Plan& plan) {
  Rows out{{{Said::tr("what"), Said::tr("plan")}, {}, {}}};
  out.add(Said::tr("method"), plan.chosen.empty() ? q(ident::name(plan.scene.identify.method)) : q(plan.chosen));
  out.add(Said::tr("solver"), q(ident::name(plan.solver)));
  out.add(Said::tr("joint DOFs"), listed(plan.coordinates.joint));
  out.add(Said::tr("internal responses"), listed(plan.coordinates.responses));
  out.add(Said::tr("internal references"), listed(plan.coordinates.references));
  out.add(Said::tr("lines"), Said::tr("%1, %2 to %3 Hz")
                                 .arg(plan.lines.size())
                                 .arg(plan.lines.front().frequency_hz)
                                 .arg(plan.lines.back().frequency_hz));
  QStringList unknowns;
  for (const auto& unknown : plan.restriction.unknowns) unknowns << q(unknown.name);
  out.add(Said::tr("unknowns"), QString::number(unknowns.size()) + QStringLiteral(": ") + unknowns.join(' '));
  out.add_all(QT_TRANSLATE_NOOP("Said", "constraint"), ident::constraint_phrases(plan));
  out.add(Said::tr("to read"), number(static_cast<double>(plan.cost.bytes_read) / 1e6) + QStringLiteral(" MB"));
  if (plan.cost.iteration.expected > 0) {
    out.add(Said::tr("iterations expected"), QString::number(plan.cost.iteration.expected));
    out.add(Said::tr("time expected"), q(digits(ident::expected_seconds(plan.cost))) + QStringLiteral(" s"));
  }
  out.add_all(QT_TRANSLATE_NOOP("Said", "left out"), plan.left_out);
  out.add_all(QT_TRANSLATE_NOOP("Said", "warning"), plan.warnings);
  out.add_all(QT_TRANSLATE_NOOP("Said", "note"), plan.notes);
  return out.rows;
}

CellRows bound_rows(const tasks::BoundReport& report) {
  CellRows out{{Said::tr("what"), Said::tr("of"), Said::tr("standard error"), Said::tr("relative, or bounds times (worst)"),
                Said::tr("bounds times (mean)")},
               {},
               {}};
  const auto factor = [](double value) {
    return std::isfinite(value) ? q(digits(value, "%.3g")) : Said::tr("no longer determined");
  };
  for (const auto& each : report.unknowns) {
    const bool fixed = std::isfinite(each.bound);
    out.cells.push_back({Cell{Said::tr("smallest standard error")}, Cell{q(each.name)},
                         Cell{fixed ? q(digits(each.bound, "%.3g") + " " + each.unit) : Said::tr("not determined by the data")},
                         Cell{fixed ? q(percent(each.relative)) : QString()}, Cell{}});
  }
  const auto add = [&](const char* what, const std::vector<tasks::BoundChange>& changes) {
    for (const auto& change : changes) {
      out.cells.push_back(
          {Cell{said(what)}, Cell{q(change.what)}, Cell{}, Cell{factor(change.worst)}, Cell{factor(change.mean)}});
    }
  };
  add(QT_TRANSLATE_NOOP("Said", "without a DOF"), report.without_coordinate);
  add(QT_TRANSLATE_NOOP("Said", "without lines"), report.without_lines);
  add(QT_TRANSLATE_NOOP("Said", "with more data"), report.with_more);
  for (const std::string& variances : report.variances) {
    out.cells.push_back({Cell{Said::tr("variances")}, Cell{q(variances)}, Cell{}, Cell{}, Cell{}});
  }
  return out;
}

CellRows unknown_rows(const ident::Solution& solution) {
  CellRows out{{Said::tr("name"), Said::tr("value"), Said::tr("unit"), Said::tr("95 % interval or error"), Said::tr("remark"),
                Said::tr("value and interval")},
               {},
               {}};
  const auto largest = scales(solution);
  for (const auto& each : solution.unknowns) {
    const double scale = std::max(largest.at(scale_key(each)), std::numeric_limits<double>::min());
    const auto [low, high] = interval(each);
    Cell bar;
    if (std::isfinite(each.value)) bar.bar = {{low / scale, each.value / scale, high / scale}};
    out.cells.push_back({Cell{q(each.name)}, Cell{number(each.value), q(digits(each.value, "%.17g"))}, Cell{q(each.unit)},
                         Cell{interval_text(each)},
                         Cell{each.determined ? q(each.limit) : Said::tr("not determined by the data")}, bar});
  }
  return out;
}

CellRows matrix_rows(const ident::Solution& solution, std::size_t band, restrictions::Kind kind) {
  CellRows out;
  const ident::Matrix& matrix = solution.bands[band].matrices.at(kind);
  for (const frf::Dof& dof : solution.dofs) out.columns << q(dof.name());
  out.rows = out.columns;
  double largest = std::numeric_limits<double>::min();
  for (const auto& row : matrix) {
    for (const double value : row) largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
  }
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    out.cells.emplace_back();
    for (std::size_t j = 0; j < matrix[i].size(); ++j) {
      out.cells.back().push_back(element_cell(matrix[i][j], largest, error_of(solution, band, kind, i, j)));
    }
  }
  return out;
}

CellRows finding_rows(const ident::Solution& solution) {
  Rows out{{{Said::tr("what"), Said::tr("finding")}, {}, {}}};
  out.add(Said::tr("status"), words(ident::name(solution.status)));
  out.add(Said::tr("message"), q(solution.message));
  out.add(Said::tr("chosen"), q(solution.used.chosen));
  out.add_all(QT_TRANSLATE_NOOP("Said", "warning"), solution.warnings);
  if (solution.identifiability) {
    for (const auto& finding : solution.identifiability->findings) out.add(words(ident::name(finding.kind)), q(finding.text));
  }
  if (solution.check) {
    for (const auto& suspect : solution.check->suspects) {
      out.add(Said::tr("suspect"), q(ident::title(suspect) + ": " + suspect.evidence));
      out.add(Said::tr("remedy"), q(suspect.remedy));
    }
  }
  add_fit(solution, out);
  for (const auto& [file, origin, note] : solution.variances) {
    out.add(Said::tr("variances"), q(file + ": " + origin + (note.empty() ? "" : ". " + note)));
  }
  return out.rows;
}

}  // namespace jointid::gui
