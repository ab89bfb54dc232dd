#pragma once

#include <QWidget>
#include <optional>

#include "gui/work/worker.hpp"
#include "tasks/bound_report.hpp"

class QLineEdit;
class QPushButton;

namespace jointid::gui {

class CellTable;
class JobProgress;
class ListCompleter;
class StatusLabel;

/// Before measuring: the smallest errors that the data allow, and what further coordinates would bring, as `jointid plan --bound
/// --candidates` says.
class PlanPage : public QWidget {
  Q_OBJECT

 public:
  explicit PlanPage(QWidget* parent = nullptr);

  void set_scene(std::optional<ident::Scene> scene);
  void set_file(const QString& file) { file_ = file; }
  /// Names that are offered as candidates.
  void set_dofs(const QStringList& dofs);

  void predict();
  void cancel();
  bool is_busy() const;

  QString status() const;
  QLineEdit* candidates() const { return candidates_; }
  CellTable* bounds() const { return bounds_; }
  CellTable* ranking() const { return ranking_; }
  /// "jointid plan 'rig 1.toml' --bound --candidates 3:+Y,4:+RZ".
  QString command_line() const;

 Q_SIGNALS:
  void failed(const jointid::InputError& error);

 private:
  QWidget* make_top();
  void show_report(const tasks::BoundReport& report);
  void say(const QString& text, bool bad);
  void save_tables();

  QPushButton *predict_, *cancel_;
  QLineEdit* candidates_;
  ListCompleter* completer_;
  JobProgress* progress_;
  StatusLabel* status_;
  CellTable *bounds_, *ranking_;
  Worker* worker_;
  std::optional<ident::Scene> scene_;
  QString file_;
};

}  // namespace jointid::gui
