#pragma once

#include <QWidget>
#include <vector>

#include "tasks/worth.hpp"

class QPushButton;

namespace jointid::gui {

/// A light for each question of what a solution is worth: its colour, a sign for those who do not see colours, and the answer under the
/// mouse. A click asks for the place that the answer is about.
class WorthRow : public QWidget {
  Q_OBJECT

 public:
  explicit WorthRow(QWidget* parent = nullptr);

  /// In the order of the questions; hides the row where there are none.
  void show_answers(std::vector<tasks::WorthAnswer> answers);
  const std::vector<QPushButton*>& lights() const { return lights_; }

 Q_SIGNALS:
  void chosen(const jointid::tasks::WorthAnswer& answer);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void colour();

  std::vector<QPushButton*> lights_;
  std::vector<tasks::WorthAnswer> answers_;
};

}  // namespace jointid::gui
