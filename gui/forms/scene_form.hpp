#pragma once

#include <QScrollArea>
#include <QStringList>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gui/scene/scene_check.hpp"
#include "gui/scene/scene_words.hpp"

class QGroupBox;
class QLabel;
class QVBoxLayout;

namespace jointid::gui {

class ChoiceRow;
class Field;

/// The scene's text as fields, one for each key that the scene reader names (gui/scene/scene_words.hpp). It holds nothing itself:
/// it shows the text and asks for edits of it. Of several joints, gains, masses and virtual points, and of the files, one is
/// shown, which can be chosen. Of a scene of another kind it shows what the text has: all its tables and their keys.
class SceneForm : public QScrollArea {
  Q_OBJECT

 public:
  explicit SceneForm(QWidget* parent = nullptr);

  /// Makes the fields when it is called first: a scene that is only looked at needs none.
  void show_text(const std::string& text, const std::optional<SceneError>& error, bool of_another_kind);
  void set_dofs(const QStringList& dofs);
  void set_folder(const QString& folder);
  /// Hands on what is typed into a field and not yet handed on.
  void commit();
  /// The cursor to the field that is wrong; false where none is.
  bool go_to_error();
  /// The cursor to the first files, or to what there is.
  void go_to_first();

  /// Of a table as all_tables() names it, and key; null where there is none. Those of "joint" are of the joint that is chosen, those of
  /// "data.files.*" of the file; "joints" has the name of the joint; "data.gains" is the one of [[data.gains]] that is chosen.
  Field* field(const std::string& table, const std::string& key) const;

 Q_SIGNALS:
  /// `value`: as written in the text, "" to leave the key out.
  void edit_wanted(const std::string& table, const std::string& key, const std::string& value);
  /// For the whole text.
  void text_wanted(const std::string& text);

 private:
  static constexpr const char* all_joints = "joints";  ///< the section of what only one of several has
  static constexpr const char* any_file = "data.files.*";
  struct Section {
    std::string table;
    QGroupBox* box;
    QLabel* error;
    std::vector<Field*> fields;
  };

  void build();
  void build_as_written();
  void begin_anew();
  void add_box(const std::string& table, const QString& title, QVBoxLayout& column);
  void add_section(const std::string& table, QVBoxLayout& column);
  void add_joints(QVBoxLayout& column);
  void add_choice(Section& section);
  void add_field(Section& section, const std::string& key, std::optional<ValueKind> as_written = {});
  std::string path_of(const std::string& table) const;
  bool has_section(const std::string& table) const;
  bool is_shown(const std::string& table, const std::string& key) const;
  int count_of(const std::string& table) const;
  void show_choices();
  void offer(ValueKind kind, const QStringList& names);
  void show_again();
  void show_values();
  void show_section(const Section& section);
  void show_error(const SceneError& error);
  void choose_table_at(int line);
  void clear_errors();

  struct Written {
    std::string table;
    std::vector<std::pair<std::string, ValueKind>> keys;
    bool operator==(const Written&) const = default;
  };
  std::vector<Written> written() const;

  std::vector<Section> sections_;
  std::optional<std::vector<Written>> written_;  ///< what the fields of a scene of another kind are made of
  QStringList dofs_;
  QString folder_;
  ChoiceRow *joints_ = nullptr, *files_ = nullptr;
  std::map<std::string, ChoiceRow*> several_;  ///< by table, but for the joints
  std::string text_;
  std::optional<SceneError> error_;
};

}  // namespace jointid::gui
