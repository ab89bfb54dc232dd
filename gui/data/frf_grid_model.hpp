#pragma once

#include <QAbstractTableModel>

#include "gui/data/loaded_file.hpp"
#include "gui/look/theme.hpp"

namespace jointid::gui {

/// What the cells of the grid show.
enum class GridFigure { missing, coherence, deviation, reciprocity };

/// Responses × references of a file, coloured by what is known of each FRF; joint DOFs are bold.
class FrfGridModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  /// Nothing is known of its FRFs until set_figures().
  void set_file(const frf::FrfHeader& header);
  void clear();
  void set_figures(std::vector<EntryFigures> figures);
  void set_figure(GridFigure figure);
  void set_joint(std::vector<frf::Dof> dofs);
  void set_theme(Theme theme);
  const frf::FrfHeader& header() const { return header_; }
  /// The figures that the file knows.
  std::vector<GridFigure> known_figures() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void all_changed();

  frf::FrfHeader header_;
  std::vector<EntryFigures> figures_;
  std::vector<frf::Dof> joint_;
  GridFigure figure_ = GridFigure::missing;
  Theme theme_ = Theme::light;
};

}  // namespace jointid::gui
