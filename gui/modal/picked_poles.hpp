#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "modalfit/model/fit.hpp"

namespace jointid::gui {

/// Poles that were picked, as a list of steps that can be undone; nothing: all that a fit finds by itself.
class PickedPoles {
 public:
  using Poles = std::optional<std::vector<modalfit::Pole>>;

  /// Forgets all steps.
  void begin();
  void pick(std::vector<modalfit::Pole> poles);
  bool can_undo() const { return now_ > 0; }
  bool can_redo() const { return now_ + 1 < steps_.size(); }
  void undo();
  void redo();
  const Poles& now() const { return steps_[now_]; }

 private:
  std::vector<Poles> steps_ = {std::nullopt};
  std::size_t now_ = 0;
};

/// The poles and one more: a candidate of the stabilisation diagram, whose damping is ζ whatever `kind` says.
std::vector<modalfit::Pole> with_pole(std::vector<modalfit::Pole> poles, const modalfit::ModelKind& kind,
                                      const modalfit::CandidatePole& pole);

/// The poles without the one nearest to a frequency.
std::vector<modalfit::Pole> without_pole(std::vector<modalfit::Pole> poles, double frequency_hz);

}  // namespace jointid::gui
