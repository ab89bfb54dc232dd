#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "base/eigen.hpp"

namespace jointid::oscillation {

/// Neighbours among points that follow each other in time, by a k-d tree (Bentley 1975); distances are Euclidean. Points |i − j|
/// ≤ w samples away (Theiler's window) are no neighbours: on a flow they are near because they are the same piece of the orbit.
class Neighbours {
 public:
  /// `points`: a row each, which must outlive this.
  Neighbours(const RowMatrixXd& points, std::size_t theiler);

  struct Near {
    std::size_t index = 0;
    double distance = 0.0;
  };
  /// The nearest j < `below` with |i − j| > w and distance > 0 (equal points are repetitions of a rounded record); of several
  /// equally near the first. Empty where there is none.
  std::optional<Near> nearest(std::size_t i, std::size_t below) const;

  /// Calls `visit(j)` for all j with |i − j| > w and distance ≤ radius.
  void within(std::size_t i, double radius, const std::function<void(std::size_t)>& visit) const;

 private:
  struct Node {
    std::size_t begin = 0, end = 0;  ///< its points in order_
    Eigen::Index axis = -1;          ///< −1: a leaf
    double split = 0.0;
    std::size_t left = 0, right = 0;
  };
  struct Search;

  std::size_t build(std::size_t begin, std::size_t end);
  bool is_apart(std::size_t i, std::size_t j) const;
  double square(std::size_t i, std::size_t j) const;
  void search(std::size_t node, std::size_t i, Search& search) const;
  void visit(std::size_t node, std::size_t i, double square, const std::function<void(std::size_t)>& visit) const;

  const RowMatrixXd& points_;
  std::size_t theiler_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace jointid::oscillation
