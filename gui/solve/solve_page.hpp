#pragma once

#include <QWidget>
#include <vector>

#include "gui/solve/solve_job.hpp"

class QComboBox;
class QPushButton;
class QTabWidget;

namespace jointid::gui {

class CellTable;
struct CellRows;
class DifferenceTab;
class FrfPlot;
class FrfTab;
class JobLine;
class JointTab;
class WorthRow;

/// What solving a scene will do, how far it is, and what came of it; earlier runs stay to be looked at.
class SolvePage : public QWidget {
  Q_OBJECT

 public:
  explicit SolvePage(QWidget* parent = nullptr);

  /// The scene as it stands. Its plan is made at once where reading headers is quick.
  void set_scene(std::optional<ident::Scene> scene);
  void set_file(const QString& file) { file_ = file; }

  void plan();
  /// What the data, or those of a model, can fix before anything is solved: needs a joint to assume ([truth] or [identify]
  /// start).
  void bound();
  /// A joint of more than tasks::many_unknowns is solved when it is asked for a second time.
  void solve();
  void cancel();
  bool is_busy() const;

  const std::vector<Solved>& runs() const { return runs_; }
  DifferenceTab* differences() const { return difference_tab_; }
  QString status() const;
  FrfPlot* plot() const;
  CellTable* unknowns() const { return unknowns_; }
  CellTable* springs() const { return springs_; }
  CellTable* matrix() const;
  CellTable* runs_table() const { return run_table_; }
  CellTable* findings() const { return findings_; }
  CellTable* bounds() const { return bounds_; }
  CellTable* plan_table() const { return plan_; }
  QTabWidget* results() const { return results_; }
  WorthRow* worth() const { return worth_; }

  /// Writes the page of the run in front, as `jointid solve --report` does, beside the window.
  void write_report(const QString& file);
  /// "jointid solve 'rig 1.toml'".
  QString command_line() const;

 Q_SIGNALS:
  /// Planning or solving found the scene or its data wrong.
  void failed(const jointid::InputError& error);
  void solved();
  /// Another run is in front: runs()[run].
  void run_shown(std::size_t run);

 private:
  QWidget* make_top();
  bool is_doubtful();
  void add_run(Solved solved);
  void plan_if_quick();
  void add_plan();
  void show_plan(const CellRows& rows);
  void show_status();
  void show_run(int run);
  void show_place(const tasks::WorthAnswer& answer);
  void save_json();
  void save_report();
  void save_table();
  QString proposed_name(const QString& ending) const;
  void save(const QString& file, const std::string& text);
  const Solved* current() const;

  QPushButton* solve_;
  QComboBox* run_choice_;
  JobLine* line_;
  WorthRow* worth_;
  QTabWidget* results_;
  CellTable *plan_, *bounds_, *unknowns_, *springs_, *findings_, *run_table_;
  JointTab* joint_tab_;
  FrfTab* frf_tab_;
  DifferenceTab* difference_tab_;
  std::optional<ident::Scene> scene_;
  std::vector<Solved> runs_;
  QString file_;
  bool renew_status_ = true;  ///< by the next plan
  std::size_t unknowns_warned_ = 0;  ///< of the joint that was not solved at once
  bool stale_ = false;        ///< the scene changed while something ran
};

}  // namespace jointid::gui
