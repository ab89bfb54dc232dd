#pragma once

#include <optional>

#include "friction/path/masing_path.hpp"
#include "response/time/joint_state.hpp"

namespace jointid::response {

/// Any law: a Masing path with its corners, and the sensitivities of each corner.
class MasingState final : public JointState {
 public:
  /// `law` must outlive it.
  explicit MasingState(const friction::Element& law);

  std::unique_ptr<JointState> clone() const override { return std::make_unique<MasingState>(*this); }
  friction::Response response(double q) const override;
  Row drift(double q) const override;
  void begin(double q, int direction, double force) override;
  double turn(double q, const Row& dq, Row& df) override;
  double reach(double q, const Row& dq, Row& df) override;
  void follow(Eigen::Index parameters) override;
  Row first_slope(double q, const Row& dq, const Row& given) const override;

  /// Where the path turned, with its sensitivities: all of them since forget_turns().
  struct Turn {
    double displacement = 0.0;
    Row slope;
  };
  const std::vector<Turn>& turns() const { return turns_; }
  void forget_turns() { turns_.clear(); }

  /// The memory of a path that came without force to the first of `turns`, the largest displacement, and passed the others up to
  /// q. Should that first turn move by dq, its force does by dT/du there, as that of a joint that chooses to have no residual
  /// force, or by `inside` dq.
  void remember(const std::vector<Turn>& turns, double q, std::optional<double> inside = {});

  /// df/dq where a cycle of a `range` turns, of a motion that stays within it.
  double tangent_at_turn(double range) const { return path_.element().response(0.5 * range).tangent; }

  /// Whether a cycle between displacements `range` apart leaves the joint any force from before: it does unless all of it slips.
  bool keeps_residual_force(double range) const;

 private:
  struct CornerSlope {
    Row displacement, force;
  };
  void choose_piece(int direction);
  void pass(double q);
  double piece_argument(double q) const;

  friction::MasingPath path_;
  friction::Branch branch_;
  int direction_ = 0;
  std::vector<double> kinks_;
  std::vector<CornerSlope> slopes_;
  std::vector<Turn> turns_;
  Eigen::Index parameters_ = 0;
};

}  // namespace jointid::response
