#include "gui/page/table_menu.hpp"

#include <QComboBox>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {

TableMenu::TableMenu(const std::string& name, const QString& accessible_name, QWidget* parent) : QWidget(parent) {
  setAccessibleName(accessible_name);
  menu_ = named(new QComboBox, (name + "_menu").c_str(), tr("Which table is shown"));
  menu_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  table_ = new CellTable(name.c_str(), accessible_name);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row_of({menu_}, {}));
  column->addWidget(table_, 1);
  connect(menu_, &QComboBox::currentIndexChanged, this, &TableMenu::show_choice);
  show_choice();
}

void TableMenu::show_tables(std::vector<Named> tables) {
  const QString before = menu_->currentText();
  const QSignalBlocker quiet(menu_);
  std::erase_if(tables, [](const Named& table) { return table.second.cells.empty(); });
  tables_ = std::move(tables);
  menu_->clear();
  for (const Named& table : tables_) menu_->addItem(table.first);
  menu_->setCurrentIndex(tables_.empty() ? -1 : std::max(0, menu_->findText(before)));
  show_choice();
}

void TableMenu::show_choice() {
  const int chosen = menu_->currentIndex();
  menu_->setVisible(menu_->count() > 0);
  table_->show_rows(chosen < 0 ? CellRows() : tables_[static_cast<std::size_t>(chosen)].second);
}

CellRows remark_rows(const std::vector<std::string>& remarks) {
  CellRows out{{Said::tr("remark")}, {}, {}};
  for (const std::string& remark : remarks) out.cells.push_back({Cell{q(remark)}});
  return out;
}

}  // namespace jointid::gui
