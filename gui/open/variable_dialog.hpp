#pragma once

#include <QDialog>

#include "gui/open/dropped_files.hpp"

class QComboBox;

namespace jointid::gui {

/// Which variable holds the FRFs, of every file that has several.
class VariableDialog : public QDialog {
  Q_OBJECT

 public:
  explicit VariableDialog(const std::vector<std::pair<QString, QStringList>>& undecided, QWidget* parent = nullptr);

  ChosenNames chosen() const;

 private:
  std::vector<std::pair<QString, QComboBox*>> boxes_;
};

}  // namespace jointid::gui
