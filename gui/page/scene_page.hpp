#pragma once

#include <QWidget>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "gui/page/output_buttons.hpp"
#include "gui/page/plot_menu.hpp"
#include "gui/page/table_menu.hpp"
#include "gui/scene/scene_check.hpp"
#include "gui/work/worker.hpp"

class QComboBox;
class QPushButton;
class QSpinBox;

namespace jointid::gui {

class JobLine;

/// What a run found, as it is shown.
struct SceneFindings {
  QString said;
  bool is_bad = false;
  std::vector<PlotMenu::Named> plots;
  std::vector<TableMenu::Named> tables;
  Outputs outputs;
};

/// What a scene can be asked for.
struct SceneJob {
  QString title;           ///< in a menu, where there are several
  QString run, run_hint;   ///< of the button
  QString command, after;  ///< "jointid plan", and what stands behind the scene, " --bound"
  bool counts_trials = false;
};

/// A scene that was read.
struct SceneTask {
  /// Of each job of the kind; with the number of trials where it counts them. Throws InputError, and Interrupted.
  std::vector<std::function<SceneFindings(const Worker::Watch&, std::size_t trials)>> run;
  std::vector<std::filesystem::path> inputs;  ///< that no output may replace
};

/// Scenes of another kind than those that identify a joint.
struct SceneKind {
  std::string name;  ///< of widgets
  QString title, plots, plot_hint, tables;
  std::vector<SceneJob> jobs;  ///< one at least
  std::function<bool(const std::string& text)> is_of;
  /// Throws InputError.
  std::function<SceneTask(const std::string& text, const std::filesystem::path& file)> read;
};

/// A page for one kind of scene: runs what the command does with it, shows diagrams and tables, and writes what the command writes.
class ScenePage : public QWidget {
  Q_OBJECT

 public:
  explicit ScenePage(SceneKind kind, QWidget* parent = nullptr);

  bool is_of(const std::string& text) const { return kind_.is_of(text); }
  /// A scene of the kind, or anything else, with which the page has nothing to do. What is wrong with a scene of the kind. `file`: where
  /// it is saved, or empty.
  std::optional<SceneError> set_scene(const std::string& text, const std::filesystem::path& path, const QString& file);
  void run();
  void cancel();
  bool is_busy() const;

  const SceneFindings* shown() const { return found_.get(); }
  QString status() const;
  /// What the scene is asked for; hidden where it can only be one thing.
  QComboBox* jobs() const { return jobs_; }
  PlotMenu* plots() const { return plots_; }
  TableMenu* tables() const { return tables_; }
  /// "jointid response 'a.toml'".
  QString command_line() const;
  /// What the command writes with this ending; says in the status what went wrong.
  void write(const QString& file, const QString& ending) { outputs_->write(file, ending); }

 Q_SIGNALS:
  void failed(const jointid::InputError& error);

 private:
  QWidget* make_top();
  const SceneJob& job() const;
  void show_found(std::shared_ptr<const SceneFindings> found);
  void show_buttons();

  SceneKind kind_;
  QComboBox* jobs_;
  QSpinBox* trials_;
  QPushButton *run_, *command_;
  OutputButtons* outputs_;
  JobLine* line_;
  PlotMenu* plots_;
  TableMenu* tables_;
  std::optional<SceneTask> task_;
  QString file_;
  std::shared_ptr<const SceneFindings> found_;
};

/// Whether a text has the header of a table, "[response]".
bool has_table(const std::string& text, const std::string& table);

}  // namespace jointid::gui
