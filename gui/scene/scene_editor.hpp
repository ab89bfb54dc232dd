#pragma once

#include <QPlainTextEdit>
#include <QTimer>
#include <optional>

#include "gui/scene/completion_place.hpp"
#include "gui/scene/scene_check.hpp"

class QCompleter;

namespace jointid::gui {

class AnnotatedLayout;
class TomlHighlighter;

/// The text of a scene: coloured, with line numbers, completion of tables, keys, words and DOFs (Ctrl+Space, and while one
/// types), and what is wrong written below its line.
class SceneEditor : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit SceneEditor(QWidget* parent = nullptr);

  std::string text() const;
  /// Replaces the text by one step that can be undone; what is the same at its beginning and end is not touched.
  void replace_text(const std::string& text);

  void set_error(std::optional<SceneError> error);
  const std::optional<SceneError>& error() const { return error_; }

  /// DOFs that are offered in strings.
  void set_dofs(const QStringList& dofs) { dofs_ = dofs; }
  /// What could be written at the cursor.
  QStringList completions() const;

  void go_to_line(int line);

 Q_SIGNALS:
  /// Nothing was typed for a moment, or the text was replaced.
  void settled();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  CompletionPlace place() const;
  void complete(bool asked_for);
  void insert_completion(const QString& word);
  void annotate();
  void paint_margin();
  int margin_width() const;
  QString annotation() const;

  AnnotatedLayout* layout_;
  TomlHighlighter* highlighter_;
  QCompleter* completer_;
  QWidget* margin_;
  QTimer settle_;
  QStringList dofs_;
  std::optional<SceneError> error_;
};

}  // namespace jointid::gui
