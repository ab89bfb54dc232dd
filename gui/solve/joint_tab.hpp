#pragma once

#include <QWidget>

#include "gui/solve/solve_job.hpp"

class QComboBox;

namespace jointid::gui {

class CellTable;

/// The joint matrices of a solution, one at a time.
class JointTab : public QWidget {
  Q_OBJECT

 public:
  explicit JointTab(QWidget* parent = nullptr);

  void show_run(const Solved& run);
  CellTable* matrix() const { return matrix_; }
  void show_element(const tasks::MatrixElement& element);

 private:
  void show_matrix();

  QComboBox* choice_;
  CellTable* matrix_;
  ident::Solution solution_;
};

}  // namespace jointid::gui
