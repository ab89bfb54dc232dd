#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "gui/scene/scene_words.hpp"

class QComboBox;
class QLineEdit;

namespace jointid::gui {

class ListCompleter;
class StatusLabel;

/// A key of the scene to be filled in: a choice where the reader takes words or true and false, else a line. What is wrong with
/// it stands below it.
class Field : public QWidget {
  Q_OBJECT

 public:
  /// What the reader takes as value, or what the text has, of which no hint is known.
  Field(std::string table, std::string key, std::optional<ValueKind> as_written = {}, QWidget* parent = nullptr);

  const std::string& table() const { return table_; }
  const std::string& key() const { return key_; }

  /// As written in the text, "" where the key is not there. What is being typed is left alone.
  void show_value(const std::string& value);
  /// For a value that only the text can hold: it is said why.
  void lock(const QString& why);
  void set_error(const QString& error);
  QString error() const;
  /// Names that are offered where those of this kind are written: dofs or files.
  void offer(ValueKind kind, const QStringList& names);
  /// Files are named relative to this one.
  void set_folder(const QString& folder) { folder_ = folder; }

  /// Hands on what is typed, as if the field were left.
  void commit();
  /// What takes the focus.
  QWidget* input() const;

 Q_SIGNALS:
  /// `value`: as written in the text, "" to leave the key out.
  void changed(const std::string& value);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* make_line();
  QWidget* make_choice();
  QWidget* make_files_button();
  void choose_files();
  void set_shown(const QString& text, bool locked);
  bool paste();

  std::string table_, key_;
  ValueKind kind_;
  QString hint_, folder_;
  QLineEdit* line_ = nullptr;
  QComboBox* choice_ = nullptr;
  ListCompleter* completer_ = nullptr;
  StatusLabel* error_;
  bool pending_ = false;  ///< typed, and not yet handed on
};

}  // namespace jointid::gui
