#include "gui/data/frf_grid_model.hpp"

#include <QFont>
#include <algorithm>
#include <cmath>

namespace jointid::gui {
namespace {

std::optional<double> figure_of(const EntryFigures& figures, GridFigure figure) {
  switch (figure) {
    case GridFigure::missing:
      return figures.missing;
    case GridFigure::coherence:
      return figures.coherence;
    case GridFigure::deviation:
      return figures.deviation;
    case GridFigure::reciprocity:
      return figures.reciprocity;
  }
  return std::nullopt;
}

/// How good a figure is: 0 for an error of 100 %, 1 for one of 0.1 % and less, and in proportion to the digits between them.
double goodness(double value, GridFigure figure) {
  const double bad = figure == GridFigure::coherence ? 1.0 - value : value;
  if (figure == GridFigure::missing) return 1.0 - bad;
  constexpr double digits = 3.0;
  return std::clamp(-std::log10(std::max(bad, 1e-9)) / digits, 0.0, 1.0);
}

QString figure_text(double value, GridFigure figure) {
  if (figure == GridFigure::coherence) return QString::number(value, 'f', 3);
  return QString::number(100.0 * value, 'g', 2) + QStringLiteral(" %");
}

}  // namespace

void FrfGridModel::set_file(const frf::FrfHeader& header) {
  beginResetModel();
  header_ = header;
  figures_.clear();
  endResetModel();
}

void FrfGridModel::clear() { set_file({}); }

void FrfGridModel::set_figures(std::vector<EntryFigures> figures) {
  figures_ = std::move(figures);
  all_changed();
}

void FrfGridModel::all_changed() {
  if (rowCount() > 0 && columnCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
  if (rowCount() > 0) Q_EMIT headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
  if (columnCount() > 0) Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

void FrfGridModel::set_figure(GridFigure figure) {
  figure_ = figure;
  all_changed();
}

void FrfGridModel::set_joint(std::vector<frf::Dof> dofs) {
  joint_ = std::move(dofs);
  all_changed();
}

void FrfGridModel::set_theme(Theme theme) {
  theme_ = theme;
  all_changed();
}

std::vector<GridFigure> FrfGridModel::known_figures() const {
  std::vector<GridFigure> known;
  for (const GridFigure figure : {GridFigure::coherence, GridFigure::deviation, GridFigure::reciprocity, GridFigure::missing}) {
    if (std::ranges::any_of(figures_, [&](const EntryFigures& each) { return figure_of(each, figure).has_value(); }))
      known.push_back(figure);
  }
  return known;
}

int FrfGridModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(header_.response.size());
}

int FrfGridModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(header_.reference.size());
}

QVariant FrfGridModel::data(const QModelIndex& index, int role) const {
  const auto at = static_cast<std::size_t>(index.row()) * header_.reference.size() + static_cast<std::size_t>(index.column());
  if (!index.isValid() || at >= figures_.size()) return {};
  const EntryFigures& figures = figures_[at];
  const std::optional<double> value = figures.missing >= 1.0 ? std::nullopt : figure_of(figures, figure_);
  const QColor background = value ? shade(theme_, 0.75 * goodness(*value, figure_)) : colours(theme_).background;
  switch (role) {
    case Qt::DisplayRole:
      return value ? figure_text(*value, figure_) : figures.missing >= 1.0 ? tr("missing") : QStringLiteral("–");
    case Qt::BackgroundRole:
      return background;
    case Qt::ForegroundRole:
      return value ? text_on(background) : colours(theme_).weak_text;
    case Qt::TextAlignmentRole:
      return Qt::AlignCenter;
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      return tr("response %1, reference %2: %3")
          .arg(headerData(index.row(), Qt::Vertical, Qt::DisplayRole).toString(),
               headerData(index.column(), Qt::Horizontal, Qt::DisplayRole).toString(), data(index, Qt::DisplayRole).toString());
    default:
      return {};
  }
}

QVariant FrfGridModel::headerData(int section, Qt::Orientation orientation, int role) const {
  const auto& dofs = orientation == Qt::Vertical ? header_.response : header_.reference;
  if (section < 0 || section >= static_cast<int>(dofs.size())) return {};
  const frf::Dof& dof = dofs[static_cast<std::size_t>(section)];
  if (role == Qt::DisplayRole) return QString::fromStdString(dof.name());
  if (role == Qt::ToolTipRole && frf::has(joint_, dof)) return tr("joint DOF");
  if (role != Qt::FontRole || !frf::has(joint_, dof)) return {};
  QFont bold;
  bold.setBold(true);
  bold.setUnderline(true);
  return bold;
}

}  // namespace jointid::gui
