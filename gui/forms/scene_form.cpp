#include "gui/forms/scene_form.hpp"

#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/forms/field.hpp"
#include "gui/forms/field_hints.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/look/theme.hpp"
#include "gui/scene/completion_place.hpp"
#include "gui/scene/toml_edit.hpp"

namespace jointid::gui {
namespace {

using Tables = std::vector<std::string>;

/// Any key will do in it: it is one field.
bool is_open(const std::string& table) { return table == "data.files"; }

const Tables& tables() {
  static const Tables found = [] {
    Tables all = {""};
    for (const std::string& table : all_tables()) {
      if (!is_open(table)) all.push_back(table);
    }
    return all;
  }();
  return found;
}

bool is_table(const std::string& path) { return std::ranges::find(tables(), path) != tables().end(); }

std::string below(const std::string& table, const std::string& key) { return table.empty() ? key : table + "." + key; }

/// Whether a table has fields of its own in the text as it is: not where it stands as the value of a key, and those below other
/// tables than [joint] only where they have a header.
bool has_section(const std::string& text, const std::string& table) {
  const std::size_t dot = table.rfind('.');
  if (dot == std::string::npos) return true;
  if (value_of(text, table.substr(0, dot), table.substr(dot + 1))) return false;
  return table.starts_with("joint.") || !tables_below(text, table).empty();
}

bool is_of_joint(const std::string& table) { return table == "joint" || table.starts_with("joint."); }

QString sentence(const SceneError& error) {
  return q(error.problem) + (error.remedy.empty() ? QString() : QStringLiteral("; ") + q(error.remedy));
}

}  // namespace

SceneForm::SceneForm(QWidget* parent) : QScrollArea(parent) {
  named(this, "scene_form", tr("Scene as a form"));
  setWidgetResizable(true);
  setFocusPolicy(Qt::NoFocus);
}

void SceneForm::build() {
  auto* all = new QWidget;
  auto* column = new QVBoxLayout(all);
  several_ = named(new QLabel(tr("The joints of this scene stand in [[joints]]: they are edited in the text.")), "several_joints",
                   tr("Several joints"));
  several_->setWordWrap(true);
  for (const std::string& table : tables()) {
    if (table == "joint") column->addWidget(several_);
    add_section(table, *column);
  }
  column->addStretch(1);
  setWidget(all);
  set_dofs(dofs_);
  set_folder(folder_);
}

void SceneForm::add_section(const std::string& table, QVBoxLayout& column) {
  auto* box = named(new QGroupBox(title_of(table)), "section", title_of(table));
  auto* rows = new QFormLayout(box);
  rows->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  rows->setRowWrapPolicy(QFormLayout::WrapLongRows);
  auto* error = named(new QLabel, "section_error", tr("What is wrong with these fields"));
  error->setWordWrap(true);
  error->setTextFormat(Qt::PlainText);
  error->hide();
  rows->addRow(error);
  Section section{table, box, error, {}};
  for (const std::string& key : keys_of(table)) {
    const bool is_section = table.empty() && is_table(key);
    if (is_section || key == "joints") continue;
    auto* field = new Field(table, key);
    auto* label = new QLabel(q(key).replace('_', ' '));
    label->setBuddy(field->input());
    rows->addRow(label, field);
    connect(field, &Field::changed, this,
            [this, table, key](const std::string& value) { Q_EMIT edit_wanted(table, key, value); });
    section.fields.push_back(field);
  }
  column.addWidget(box);
  sections_.push_back(std::move(section));
}

void SceneForm::show_text(const std::string& text, const std::optional<SceneError>& error) {
  if (sections_.empty()) build();
  show_values(text);
  clear_errors();
  if (error && error->line > 0) show_error(text, *error);
}

void SceneForm::show_values(const std::string& text) {
  const bool several = !tables_below(text, "joints").empty();
  several_->setVisible(several);
  for (const Section& section : sections_) {
    const bool shown = has_section(text, section.table) && !(several && is_of_joint(section.table));
    section.box->setVisible(shown);
    if (!shown) continue;
    auto* const rows = static_cast<QFormLayout*>(section.box->layout());
    for (Field* field : section.fields) {
      const std::string path = below(section.table, field->key());
      const bool elsewhere = is_table(path) && has_section(text, path);
      field->setVisible(!elsewhere);
      rows->labelForField(field)->setVisible(!elsewhere);
      if (elsewhere) continue;
      const auto value = value_of(text, section.table, field->key());
      if (!value && !tables_below(text, path).empty())
        field->lock(tr("It is a table of its own in the text."));
      else
        field->show_value(value.value_or(""));
    }
  }
}

void SceneForm::clear_errors() {
  for (const Section& section : sections_) {
    section.error->hide();
    section.error->clear();
    for (Field* field : section.fields) field->set_error({});
  }
}

/// At the field whose lines hold it, else at the last table that begins above it.
void SceneForm::show_error(const std::string& text, const SceneError& error) {
  const Section* nearest = nullptr;
  int nearest_line = 0;
  for (const Section& section : sections_) {
    if (section.box->isHidden()) continue;
    for (Field* field : section.fields) {
      const auto lines = lines_of(text, section.table, field->key());
      if (lines && (*lines)[0] <= error.line && error.line <= (*lines)[1]) return field->set_error(sentence(error));
    }
    const int header = line_of_key(text, section.table, "");
    if (header <= error.line && header > nearest_line) {
      nearest = &section;
      nearest_line = header;
    }
  }
  if (nearest == nullptr) return;
  nearest->error->setText(sentence(error));
  nearest->error->setStyleSheet(QStringLiteral("color: %1").arg(colours(theme_of(palette())).error.name()));
  nearest->error->show();
}

void SceneForm::set_dofs(const QStringList& dofs) {
  dofs_ = dofs;
  for (const Section& section : sections_) {
    for (Field* field : section.fields) field->set_dofs(dofs);
  }
}

void SceneForm::set_folder(const QString& folder) {
  folder_ = folder;
  for (const Section& section : sections_) {
    for (Field* field : section.fields) field->set_folder(folder);
  }
}

void SceneForm::commit() {
  for (const Section& section : sections_) {
    for (Field* field : section.fields) field->commit();
  }
}

bool SceneForm::go_to_error() {
  for (const Section& section : sections_) {
    if (section.box->isHidden()) continue;
    for (Field* field : section.fields) {
      if (field->isHidden() || (field->error().isEmpty() && (section.error->isHidden() || field != section.fields.front())))
        continue;
      ensureWidgetVisible(field);
      field->input()->setFocus();
      return true;
    }
  }
  return false;
}

Field* SceneForm::field(const std::string& table, const std::string& key) const {
  for (const Section& section : sections_) {
    for (Field* field : section.fields) {
      if (section.table == table && field->key() == key) return field;
    }
  }
  return nullptr;
}

}  // namespace jointid::gui
