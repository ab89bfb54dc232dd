#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "gui/page/findings_page.hpp"
#include "gui/scene/scene_check.hpp"

class QComboBox;
class QPushButton;
class QSpinBox;

namespace jointid::gui {

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
  std::vector<std::function<Findings(const Worker::Watch&, std::size_t trials)>> run;
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
class ScenePage : public FindingsPage {
  Q_OBJECT

 public:
  explicit ScenePage(SceneKind kind, QWidget* parent = nullptr);

  bool is_of(const std::string& text) const { return kind_.is_of(text); }
  /// A scene of the kind, or anything else, with which the page has nothing to do. What is wrong with a scene of the kind. `file`: where
  /// it is saved, or empty.
  std::optional<SceneError> set_scene(const std::string& text, const std::filesystem::path& path, const QString& file);
  void run() override;
  /// What the scene is asked for; hidden where it can only be one thing.
  QComboBox* jobs() const { return jobs_; }
  /// "jointid response 'a.toml'".
  QString command_line() const override;

 private:
  QWidget* make_top();
  const SceneJob& job() const;
  void show_buttons() override;

  SceneKind kind_;
  QComboBox* jobs_;
  QSpinBox* trials_;
  QPushButton* run_;
  std::optional<SceneTask> task_;
  QString file_;
};

/// Whether a text has the header of a table, "[response]".
bool has_table(const std::string& text, const std::string& table);

}  // namespace jointid::gui
