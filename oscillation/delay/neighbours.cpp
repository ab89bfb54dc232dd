#include "oscillation/delay/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace jointid::oscillation {
namespace {

constexpr std::size_t leaf = 12;

}  // namespace

struct Neighbours::Search {
  std::size_t below;
  double square = std::numeric_limits<double>::infinity();
  std::size_t index = 0;
};

Neighbours::Neighbours(const RowMatrixXd& points, std::size_t theiler)
    : points_(points), theiler_(theiler), order_(static_cast<std::size_t>(points.rows())) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (!order_.empty()) build(0, order_.size());
}

std::size_t Neighbours::build(std::size_t begin, std::size_t end) {
  const std::size_t self = nodes_.size();
  nodes_.push_back({begin, end, -1, 0.0, 0, 0});
  if (end - begin <= leaf) return self;
  Eigen::Index axis = 0;
  double widest = -1.0;
  for (Eigen::Index k = 0; k < points_.cols(); ++k) {
    double low = points_(at(order_[begin]), k), high = low;
    for (std::size_t m = begin; m < end; ++m) {
      low = std::min(low, points_(at(order_[m]), k));
      high = std::max(high, points_(at(order_[m]), k));
    }
    if (high - low > widest) widest = high - low, axis = k;
  }
  if (!(widest > 0.0)) return self;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto place = [&](std::size_t m) { return order_.begin() + static_cast<std::ptrdiff_t>(m); };
  std::nth_element(place(begin), place(middle), place(end),
                   [&](std::size_t a, std::size_t b) { return points_(at(a), axis) < points_(at(b), axis); });
  nodes_[self].axis = axis;
  nodes_[self].split = points_(at(order_[middle]), axis);
  const std::size_t left = build(begin, middle), right = build(middle, end);
  nodes_[self].left = left;
  nodes_[self].right = right;
  return self;
}

bool Neighbours::is_apart(std::size_t i, std::size_t j) const { return (i > j ? i - j : j - i) > theiler_; }

double Neighbours::square(std::size_t i, std::size_t j) const { return (points_.row(at(i)) - points_.row(at(j))).squaredNorm(); }

void Neighbours::search(std::size_t node, std::size_t i, Search& found) const {
  const Node& here = nodes_[node];
  if (here.axis < 0) {
    for (std::size_t m = here.begin; m < here.end; ++m) {
      const std::size_t j = order_[m];
      if (j >= found.below || !is_apart(i, j)) continue;
      const double s = square(i, j);
      if (s > 0.0 && (s < found.square || (s == found.square && j < found.index))) found.square = s, found.index = j;
    }
    return;
  }
  const double beyond = points_(at(i), here.axis) - here.split;
  search(beyond < 0.0 ? here.left : here.right, i, found);
  if (beyond * beyond <= found.square) search(beyond < 0.0 ? here.right : here.left, i, found);
}

std::optional<Neighbours::Near> Neighbours::nearest(std::size_t i, std::size_t below) const {
  Search found{below};
  search(0, i, found);
  if (!std::isfinite(found.square)) return std::nullopt;
  return Near{found.index, std::sqrt(found.square)};
}

void Neighbours::visit(std::size_t node, std::size_t i, double limit, const std::function<void(std::size_t)>& call) const {
  const Node& here = nodes_[node];
  if (here.axis < 0) {
    for (std::size_t m = here.begin; m < here.end; ++m) {
      const std::size_t j = order_[m];
      if (is_apart(i, j) && square(i, j) <= limit) call(j);
    }
    return;
  }
  const double beyond = points_(at(i), here.axis) - here.split;
  if (beyond <= 0.0 || beyond * beyond <= limit) visit(here.left, i, limit, call);
  if (beyond >= 0.0 || beyond * beyond <= limit) visit(here.right, i, limit, call);
}

void Neighbours::within(std::size_t i, double radius, const std::function<void(std::size_t)>& call) const {
  visit(0, i, radius * radius, call);
}

}  // namespace jointid::oscillation
