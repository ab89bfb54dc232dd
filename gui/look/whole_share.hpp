#pragma once

#include <QString>
#include <cstddef>

namespace jointid::gui {

/// A step of a job, and its part of the whole.
struct JobStep {
  std::size_t number = 1, of = 1;
  double begin = 0.0, end = 1.0;  ///< shares of the whole
  std::size_t passes = 1;         ///< expected: a pass ends with another stage, or where its share falls
};

/// How far a job is.
struct JobShare {
  QString stage;        ///< what it does now
  double share = -1.0;  ///< 0 to 1; negative where it is not known
  std::size_t number = 1, of = 1;
  bool is_whole = false;  ///< of the whole job; else of the stage alone
};

/// Makes shares of the whole job of those of its stages. Before a step begins, shares are those of the stage.
class WholeShare {
 public:
  void begin(const JobStep& step);
  /// `share` of the stage; negative where it is not known. The share of the whole never falls.
  JobShare note(const QString& stage, double share);

 private:
  JobStep step_;
  bool has_steps_ = false;
  QString stage_;
  double last_ = 0.0, whole_ = 0.0;
  std::size_t pass_ = 0;  ///< of the step, from 1
};

}  // namespace jointid::gui
