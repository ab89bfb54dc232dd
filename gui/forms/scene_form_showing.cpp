#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <algorithm>

#include "gui/forms/choice_row.hpp"
#include "gui/forms/field.hpp"
#include "gui/forms/scene_form.hpp"
#include "gui/look/said.hpp"
#include "gui/scene/completion_place.hpp"
#include "gui/scene/joints_edit.hpp"
#include "gui/scene/several_edit.hpp"
#include "gui/scene/table_path.hpp"
#include "gui/scene/toml_edit.hpp"

/// The text in the fields of a form: where each stands, values and errors.
namespace jointid::gui {
namespace {

std::string below(const std::string& table, const std::string& key) { return table.empty() ? key : table + "." + key; }

bool is_of_joint(const std::string& table) { return table == "joint" || table.starts_with("joint."); }

QString sentence(const SceneError& error) {
  return q(error.problem) + (error.remedy.empty() ? QString() : QStringLiteral("; ") + q(error.remedy));
}

/// "1: left" of every joint.
QStringList joint_names(const std::string& text) {
  QStringList names;
  for (int joint = 1; joint <= joints_in(text); ++joint) {
    const auto name = strings_in(value_of(text, "joints#" + std::to_string(joint), "name").value_or(""));
    names << QString::number(joint) + (name.empty() ? QString() : QStringLiteral(": ") + q(name.front()));
  }
  return names;
}

/// "1: 4:+Y, 5:+Y" of every table: its name, or its DOFs.
QStringList table_names(const std::string& text, const std::string& table) {
  QStringList names;
  for (int number = 1; number <= several_in(text, table); ++number) {
    names << QString::number(number);
    const std::string one = one_of_several(table, number);
    const auto value = value_of(text, one, "name");
    QStringList words;
    for (const std::string& word : strings_in(value ? *value : value_of(text, one, "dofs").value_or(""))) words << q(word);
    if (!words.isEmpty()) names.back() += QStringLiteral(": ") + words.join(QStringLiteral(", "));
  }
  return names;
}

QStringList file_names(const std::string& text) {
  QStringList names;
  for (const char* list : {"substructures", "assembly"}) {
    for (const std::string& name : strings_in(value_of(text, "data", list).value_or(""))) names << q(name);
  }
  names.removeDuplicates();
  return names;
}

}  // namespace

/// Where the fields of a section stand in the text.
std::string SceneForm::path_of(const std::string& table) const {
  if (written_) return table;
  if (table == any_file) return "data.files." + as_key(files_->chosen_name().toStdString());
  if (several_.contains(table)) return one_of_several(table, several_.at(table)->chosen() + 1);
  if (joints_in(text_) == 0 || !(is_of_joint(table) || table == all_joints)) return table;
  return "joints#" + std::to_string(joints_->chosen() + 1) + (table == all_joints ? "" : table.substr(5));
}

/// Whether a table has fields of its own in the text as it is: not where it stands as the value of a key, and those below other
/// tables than [joint] only where they have a header.
bool SceneForm::has_section(const std::string& table) const {
  if (written_ || table == all_joints) return true;
  if (table == any_file) return !value_of(text_, "data", "files") && files_->chosen() >= 0;
  const bool is_one = several_.contains(table);
  const std::string path = is_one ? table : path_of(table);
  const auto [above, key] = parted(path);
  if (above.empty() && !is_one) return true;
  if (value_of(text_, above, key)) return false;
  if (is_one) return true;
  return table.starts_with("joint.") || !tables_below(text_, path).empty();
}

/// Whether a key's field is shown where it is, and not as a section; those of several tables only where there are any.
bool SceneForm::is_shown(const std::string& table, const std::string& key) const {
  if (written_) return true;
  if (is_of_several(table)) return count_of(table) > 0;
  const std::string path = below(table, key);
  if (path == "data.files") return value_of(text_, "data", "files").has_value();
  const bool is_table = std::ranges::find(sections_, path, &Section::table) != sections_.end();
  return !is_table || !has_section(path);
}

void SceneForm::show_text(const std::string& text, const std::optional<SceneError>& error, bool of_another_kind) {
  text_ = text;
  error_ = error;
  if (of_another_kind) {
    build_as_written();
  } else {
    if (written_ || sections_.empty()) build();
    show_choices();
    if (error_ && error_->line > 0) choose_table_at(error_->line);
  }
  show_values();
  clear_errors();
  if (error_ && error_->line > 0) show_error(*error_);
}

/// How many there are of a table that is one of several.
int SceneForm::count_of(const std::string& table) const {
  return table == all_joints ? joints_in(text_) : several_in(text_, table);
}

void SceneForm::show_choices() {
  const QStringList names = joint_names(text_);
  joints_->show_names(names.isEmpty() ? QStringList{tr("the only one")} : names);
  files_->show_names(file_names(text_));
  offer(ValueKind::files, file_names(text_));
  for (const auto& [table, choice] : several_) choice->show_names(table_names(text_, table), 0);
}

/// Of another joint or file.
void SceneForm::show_again() {
  commit();
  show_values();
  clear_errors();
  if (error_ && error_->line > 0) show_error(*error_);
}

/// The joint or file in which something is wrong.
void SceneForm::choose_table_at(int line) {
  const std::string table = table_at(text_, line);
  for (int joint = 1; joint <= joints_in(text_); ++joint) {
    const std::string path = "joints#" + std::to_string(joint);
    if (table == path || table.starts_with(path + ".")) joints_->choose(joint - 1);
  }
  for (const auto& [several, choice] : several_) {
    for (int number = 1; number <= several_in(text_, several); ++number) {
      if (table == one_of_several(several, number)) choice->choose(number - 1);
    }
  }
  const QStringList files = file_names(text_);
  for (int file = 0; file < files.size(); ++file) {
    if (table == "data.files." + as_key(files[file].toStdString())) files_->choose(file);
  }
}

void SceneForm::show_values() {
  for (const Section& section : sections_) {
    const bool shown = has_section(section.table);
    section.box->setVisible(shown);
    if (shown) show_section(section);
  }
}

void SceneForm::show_section(const Section& section) {
  auto* const rows = static_cast<QFormLayout*>(section.box->layout());
  const std::string table = path_of(section.table);
  const auto [above, last] = parted(table);
  const bool in_one_value = section.table == any_file && value_of(text_, above, last).has_value();
  for (Field* field : section.fields) {
    const bool shown = is_shown(section.table, field->key());
    field->setVisible(shown);
    rows->labelForField(field)->setVisible(shown);
    if (!shown) continue;
    const auto value = value_of(text_, table, field->key());
    if (in_one_value || (!value && !tables_below(text_, below(table, field->key())).empty()))
      field->lock(in_one_value ? tr("The text has this file as one value.") : tr("This is a separate table in the text."));
    else
      field->show_value(value.value_or(""));
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
void SceneForm::show_error(const SceneError& error) {
  const Section* nearest = nullptr;
  int nearest_line = 0;
  for (const Section& section : sections_) {
    if (section.box->isHidden()) continue;
    for (Field* field : section.fields) {
      const auto lines = lines_of(text_, path_of(section.table), field->key());
      if (lines && (*lines)[0] <= error.line && error.line <= (*lines)[1]) return field->set_error(sentence(error));
    }
    const int header = line_of_key(text_, path_of(section.table), "");
    if (header <= error.line && header > nearest_line) {
      nearest = &section;
      nearest_line = header;
    }
  }
  if (nearest == nullptr) return;
  nearest->error->setText(sentence(error));
  nearest->error->show();
}

}  // namespace jointid::gui
