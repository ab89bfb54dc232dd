#pragma once

#include <QWidget>
#include <string>

#include "gui/work/worker.hpp"

class QPushButton;

namespace jointid::gui {

class JobProgress;
class StatusLabel;

/// The worker of a page, what came of its jobs in a line of text, how far it is, and the button that cancels.
class JobLine : public QWidget {
  Q_OBJECT

 public:
  /// Widgets are named NAME_status, NAME_progress and NAME_cancel.
  JobLine(const std::string& name, const QString& accessible_name, const QString& cancel_hint, QWidget* parent = nullptr);

  Worker& worker() { return *worker_; }
  /// To be put among the page's buttons; it can be used while something runs.
  QPushButton* cancel_button() const { return cancel_; }
  /// What the line says after a job was cancelled that delivered nothing.
  void set_cancelled_text(const QString& text) { cancelled_text_ = text; }

  void say(const QString& text, bool bad = false);
  QString status() const;
  bool is_busy() const { return worker_->is_busy(); }
  void cancel() { worker_->cancel(); }

 Q_SIGNALS:
  /// After the line has said it.
  void failed(const jointid::InputError& error);
  void busy_changed(bool busy);

 private:
  Worker* worker_;
  StatusLabel* status_;
  JobProgress* progress_;
  QPushButton* cancel_;
  QString cancelled_text_;
};

}  // namespace jointid::gui
