#pragma once

#include <QStringList>
#include <QToolButton>

namespace jointid::gui {

/// A button with a menu of words, of which any number may be chosen: "method: one, two"; "as in the scene" where none is.
class ChoiceButton : public QToolButton {
  Q_OBJECT

 public:
  ChoiceButton(const char* name, const QString& title, const QStringList& words, QWidget* parent = nullptr);

  QStringList chosen() const;
  void choose(const QStringList& words);

 private:
  void show_choice();

  QString title_;
  QList<QAction*> actions_;
};

}  // namespace jointid::gui
