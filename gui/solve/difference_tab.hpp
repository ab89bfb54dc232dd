#pragma once

#include <QWidget>
#include <functional>
#include <utility>
#include <vector>

#include "gui/solve/solve_job.hpp"

class QComboBox;
class QLabel;

namespace jointid::gui {

class CellTable;

/// The unknowns of the run in front beside those of another run, of this scene or of another one that is open: two tightenings.
class DifferenceTab : public QWidget {
  Q_OBJECT

 public:
  explicit DifferenceTab(QWidget* parent = nullptr);

  /// Runs to compare with, by name.
  using Others = std::vector<std::pair<QString, std::vector<ident::Estimate>>>;
  /// Where runs of other scenes come from; asked whenever the tab is seen.
  void set_elsewhere(std::function<Others()> elsewhere);
  void show_run(const std::vector<Solved>& runs, std::size_t front);

  /// No run.
  void clear();

  QComboBox* others() const { return other_; }
  CellTable* table() const { return table_; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void offer();
  void show_differences();

  QComboBox* other_;
  QLabel* word_;
  CellTable* table_;
  std::function<Others()> elsewhere_;
  std::vector<ident::Estimate> front_;
  Others own_, all_;
};

}  // namespace jointid::gui
