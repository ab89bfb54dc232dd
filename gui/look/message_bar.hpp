#pragma once

#include <QFrame>
#include <functional>

class QPushButton;

namespace jointid::gui {

class StatusLabel;

/// A line above a page that says what happened, with at most one thing to do about it. It waits to be read instead of stopping
/// the user.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void say(const QString& text);
  void warn(const QString& text);
  void ask(const QString& text, const QString& action, std::function<void()> act);
  /// The same of what is no fault.
  void offer(const QString& text, const QString& action, std::function<void()> act);
  QString text() const;

 private:
  void show_action(const QString& action, std::function<void()> act);
  void show_text(const QString& text, bool bad);

  StatusLabel* label_;
  QPushButton* action_;
  std::function<void()> act_;
};

}  // namespace jointid::gui
