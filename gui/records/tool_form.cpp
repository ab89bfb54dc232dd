#include "gui/records/tool_form.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>

#include "gui/look/buttons.hpp"
#include "gui/look/choice_button.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

constexpr int fields_in_a_row = 4, letters_of_column = 10, field_width_px = 150;

QString text_in(const ToolField& field, const QWidget& widget) {
  switch (field.kind) {
    case ToolField::Kind::column: {
      const auto& box = static_cast<const QComboBox&>(widget);
      return box.currentIndex() < 1 ? QString() : box.currentText();
    }
    case ToolField::Kind::columns:
      return static_cast<const ChoiceButton&>(widget).chosen().join(',');
    case ToolField::Kind::number:
    case ToolField::Kind::texts:
    case ToolField::Kind::file:
      return static_cast<const QLineEdit&>(widget).text().trimmed();
    case ToolField::Kind::flag:
      break;
  }
  return static_cast<const QCheckBox&>(widget).isChecked() ? QStringLiteral("on") : QString();
}

}  // namespace

ToolForm::ToolForm(const RecordTool& tool, QWidget* parent) : QWidget(parent) {
  named(this, ("records_" + tool.name).c_str(), tool.title);
  auto* rows = new QGridLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setColumnStretch(fields_in_a_row, 1);
  int place = 0;
  for (const ToolField& field : tool.fields) {
    const int span = field.kind == ToolField::Kind::texts ? fields_in_a_row : 1;
    rows->addWidget(make_field(field, "records_" + tool.name + "_" + field.option.substr(2)), place / fields_in_a_row,
                    place % fields_in_a_row, 1, span);
    place += span;
  }
  tell_changes();
}

/// Columns that are offered anew change nothing.
void ToolForm::tell_changes() {
  for (const auto& [field, widget] : fields_) {
    if (auto* box = qobject_cast<QComboBox*>(widget)) connect(box, &QComboBox::activated, this, &ToolForm::changed);
    if (auto* edit = qobject_cast<QLineEdit*>(widget)) connect(edit, &QLineEdit::editingFinished, this, &ToolForm::changed);
    if (auto* box = qobject_cast<QCheckBox*>(widget)) connect(box, &QCheckBox::clicked, this, &ToolForm::changed);
  }
}

QWidget* ToolForm::make_field(const ToolField& field, const std::string& name) {
  QWidget* out = nullptr;
  switch (field.kind) {
    case ToolField::Kind::column: {
      auto* box = named(new QComboBox, name.c_str(), field.title, field.hint);
      box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
      box->setMinimumContentsLength(letters_of_column);
      box->addItem(field.title);
      out = box;
      break;
    }
    case ToolField::Kind::columns:
      out = new ChoiceButton(name.c_str(), field.title, {}, tr("all"), field.hint);
      out->setMaximumWidth(field_width_px);
      break;
    case ToolField::Kind::number:
    case ToolField::Kind::texts: {
      auto* edit = named(new QLineEdit, name.c_str(), field.hint, field.hint);
      edit->setPlaceholderText(field.title);
      if (field.kind == ToolField::Kind::number) edit->setMaximumWidth(field_width_px);
      out = edit;
      break;
    }
    case ToolField::Kind::file:
      return make_file_field(field, name);
    case ToolField::Kind::flag:
      out = named(new QCheckBox(field.title), name.c_str(), field.title, field.hint);
      break;
  }
  fields_.emplace_back(field, out);
  return out;
}

/// The name of a file, typed or chosen.
QWidget* ToolForm::make_file_field(const ToolField& field, const std::string& name) {
  auto* edit = named(new QLineEdit, name.c_str(), field.hint, field.hint);
  edit->setPlaceholderText(field.title);
  edit->setMaximumWidth(field_width_px);
  fields_.emplace_back(field, edit);
  auto* choose = push_button((name + "_choose").c_str(), QStringLiteral("…"), tr("Choose: %1").arg(field.title));
  connect(choose, &QPushButton::clicked, this, [this, edit] {
    const QStringList files = choose_files_to_open(this);
    if (!files.isEmpty()) edit->setText(files.front());
  });
  auto* both = named(new QWidget, (name + "_both").c_str(), field.title);
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(edit);
  row->addWidget(choose);
  return both;
}

void ToolForm::offer(const QStringList& channels) {
  for (const auto& [field, widget] : fields_) {
    if (field.kind == ToolField::Kind::columns) static_cast<ChoiceButton*>(widget)->set_words(channels);
    if (field.kind != ToolField::Kind::column) continue;
    auto* box = static_cast<QComboBox*>(widget);
    const QString before = box->currentText();
    box->clear();
    box->addItem(field.title);
    box->addItems(channels);
    box->setCurrentIndex(std::max(0, box->findText(before)));
  }
}

ToolValues ToolForm::values() const {
  ToolValues out;
  for (const auto& [field, widget] : fields_) {
    const QString text = text_in(field, *widget);
    if (!text.isEmpty()) out[field.option] = text;
  }
  return out;
}

}  // namespace jointid::gui
