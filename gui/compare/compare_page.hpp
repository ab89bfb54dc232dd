#pragma once

#include <QWidget>
#include <optional>

#include "gui/compare/compare_job.hpp"

class QComboBox;
class QPushButton;
class QSpinBox;

namespace jointid::gui {

class CellTable;
class Chart;
class CompareChoices;
class JobLine;

/// Ways to identify the joint of a scene, tried on the same trials with simulated noise: a table and a picture of error against
/// run time, both of which open a solution.
class ComparePage : public QWidget {
  Q_OBJECT

 public:
  explicit ComparePage(QWidget* parent = nullptr);

  void set_scene(std::optional<ident::Scene> scene);
  void set_file(const QString& file) { file_ = file; }
  void run();
  void cancel();
  bool is_busy() const;

  const study::Comparison& comparison() const { return comparison_; }
  QString status() const;
  Chart* chart() const { return chart_; }
  CellTable* table() const { return table_; }
  /// "jointid compare 'rig 1.toml' --trials 200 --seed 1 --weightings WA,WBS".
  QString command_line() const;

 Q_SIGNALS:
  void failed(const jointid::InputError& error);
  /// The user wants to see what this way gives.
  void way_opened(const jointid::study::Way& way);

 private:
  QWidget* make_top();
  void show_comparison(const study::Comparison& comparison);
  void show_matrix();
  void open_point(std::size_t group, std::size_t point);
  void choose_row(int row);
  /// Of a point of the picture, and the point of a combination.
  std::optional<std::size_t> combination_at(std::size_t group, std::size_t point) const;
  std::size_t matrix() const;

  QPushButton* run_;
  QSpinBox *trials_, *seed_;
  QComboBox* matrix_choice_;
  CompareChoices* choices_;
  JobLine* line_;
  Chart* chart_;
  CellTable* table_;
  std::optional<ident::Scene> scene_;
  study::Comparison comparison_;
  QString file_;
};

}  // namespace jointid::gui
