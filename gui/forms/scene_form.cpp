#include "gui/forms/scene_form.hpp"

#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPointer>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/forms/choice_row.hpp"
#include "gui/forms/field.hpp"
#include "gui/forms/field_hints.hpp"
#include "gui/forms/field_text.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/look/status_label.hpp"
#include "gui/scene/completion_place.hpp"
#include "gui/scene/joints_edit.hpp"
#include "gui/scene/scene_words.hpp"
#include "gui/scene/several_edit.hpp"
#include "gui/scene/toml_edit.hpp"

namespace jointid::gui {
namespace {

using Tables = std::vector<std::string>;

const Tables& tables() {
  static const Tables found = [] {
    Tables all = {""};
    for (const std::string& table : all_tables()) {
      if (table != "data.files" && table != "data.files.*") all.push_back(table);
    }
    all.push_back("data.files.*");  // its many fields stay empty in most scenes
    return all;
  }();
  return found;
}

/// What a new one of several tables begins with.
std::string first_lines(const std::string& table, int number) {
  if (table == "data.gains") return "gain = 0.01\n";
  if (table == "data.masses") return "dofs = []\nfiles = []\nmass = 0.003\n";
  return "name = \"VP" + std::to_string(number) + "\"\nposition = [0, 0, 0]\nsensors = []\n";
}

bool is_table(const std::string& path) { return std::ranges::find(tables(), path) != tables().end(); }

}  // namespace

SceneForm::SceneForm(QWidget* parent) : QScrollArea(parent) {
  named(this, "scene_form", tr("Scene as a form"));
  setWidgetResizable(true);
  setFocusPolicy(Qt::NoFocus);
}

void SceneForm::build() {
  begin_anew();
  auto* all = new QWidget;
  auto* column = new QVBoxLayout(all);
  for (const std::string& table : tables()) {
    if (table == "joint") add_joints(*column);
    add_section(table, *column);
    if (is_of_several(table)) add_choice(sections_.back());
    if (table != any_file) continue;
    files_ = new ChoiceRow("file_choice", tr("File of these fields"), false);
    static_cast<QFormLayout*>(sections_.back().box->layout())->insertRow(0, tr("file"), files_);
    connect(files_, &ChoiceRow::changed, this, &SceneForm::show_again);
  }
  column->addStretch(1);
  setWidget(all);
  set_dofs(dofs_);
  set_folder(folder_);
}

/// Fields that there were go when their signals are over.
void SceneForm::begin_anew() {
  if (QWidget* before = takeWidget()) before->deleteLater();
  sections_.clear();
  several_.clear();
  joints_ = files_ = nullptr;
  written_.reset();
}

std::vector<SceneForm::Written> SceneForm::written() const {
  std::vector<Written> all;
  for (const TextTable& table : tables_in(text_)) {
    all.push_back({table.path, {}});
    for (const std::string& key : table.keys)
      all.back().keys.emplace_back(key, kind_as_written(value_of(text_, table.path, key).value_or("")));
  }
  return all;
}

void SceneForm::build_as_written() {
  std::vector<Written> now = written();
  if (written_ == now) return;
  begin_anew();
  auto* all = new QWidget;
  auto* column = new QVBoxLayout(all);
  for (const Written& table : now) {
    if (table.table.empty() && table.keys.empty()) continue;
    add_box(table.table, table.table.empty() ? title_of("") : q(table.table).replace('#', ' '), *column);
    for (const auto& [key, kind] : table.keys) add_field(sections_.back(), key, kind);
  }
  column->addStretch(1);
  setWidget(all);
  written_ = std::move(now);
}

/// Which of several, and its name.
void SceneForm::add_joints(QVBoxLayout& column) {
  add_box(all_joints, title_of(all_joints), column);
  joints_ = new ChoiceRow("joint_choice", tr("Joint of these fields"), true);
  static_cast<QFormLayout*>(sections_.back().box->layout())->addRow(tr("joint"), joints_);
  add_field(sections_.back(), "name");
  connect(joints_, &ChoiceRow::changed, this, &SceneForm::show_again);
  connect(joints_, &ChoiceRow::more_wanted, this, [this] {
    commit();
    Q_EMIT text_wanted(with_joint(text_));
    joints_->choose(joints_in(text_) - 1);
    show_again();
  });
  connect(joints_, &ChoiceRow::fewer_wanted, this, [this] {
    commit();
    Q_EMIT text_wanted(without_joint(text_, joints_->chosen() + 1));
  });
}

/// Which of several tables, and buttons for more and fewer.
void SceneForm::add_choice(Section& section) {
  const std::string table = section.table;
  auto* choice = new ChoiceRow((table + "_choice").c_str(), tr("Table of these fields: %1").arg(title_of(table)), true);
  static_cast<QFormLayout*>(section.box->layout())->insertRow(1, tr("table"), choice);
  several_[table] = choice;
  connect(choice, &ChoiceRow::changed, this, &SceneForm::show_again);
  connect(choice, &ChoiceRow::more_wanted, this, [this, table, choice] {
    commit();
    Q_EMIT text_wanted(with_one_more(text_, table, first_lines(table, several_in(text_, table) + 1)));
    choice->choose(several_in(text_, table) - 1);
    show_again();
  });
  connect(choice, &ChoiceRow::fewer_wanted, this, [this, table, choice] {
    commit();
    Q_EMIT text_wanted(without_one(text_, table, choice->chosen() + 1));
  });
}

void SceneForm::add_section(const std::string& table, QVBoxLayout& column) {
  add_box(table, title_of(table), column);
  for (const std::string& key : keys_of(table)) {
    const bool is_section = table.empty() && is_table(key);
    if (!is_section && key != all_joints) add_field(sections_.back(), key);
  }
}

void SceneForm::add_box(const std::string& table, const QString& title, QVBoxLayout& column) {
  auto* box = named(new QGroupBox(title), "section", title);
  auto* rows = new QFormLayout(box);
  rows->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  rows->setRowWrapPolicy(QFormLayout::WrapLongRows);
  auto* error = named(new StatusLabel, "section_error", tr("Errors in these fields"));
  error->set_bad(true);
  error->setWordWrap(true);
  error->setTextFormat(Qt::PlainText);
  error->hide();
  rows->addRow(error);
  column.addWidget(box);
  sections_.push_back({table, box, error, {}});
}

void SceneForm::add_field(Section& section, const std::string& key, std::optional<ValueKind> as_written) {
  auto* field = new Field(section.table, key, as_written);
  auto* label = new QLabel(q(key).replace('_', ' '));
  label->setBuddy(field->input());
  static_cast<QFormLayout*>(section.box->layout())->addRow(label, field);
  connect(field, &Field::changed, this,
          [this, table = section.table, key](const std::string& value) { Q_EMIT edit_wanted(path_of(table), key, value); });
  section.fields.push_back(field);
}

void SceneForm::set_dofs(const QStringList& dofs) {
  dofs_ = dofs;
  offer(ValueKind::dofs, dofs);
}

void SceneForm::offer(ValueKind kind, const QStringList& names) {
  for (const Section& section : sections_) {
    for (Field* field : section.fields) field->offer(kind, names);
  }
}

void SceneForm::set_folder(const QString& folder) {
  folder_ = folder;
  for (const Section& section : sections_) {
    for (Field* field : section.fields) field->set_folder(folder);
  }
}

/// A value that is left out may take its field with it.
void SceneForm::commit() {
  std::vector<QPointer<Field>> all;
  for (const Section& section : sections_) all.insert(all.end(), section.fields.begin(), section.fields.end());
  for (const QPointer<Field>& field : all) {
    if (field) field->commit();
  }
}

void SceneForm::go_to_first() {
  Field* first = field("data", "substructures");
  for (const Section& section : sections_) {
    if (first == nullptr && !section.fields.empty()) first = section.fields.front();
  }
  if (first != nullptr) first->input()->setFocus();
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
