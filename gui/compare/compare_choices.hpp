#pragma once

#include <QWidget>

#include "study/comparison.hpp"

namespace jointid::gui {

class ChoiceButton;

/// What a comparison tries: any number of methods, equations, weightings, Δ, solvers, and of systems whose FRFs their modes replace.
class CompareChoices : public QWidget {
  Q_OBJECT

 public:
  explicit CompareChoices(QWidget* parent = nullptr);

  study::Alternatives alternatives() const;
  /// " --weightings WA,WBS --deltas 0,0.05"
  QString options() const;

 private:
  ChoiceButton *methods_, *equations_, *weightings_, *deltas_, *solvers_, *regenerated_;
};

}  // namespace jointid::gui
