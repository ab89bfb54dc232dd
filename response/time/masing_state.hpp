#pragma once

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
  void forget_slopes(Eigen::Index parameters) override;

  /// Where the path turned, open corners and those that loops closed since, with their sensitivities.
  struct Turn {
    double displacement = 0.0;
    Row slope;
  };
  const std::vector<Turn>& turns() const { return turns_; }
  void forget_turns() { turns_.clear(); }

  /// The memory of a path that began without force at the first of `turns`, which is the largest displacement, and passed the others.
  void remember(const std::vector<Turn>& turns, double q);

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
