#pragma once

#include <QWidget>
#include <vector>

#include "gui/solve/solve_job.hpp"

class QCheckBox;
class QComboBox;
class QLabel;

namespace jointid::gui {

class FrfPlot;

/// FRFs of the assembly as measured and as the joints of the runs give them.
class FrfTab : public QWidget {
  Q_OBJECT

 public:
  /// `worker` reads and computes.
  explicit FrfTab(Worker& worker, QWidget* parent = nullptr);

  /// The run in front, and with it all of the session.
  void show_runs(const std::vector<Solved>& runs, std::size_t front);
  /// No run.
  void clear();
  /// That FRF, and its error line by line.
  void show_error(const tasks::FrfEntry& entry);
  FrfPlot* plot() const { return plot_; }

 private:
  void show_frf();
  void show_next(int step);
  void show_overlay(const Overlay& overlay);

  Worker& worker_;
  QComboBox *response_, *reference_;
  QCheckBox* all_runs_;
  QLabel* error_db_;
  FrfPlot* plot_;
  std::vector<Solved> runs_;
  std::size_t front_ = 0;
  std::size_t wanted_ = 0;  ///< counts what was asked, so that only the last is drawn
};

}  // namespace jointid::gui
