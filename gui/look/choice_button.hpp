#pragma once

#include <QStringList>
#include <QToolButton>

namespace jointid::gui {

/// A button with a menu of words, of which any number may be chosen: "method: one, two"; "as in the scene", say, where none is.
class ChoiceButton : public QToolButton {
  Q_OBJECT

 public:
  ChoiceButton(const char* name, const QString& title, const QStringList& words, QWidget* parent = nullptr);
  /// `none`: what stands where nothing is chosen, instead of "as in the scene".
  ChoiceButton(const char* name, const QString& title, const QStringList& words, const QString& none, const QString& hint,
               QWidget* parent = nullptr);

  /// Other words; those that were chosen stay chosen.
  void set_words(const QStringList& words);
  QStringList chosen() const;
  void choose(const QStringList& words);

 private:
  void show_choice();

  QString title_, none_;
  QList<QAction*> actions_;
};

}  // namespace jointid::gui
