#pragma once

#include <QProgressBar>
#include <optional>

#include "base/stopwatch.hpp"
#include "gui/look/whole_share.hpp"

class QLabel;
class QLayout;

namespace jointid::gui {

/// How long a stage will go on at the pace that it had so far.
class TimeLeft {
 public:
  /// Seconds; empty for another stage than before, during its first half second, and where no share is known.
  std::optional<double> note(const QString& stage, double share, double now_s);

 private:
  QString stage_;
  double begun_s_ = 0.0, begun_share_ = 0.0;
};

/// "5 s", "3 min", "2.5 h".
QString duration_text(double seconds);

/// A bar with step, stage, share and time left; hidden while nothing runs.
class JobProgress : public QProgressBar {
  Q_OBJECT

 public:
  explicit JobProgress(const char* name, QWidget* parent = nullptr);

  void show_share(const JobShare& share);
  void set_busy(bool busy);

 private:
  TimeLeft left_;
  Clock::time_point begun_ = Clock::now();
};

/// What came of a job, and how far it is, beside each other.
QLayout* status_row(QLabel* status, JobProgress* progress);

}  // namespace jointid::gui
