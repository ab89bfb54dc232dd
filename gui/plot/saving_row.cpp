#include "gui/plot/saving_row.hpp"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/look/named.hpp"

namespace jointid::gui {

void add_saving_row(QVBoxLayout& column, QLabel* readout, const char* name, const std::function<void()>& copy,
                    const std::function<void()>& save) {
  auto* copy_button = named(new QToolButton, (QByteArray(name) + "_copy").constData(),
                            QCoreApplication::translate("Chart", "Copy the numbers for a spreadsheet, and the picture"));
  copy_button->setText(QCoreApplication::translate("Chart", "Copy"));
  auto* save_button = named(new QToolButton, (QByteArray(name) + "_save").constData(),
                            QCoreApplication::translate("Chart", "Save as PNG, SVG, PDF or CSV"));
  save_button->setText(QCoreApplication::translate("Chart", "Save…"));
  auto* row = new QHBoxLayout;
  row->addWidget(readout, 1);
  for (QToolButton* each : {copy_button, save_button}) {
    each->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(each);
  }
  column.addLayout(row);
  QObject::connect(copy_button, &QToolButton::clicked, readout, copy);
  QObject::connect(save_button, &QToolButton::clicked, readout, save);
}

}  // namespace jointid::gui
