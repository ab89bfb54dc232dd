#pragma once

#include <QLabel>

namespace jointid::gui {

/// A text that reports a state, or an error in the colour of errors, whatever the theme becomes.
class StatusLabel : public QLabel {
 public:
  using QLabel::QLabel;

  void set_bad(bool bad);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void colour();

  bool bad_ = false;
};

}  // namespace jointid::gui
