#pragma once

#include <QWidget>
#include <vector>

#include "gui/solve/solve_job.hpp"

class QComboBox;
class QAction;
class QPushButton;
class QTabWidget;
class QToolButton;

namespace jointid::gui {

class CellTable;
struct CellRows;
class DifferenceTab;
class FrfPlot;
class FrfTab;
class JobLine;
class JointTab;
class PlotMenu;
class WorthRow;

/// What solving a scene will do, how far it is, and what came of it. Runs are kept beside the scene, and those of earlier days
/// are there again with it.
class SolvePage : public QWidget {
  Q_OBJECT

 public:
  explicit SolvePage(QWidget* parent = nullptr);

  /// The scene as it stands. Its plan is made at once where reading headers is quick.
  void set_scene(std::optional<ident::Scene> scene);
  /// Where the scene is saved, and its text. With the first file that is not empty its kept runs are read; with another one, all
  /// runs are kept there, too.
  void set_file(const QString& file, const std::string& text = {});

  void plan();
  /// What the data, or those of a model, can fix before anything is solved: needs a joint to assume ([truth] or [identify]
  /// start).
  void bound();
  /// A joint of more than tasks::many_unknowns is solved when it is asked for a second time.
  void solve();
  void cancel();
  bool is_busy() const;

  const std::vector<Solved>& runs() const { return runs_; }
  /// Brings a run to the front.
  void choose_run(std::size_t run);
  std::optional<std::size_t> run_in_front() const;
  /// Brings the run of this file to the front, now or when the kept runs are read.
  void want_run(const QString& kept_file);
  /// Takes the run in front out of the list, and its file from the disk.
  void remove_run();
  /// Objective and unknowns over the iterations of the run in front.
  PlotMenu* iterations() const { return iterations_menu_; }
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
  /// Another run is in front: runs()[run]; again when its plan is made.
  void run_shown(std::size_t run);
  /// The text of the scene of a run is to be that of the scene again.
  void text_wanted(const std::string& text);

 private:
  QWidget* make_top();
  QToolButton* make_run_menu();
  void read_runs();
  void add_kept(std::vector<Solved> runs, const QStringList& failed);
  void keep_all();
  void note_kept(const std::vector<std::pair<std::string, QString>>& kept);
  void list_runs(std::size_t front);
  void ask_for_plan(std::size_t run);
  void ask_to_remove();
  void clear_results();
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
  QAction *scene_of_run_, *remove_run_;
  PlotMenu* iterations_menu_;
  CellTable *plan_, *bounds_, *unknowns_, *springs_, *findings_, *run_table_;
  JointTab* joint_tab_;
  FrfTab* frf_tab_;
  DifferenceTab* difference_tab_;
  std::optional<ident::Scene> scene_;
  std::vector<Solved> runs_;
  QString file_, wanted_run_;
  std::string text_;
  bool renew_status_ = true;  ///< by the next plan
  std::size_t unknowns_warned_ = 0;  ///< of the joint that was not solved at once
  bool stale_ = false;        ///< the scene changed while something ran
};

}  // namespace jointid::gui
