#pragma once

#include <QDialog>
#include <array>

#include "tasks/joint_layout.hpp"

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

  /// What is ticked.
  tasks::JointLayout joint() const { return joint_in(form()); }
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

  std::vector<frf::FrfHeader> parts_;
  std::vector<tasks::NodePair> pairs_;  ///< row by row of the list
  QTreeWidget* list_;
  QComboBox *first_, *second_;
  std::array<QCheckBox*, 6> directions_{};  ///< by frf::Direction
  std::array<QRadioButton*, 3> forms_{};    ///< by tasks::JointForm
  QCheckBox* damping_;
  QLabel* word_;
  QDialogButtonBox* buttons_;
};

}  // namespace jointid::gui
