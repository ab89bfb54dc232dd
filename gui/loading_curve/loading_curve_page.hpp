#pragma once

#include <QWidget>
#include <memory>

#include "gui/work/worker.hpp"
#include "tasks/loading_curve/loading_curve_result.hpp"

class QComboBox;
class QLabel;
class QPushButton;
class QTabWidget;

namespace jointid::gui {

class CellTable;
class JobLine;
class LoadingCurveChoices;
class PlotMenu;

/// Friction laws fitted to measured curves, as `jointid loading-curve` does: curves with their fits and residuals, k_e and d_e
/// over amplitude, laws and parameters. Needs no scene; files are chosen or dropped.
class LoadingCurvePage : public QWidget {
  Q_OBJECT

 public:
  explicit LoadingCurvePage(QWidget* parent = nullptr);

  void open(const QStringList& files);
  void run();
  void cancel();
  bool is_busy() const;

  const tasks::LoadingCurveResult* shown() const { return report_.get(); }
  QString status() const;
  PlotMenu* plots() const { return plots_; }
  CellTable* laws() const { return laws_; }
  CellTable* parameters() const { return parameters_; }
  CellTable* equivalents() const { return equivalents_; }
  QTabWidget* tables() const { return tables_; }
  QString command_line() const;

 Q_SIGNALS:
  void failed(const jointid::InputError& error);

 private:
  QWidget* make_top();
  QTabWidget* make_tables();
  void show_report(std::shared_ptr<const tasks::LoadingCurveResult> report);
  void show_law(int row);
  void show_buttons();
  tasks::LoadingCurveTask task() const;

  QPushButton *fit_, *command_;
  QLabel* names_;
  LoadingCurveChoices* choices_;
  JobLine* line_;
  PlotMenu* plots_;
  QTabWidget* tables_;
  CellTable *laws_, *parameters_, *equivalents_, *loops_;
  QStringList files_;
  std::shared_ptr<const tasks::LoadingCurveResult> report_;
};

}  // namespace jointid::gui
