#include "gui/open/variable_dialog.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "gui/help/help_keys.hpp"
#include "gui/look/named.hpp"

namespace jointid::gui {

VariableDialog::VariableDialog(const std::vector<std::pair<QString, QStringList>>& undecided, QWidget* parent) : QDialog(parent) {
  named(this, "variable_dialog", tr("Which variable holds the FRFs?"));
  setWindowTitle(tr("Which variable holds the FRFs?"));
  auto* hint = new QLabel(tr("Several variables may be the FRFs. The choice becomes the key variable of [data.files] in the scene."));
  hint->setWordWrap(true);
  auto* rows = new QFormLayout;
  for (const auto& [file, variables] : undecided) {
    const QString name = QFileInfo(file).fileName();
    auto* box = named(new QComboBox, "variable_of_file", tr("Variable of %1").arg(name));
    box->addItems(variables);
    rows->addRow(name, box);
    boxes_.emplace_back(file, box);
  }
  auto* buttons = named(new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel | QDialogButtonBox::Help),
                        "variable_buttons", tr("Open the files, or leave them"));
  auto* all = new QVBoxLayout(this);
  all->addWidget(hint);
  all->addLayout(rows);
  all->addStretch(1);
  all->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::helpRequested, this, [this] { show_help_of(this); });
  resize(460, 160);
}

ChosenNames VariableDialog::chosen() const {
  ChosenNames out;
  for (const auto& [file, box] : boxes_) out[file] = box->currentText();
  return out;
}

}  // namespace jointid::gui
