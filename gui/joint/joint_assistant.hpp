#pragma once

#include <QDialog>
#include <QTimer>
#include <array>
#include <functional>

#include "gui/work/worker.hpp"
#include "tasks/joint_forecast.hpp"
#include "tasks/joint/joint_layout.hpp"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLabel;
class QRadioButton;
class QTreeWidget;

namespace jointid::gui {

/// A joint chosen by its bolts: pairs of nodes of different parts are ticked, with the directions in which they hold, and what is unknown
/// between them. The number of unknowns stands beside each choice.
class JointAssistant : public QDialog {
  Q_OBJECT

 public:
  /// Pairs come from the positions of nodes (tasks::propose_pairs()); others can be added.
  explicit JointAssistant(std::vector<frf::FrfHeader> parts, QWidget* parent = nullptr);

  /// What is ticked. A plate that cannot be has no `plate`.
  tasks::JointLayout joint() const { return joint_in(form()); }
  /// Who foretells a choice, beside the window; what that says stands below the choices.
  using Forecast = std::function<tasks::JointForecast(const tasks::JointLayout&, const Worker::Watch&)>;
  void set_forecast(Forecast forecast);
  QString forecast() const;
  QTreeWidget* pairs() const { return list_; }

 private:
  QLayout* make_adding();
  QLayout* make_directions();
  QLayout* make_forms();
  void add(const tasks::NodePair& pair);
  void add_chosen();
  tasks::JointForm form() const;
  tasks::JointLayout joint_in(tasks::JointForm form) const;
  void show_counts();
  void show_word();
  void ask_forecast();
  void show_forecast(const tasks::JointForecast& forecast);

  std::vector<frf::FrfHeader> parts_;
  std::vector<tasks::NodePair> pairs_;  ///< row by row of the list
  QTreeWidget* list_;
  QComboBox *first_, *second_;
  std::array<QCheckBox*, 6> directions_{};  ///< by frf::Direction
  std::array<QRadioButton*, 4> forms_{};    ///< by tasks::JointForm
  QCheckBox* damping_;
  QLabel *word_, *forecast_text_;
  QDialogButtonBox* buttons_;
  Forecast forecast_;
  QTimer later_;       ///< until nothing has changed for a while
  Worker* worker_;
  std::size_t asked_ = 0;  ///< counts forecasts, so that only the last is shown
};

}  // namespace jointid::gui
