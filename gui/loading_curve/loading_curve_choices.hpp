#pragma once

#include <QWidget>

#include "tasks/loading_curve/loading_curve_task.hpp"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;

namespace jointid::gui {

class ChoiceButton;

/// Which columns of the files are what, and which laws are fitted to them.
class LoadingCurveChoices : public QWidget {
  Q_OBJECT

 public:
  explicit LoadingCurveChoices(QWidget* parent = nullptr);

  /// Columns to choose from, those of the first file.
  void offer(const QStringList& columns);
  /// All but the files.
  tasks::LoadingCurveTask task() const;

 private:
  QComboBox* column_box(const char* name, const QString& title, const QString& hint);

  QComboBox *displacement_, *force_, *energy_, *stiffness_, *damping_, *kind_, *weighting_;
  QLineEdit *unit_, *force_unit_;
  ChoiceButton* laws_;
  QDoubleSpinBox* limit_;
};

/// "jointid loading-curve 'rig.txt' --displacement position --law ren,iwan".
QString loading_curve_command(const tasks::LoadingCurveTask& task);

}  // namespace jointid::gui
