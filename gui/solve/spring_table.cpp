#include "gui/solve/spring_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/text.hpp"
#include "gui/look/said.hpp"
#include "tasks/joint/joint_springs.hpp"

namespace jointid::gui {
namespace {

/// "left.K[118:+X,201:+X]": the joint, the matrix and the ends; "left.K.x" has a name in place of ends.
struct SpringName {
  std::string joint, ends;
  std::string damping;  ///< the unknown of its hysteretic damping
};

/// Nothing where the unknown is no spring of the stiffness.
std::optional<SpringName> spring_name(const std::string& unknown) {
  const std::size_t bracket = unknown.find("K[");
  const std::size_t dot = bracket == std::string::npos ? unknown.find("K.") : std::string::npos;
  const std::size_t place = std::min(bracket, dot);
  if (place == std::string::npos || (place > 0 && unknown[place - 1] != '.')) return std::nullopt;
  std::string ends = unknown.substr(place + 2);
  if (bracket != std::string::npos) ends.pop_back();
  std::string damping = unknown;
  damping[place] = 'D';
  return SpringName{unknown.substr(0, place), ends, damping};
}

/// "left: 118:+X – 201:+X".
QString title(const SpringName& name) {
  const QString ends = q(name.ends).replace(QStringLiteral(","), QStringLiteral(" – "));
  return name.joint.empty() ? ends : q(name.joint.substr(0, name.joint.size() - 1)) + QStringLiteral(": ") + ends;
}

/// What follows the node of the first end: springs of one direction are drawn on one scale.
std::string direction(const SpringName& name) {
  const std::size_t colon = name.ends.find(':');
  return colon == std::string::npos ? std::string() : name.ends.substr(colon, name.ends.find(',') - colon);
}

/// Null where it is none, or not determined.
const ident::Estimate* damping_of(const ident::Solution& solution, const SpringName& name) {
  const auto found = std::ranges::find(solution.unknowns, name.damping, &ident::Estimate::name);
  return found == solution.unknowns.end() || !found->determined ? nullptr : &*found;
}

QString plus_minus(const std::optional<double>& half) { return half ? QStringLiteral("± ") + q(digits(*half)) : QStringLiteral("–"); }

QString short_number(double value) { return q(digits(value, "%.5g")); }

Cell number_cell(double value) {
  Cell cell{short_number(value), q(digits(value, "%.17g"))};
  cell.copied = cell.hint;
  return cell;
}

void add_loss_factor(const ident::Estimate& k, const ident::Estimate* d, std::vector<Cell>& row) {
  if (d == nullptr || !k.determined || !(std::abs(k.value) > 0.0)) {
    row.insert(row.end(), 2, Cell{});
    return;
  }
  row.push_back(number_cell(d->value / k.value));
  const auto of_k = tasks::half_width(k), of_d = tasks::half_width(*d);
  std::optional<double> half;
  if (of_k && of_d) half = *of_d / std::abs(k.value) + std::abs(d->value) * *of_k / (k.value * k.value);
  row.push_back(Cell{plus_minus(half)});
}

}  // namespace

CellRows spring_rows(const ident::Solution& solution) {
  CellRows out{{Said::tr("spring"), Said::tr("k"), Said::tr("95 % interval or error"), Said::tr("unit"), Said::tr("η = D/k"),
                Said::tr("95 % interval or error"), Said::tr("k beside the others of its direction")},
               {},
               {}};
  std::map<std::string, double> largest;
  for (const ident::Estimate& each : solution.unknowns) {
    if (const auto name = spring_name(each.name); name && std::isfinite(each.value)) {
      double& scale = largest[direction(*name)];
      scale = std::max(scale, std::abs(each.value));
    }
  }
  for (const ident::Estimate& each : solution.unknowns) {
    const auto name = spring_name(each.name);
    if (!name) continue;
    std::vector<Cell> row = {Cell{title(*name)}, number_cell(each.value),
                             Cell{each.determined ? plus_minus(tasks::half_width(each)) : Said::tr("not determined by the data")},
                             Cell{q(each.unit)}};
    add_loss_factor(each, damping_of(solution, *name), row);
    Cell bar;
    if (const double scale = largest[direction(*name)]; std::isfinite(each.value) && scale > 0.0) {
      const double half = tasks::half_width(each).value_or(0.0);
      bar.bar = {{(each.value - half) / scale, each.value / scale, (each.value + half) / scale}};
    }
    row.push_back(std::move(bar));
    out.cells.push_back(std::move(row));
  }
  return out;
}

}  // namespace jointid::gui
