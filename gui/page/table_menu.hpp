#pragma once

#include <QWidget>
#include <string>
#include <utility>
#include <vector>

#include "gui/table/cell_table.hpp"

class QComboBox;

namespace jointid::gui {

/// Tables of a page of which one is shown, by a menu.
class TableMenu : public QWidget {
  Q_OBJECT

 public:
  /// The menu is named NAME_menu, the table NAME.
  TableMenu(const std::string& name, const QString& accessible_name, QWidget* parent = nullptr);

  using Named = std::pair<QString, CellRows>;
  /// Those without rows are left out; the one that is shown stays, if it is still there.
  void show_tables(std::vector<Named> tables);
  QComboBox* menu() const { return menu_; }
  CellTable* table() const { return table_; }

 private:
  void show_choice();

  QComboBox* menu_;
  CellTable* table_;
  std::vector<Named> tables_;
};

/// A row a remark.
CellRows remark_rows(const std::vector<std::string>& remarks);

}  // namespace jointid::gui
