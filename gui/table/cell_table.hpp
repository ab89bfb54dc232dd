#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "gui/look/theme.hpp"
#include "report/text/table.hpp"

namespace jointid::gui {

/// What a cell of a table shows.
struct Cell {
  QString text;
  QString hint{};                              ///< under the mouse
  std::optional<double> shade{};               ///< −1 to 1: the depth of its colour, of another one below 0
  std::optional<std::array<double, 3>> bar{};  ///< low, value and high as shares of the width, from −1 to 1
  QString copied{};                            ///< for a spreadsheet, in place of the text
};

struct CellRows {
  QStringList columns, rows;  ///< names; no names of rows where empty
  std::vector<std::vector<Cell>> cells;
};

/// A table of texts; the first cells of its rows are no names.
CellRows rows_of(const report::Table& table);

/// A table that is only looked at.
class CellModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  static constexpr int bar_role = Qt::UserRole + 1, copy_role = Qt::UserRole + 2;

  void set(CellRows rows);
  void set_theme(Theme theme);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  CellRows rows_;
  Theme theme_ = Theme::light;
};

/// Its view: Ctrl+C copies what is chosen, or all, for a spreadsheet; Ctrl+E, and its menu, saves all of it as CSV.
class CellTable : public QTableView {
  Q_OBJECT

 public:
  CellTable(const char* name, const QString& accessible_name, QWidget* parent = nullptr);

  void show_rows(CellRows rows);
  CellModel* cells() const { return model_; }
  /// All cells with their names, a line a row, as they are copied.
  QString text(QChar separator) const;
  QString chosen_text() const;
  /// Files that no CSV replaces.
  void protect(std::vector<std::filesystem::path> inputs) { inputs_ = std::move(inputs); }
  /// Throws InputError where the disk does not take it.
  void write_csv(const QString& file) const;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void save_csv();

  CellModel* model_;
  std::vector<std::filesystem::path> inputs_;
};

}  // namespace jointid::gui
