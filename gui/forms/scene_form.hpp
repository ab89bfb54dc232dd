#pragma once

#include <QScrollArea>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "gui/scene/scene_check.hpp"

class QGroupBox;
class QLabel;
class QVBoxLayout;

namespace jointid::gui {

class Field;

/// The scene's text as fields, one for each key that the scene reader names (gui/scene/scene_words.hpp). It holds nothing itself:
/// it shows the text and asks for edits of it.
class SceneForm : public QScrollArea {
  Q_OBJECT

 public:
  explicit SceneForm(QWidget* parent = nullptr);

  /// Makes the fields when it is called first: a scene that is only looked at needs none.
  void show_text(const std::string& text, const std::optional<SceneError>& error);
  void set_dofs(const QStringList& dofs);
  void set_folder(const QString& folder);
  /// Hands on what is typed into a field and not yet handed on.
  void commit();
  /// The cursor to the field that is wrong; false where none is.
  bool go_to_error();

  /// Of a table and key; null where there is none.
  Field* field(const std::string& table, const std::string& key) const;

 Q_SIGNALS:
  /// `value`: as written in the text, "" to leave the key out.
  void edit_wanted(const std::string& table, const std::string& key, const std::string& value);

 private:
  struct Section {
    std::string table;
    QGroupBox* box;
    QLabel* error;
    std::vector<Field*> fields;
  };

  void build();
  void add_section(const std::string& table, QVBoxLayout& column);
  void show_values(const std::string& text);
  void show_error(const std::string& text, const SceneError& error);
  void clear_errors();

  std::vector<Section> sections_;
  QStringList dofs_;
  QString folder_;
  QLabel* several_ = nullptr;  ///< what is said of scenes with several joints
};

}  // namespace jointid::gui
