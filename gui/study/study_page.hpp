#pragma once

#include <QWidget>
#include <optional>

#include "gui/study/study_job.hpp"

class QCheckBox;
class QComboBox;
class QPushButton;
class QSpinBox;

namespace jointid::gui {

class CellTable;
class Chart;
class JobLine;

/// Identifying over and over with simulated noise: histograms of the unknowns that grow, and their statistics at the end. The
/// trials lie in a file beside the scene; what is done stays there when it is cancelled, and is taken up by the next run.
class StudyPage : public QWidget {
  Q_OBJECT

 public:
  explicit StudyPage(QWidget* parent = nullptr);

  /// The scene as it stands in its file, or nothing.
  void set_scene(std::optional<ident::Scene> scene, const std::string& text, const QString& file);
  void run();
  void cancel();
  bool is_busy() const;

  void set_trials(int trials);
  QString status() const;
  Chart* chart() const { return chart_; }
  CellTable* table() const { return table_; }
  /// SCENE's name with .study.h5, beside the scene.
  QString result_file() const;
  /// "jointid study 'rig 1.toml' --trials 1000 --seed 1 --out 'rig 1.study.h5'", with --resume where there is something to take
  /// up.
  QString command_line() const;

 Q_SIGNALS:
  void failed(const jointid::InputError& error);

 private:
  QWidget* make_top();
  void show_study(const StudyShown& shown);
  void show_set();
  bool can_go_on() const;

  QPushButton* run_;
  QSpinBox *trials_, *seed_;
  QCheckBox* anew_;
  QComboBox* set_choice_;
  JobLine* line_;
  Chart* chart_;
  CellTable* table_;
  std::optional<ident::Scene> scene_;
  std::string text_;
  QString file_;
  std::vector<HistogramSet> histograms_;
};

}  // namespace jointid::gui
