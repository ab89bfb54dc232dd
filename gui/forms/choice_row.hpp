#pragma once

#include <QWidget>

class QComboBox;
class QPushButton;

namespace jointid::gui {

/// Which of several tables of one kind the fields below are of, and buttons for more and fewer of them.
class ChoiceRow : public QWidget {
  Q_OBJECT

 public:
  /// `name`: of the choice; the buttons are NAME_add and NAME_remove, where there are any.
  ChoiceRow(const char* name, const QString& title, bool with_buttons, QWidget* parent = nullptr);

  /// What is chosen stays chosen, by its place. `fewest`: that stay.
  void show_names(const QStringList& names, int fewest = 1);
  void choose(int number);
  int chosen() const;
  QString chosen_name() const;
  QComboBox* choice() const { return choice_; }

 Q_SIGNALS:
  void changed();
  void more_wanted();
  void fewer_wanted();

 private:
  QComboBox* choice_;
  QPushButton *add_ = nullptr, *remove_ = nullptr;
};

}  // namespace jointid::gui
