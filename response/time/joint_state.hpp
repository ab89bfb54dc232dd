#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "friction/path/element.hpp"

namespace jointid::response {

/// A stretch of a joint's motion on which its force is one smooth function of q.
struct Piece {
  int direction = 0;  ///< +1 or −1: it ends where q̇ turns; 0: turning does not matter
  double lower = -friction::infinity, upper = friction::infinity;  ///< it ends where q comes there
  std::optional<double> stiffness;                                 ///< df/dq where it is constant
};

/// The memory of a friction joint along its motion, and what that memory owes to parameters (columns of sensitivities,
/// response.md §7). Rows of sensitivities are 1 × m; m = 0 where none are followed.
class JointState {
 public:
  using Row = Eigen::RowVectorXd;

  virtual ~JointState() = default;
  virtual std::unique_ptr<JointState> clone() const = 0;

  const Piece& piece() const { return piece_; }

  /// f and df/dq at q on the present piece, continued beyond its ends.
  virtual friction::Response response(double q) const = 0;

  /// df = response(q).tangent · dq + drift(q): sensitivity of the force on the present piece.
  virtual Row drift(double q) const = 0;

  /// The motion begins, or goes on, at q in this direction. `force` is that of a joint whose memory it is.
  virtual void begin(double q, int direction, double force) = 0;

  /// The piece ends at q because the motion turns, or because q came to a bound of it; dq of q at that time, df of the force
  /// there, which is put right for the piece that begins. Returns the force.
  virtual double turn(double q, const Row& dq, Row& df) = 0;
  virtual double reach(double q, const Row& dq, Row& df) = 0;

  /// Sensitivities have m columns from here on: 0 where the memory had another number of them.
  virtual void follow(Eigen::Index parameters) = 0;

  /// df where the motion begins: `given` for a joint whose force is its memory, else what the memory owes to the parameters.
  virtual Row first_slope(double q, const Row& dq, const Row& given) const = 0;

 protected:
  Piece piece_;
};

}  // namespace jointid::response
