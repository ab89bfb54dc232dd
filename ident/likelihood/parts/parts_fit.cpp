#include "ident/likelihood/parts/parts_fit.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>

#include "base/eigen.hpp"
#include "base/parallel.hpp"
#include "minimise/damping.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<double> own_unknowns(const GroupLine& line, const std::vector<std::size_t>& columns, const std::vector<double>& theta) {
  std::vector<double> out;
  for (const std::size_t place : line.columns) out.push_back(theta[columns[place]]);
  return out;
}

/// The corrected FRFs at a joint, from those of the line on: conditions are bilinear, so that a few linearisations do.
std::unique_ptr<GroupLinearisation> settled(const PartGroup& group, const PartGroups& all, GroupLine& line,
                                            const GroupImpedance& impedance) {
  constexpr int most = 30;
  constexpr double same = 1e-10, rounding = 1e-16;
  const VectorXd still = VectorXd::Zero(at(group.unknowns.size()));
  auto now = std::make_unique<GroupLinearisation>(group, all, line, impedance);
  for (int i = 0; i < most; ++i) {
    const double before = now->cost();
    line.current = now->corrected(still);
    now = std::make_unique<GroupLinearisation>(group, all, line, impedance);
    if (std::abs(now->cost() - before) <= same * before + rounding * static_cast<double>(line.conditions())) break;
  }
  return now;
}

/// What the lines of a group say together.
struct GroupSum {
  MatrixXd information;
  VectorXd gradient;
  std::vector<double> cost;  ///< by line
  std::vector<GroupFrfs<Complex>> current;
};

struct Point {
  std::vector<double> theta;
  std::vector<GroupSum> groups;
  double cost = 0.0;
};

/// The sparse normal matrix of all groups.
class SparseNormal {
 public:
  SparseNormal(std::size_t unknowns, std::size_t groups, const PartsData& data) : columns_(groups) {
    std::vector<std::vector<std::int64_t>> rows(unknowns);
    for (std::size_t c = 0; c < unknowns; ++c) rows[c].push_back(static_cast<std::int64_t>(c));
    for (std::size_t g = 0; g < groups; ++g) {
      columns_[g] = data.columns(g);
      for (std::size_t i = 0; i < columns_[g].size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) rows[columns_[g][j]].push_back(static_cast<std::int64_t>(columns_[g][i]));
      }
    }
    matrix_.start.push_back(0);
    for (std::vector<std::int64_t>& column : rows) {
      std::ranges::sort(column);
      column.erase(std::unique(column.begin(), column.end()), column.end());
      matrix_.row.insert(matrix_.row.end(), column.begin(), column.end());
      matrix_.start.push_back(static_cast<std::int64_t>(matrix_.row.size()));
    }
  }

  minimise::SparseSymmetric sum(const std::vector<GroupSum>& groups) const {
    minimise::SparseSymmetric out = matrix_;
    out.value.assign(out.row.size(), 0.0);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::vector<std::size_t>& columns = columns_[g];
      for (std::size_t j = 0; j < columns.size(); ++j) {
        const auto first = out.row.begin() + out.start[columns[j]], last = out.row.begin() + out.start[columns[j] + 1];
        for (std::size_t i = j; i < columns.size(); ++i) {
          const auto place = std::lower_bound(first, last, static_cast<std::int64_t>(columns[i])) - out.row.begin();
          out.value[static_cast<std::size_t>(place)] += groups[g].information(at(i), at(j));
        }
      }
    }
    return out;
  }

  std::vector<double> gradient(const std::vector<GroupSum>& groups) const {
    std::vector<double> out(matrix_.size(), 0.0);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      for (std::size_t i = 0; i < columns_[g].size(); ++i) out[columns_[g][i]] += groups[g].gradient[at(i)];
    }
    return out;
  }

 private:
  minimise::SparseSymmetric matrix_;
  std::vector<std::vector<std::size_t>> columns_;
};

std::unique_ptr<minimise::SparseFactor> sparse_factor() {
  return minimise::has_spqr() ? minimise::cholmod_cholesky() : minimise::ldlt_cholesky();
}

/// Factors that make the diagonal 1: unknowns of any unit.
std::vector<double> unit_scales(const minimise::SparseSymmetric& matrix) {
  std::vector<double> scale;
  for (std::size_t c = 0; c < matrix.size(); ++c) {
    const double diagonal = matrix.value[static_cast<std::size_t>(matrix.start[c])];
    scale.push_back(diagonal > 0.0 ? 1.0 / std::sqrt(diagonal) : 1.0);
  }
  return scale;
}

minimise::SparseSymmetric scaled_and_damped(minimise::SparseSymmetric matrix, const std::vector<double>& scale, double damping) {
  for (std::size_t c = 0; c < matrix.size(); ++c) {
    for (auto i = static_cast<std::size_t>(matrix.start[c]); i < static_cast<std::size_t>(matrix.start[c + 1]); ++i) {
      const auto row = static_cast<std::size_t>(matrix.row[i]);
      matrix.value[i] *= scale[c] * scale[row];
      if (row == c) matrix.value[i] += damping;
    }
  }
  return matrix;
}

class Descent {
 public:
  Descent(const Plan& plan, const PartGroups& all, PartsData& data, const PartsFitOptions& options)
      : plan_(plan), all_(all), data_(data), options_(options), normal_(plan.columns->size(), all.groups.size(), data),
        factor_(sparse_factor()) {}

  Point at_joint(std::vector<double> theta) {
    Point point{std::move(theta), std::vector<GroupSum>(all_.groups.size()), 0.0};
    for_each_index(all_.groups.size(), options_.threads, [&](std::size_t g) { point.groups[g] = sum_of(g, point.theta); });
    for (const GroupSum& group : point.groups) point.cost = std::accumulate(group.cost.begin(), group.cost.end(), point.cost);
    return point;
  }

  void accept(const Point& point) {
    for (std::size_t g = 0; g < all_.groups.size(); ++g) {
      for (std::size_t i = 0; i < data_.lines(); ++i) data_.groups()[g][i].current = point.groups[g].current[i];
    }
  }

  /// Descends from a point; whether it came to its end. That is the smallest step, or a gain below what the sum of all conditions is
  /// rounded by: the stiffer a joint, the coarser.
  bool descend(Point& point) {
    constexpr double enough = 1e-5, nothing = 1e-8, least_gain = 0.01;  // deviations; a tenth of one, squared
    constexpr int most = 60;
    minimise::Damping damping({.first = 1e-4, .least = 1e-8, .most = 1e12, .again = 1e-6});
    for (int i = 0; i < most; ++i) {
      const minimise::SparseSymmetric information = normal_.sum(point.groups);
      const std::vector<double> gradient = normal_.gradient(point.groups), scale = unit_scales(information);
      double size = 0.0, rounding = 0.0;
      std::optional<double> gain;
      bool at_end = false;
      const bool lowered = damping.search([&](double value) {
        const auto step = step_of(information, gradient, scale, value);
        if (!step) return false;
        size = largest(*step, scale);
        if (!gain) gain = -std::inner_product(step->begin(), step->end(), gradient.begin(), 0.0);
        std::vector<double> theta = point.theta;
        for (std::size_t c = 0; c < theta.size(); ++c) theta[c] += (*step)[c];
        Point next = at_joint(std::move(theta));
        at_end = size < enough && value <= 1.0;
        if (size < nothing) rounding = std::max(rounding, std::abs(next.cost - point.cost));
        if (!(next.cost < point.cost) && !(at_end && next.cost <= point.cost * (1.0 + 1e-9))) return at_end;
        point = std::move(next);
        return true;
      });
      if (!lowered) return gain && *gain < least_gain && *gain < rounding;
      accept(point);
      ++steps_;
      if (options_.step) options_.step(result(point));
      if (at_end) return true;
      damping.less();
    }
    return false;
  }

  PartsFit result(const Point& point) const {
    PartsFit out;
    out.theta = point.theta;
    out.cost = point.cost;
    out.line_cost.assign(data_.lines(), 0.0);
    for (const GroupSum& group : point.groups) {
      out.group_cost.push_back(std::accumulate(group.cost.begin(), group.cost.end(), 0.0));
      for (std::size_t i = 0; i < group.cost.size(); ++i) out.line_cost[i] += group.cost[i];
    }
    out.information = normal_.sum(point.groups);
    out.iterations = steps_;
    return out;
  }

 private:
  GroupSum sum_of(std::size_t g, const std::vector<double>& theta) const {
    const PartGroup& group = all_.groups[g];
    const Index size = at(data_.columns(g).size());
    GroupSum sum{MatrixXd::Zero(size, size), VectorXd::Zero(size), {}, {}};
    for (const GroupLine& each : data_.groups()[g]) {
      GroupLine line = each;
      const GroupImpedance impedance = group_impedance(group, own_unknowns(line, data_.columns(g), theta), line.omega, plan_.omega0);
      const auto found = settled(group, all_, line, impedance);
      for (std::size_t i = 0; i < line.columns.size(); ++i) {
        sum.gradient[at(line.columns[i])] += found->gradient()[at(i)];
        for (std::size_t j = 0; j < line.columns.size(); ++j)
          sum.information(at(line.columns[i]), at(line.columns[j])) += found->information()(at(i), at(j));
      }
      sum.cost.push_back(found->cost());
      sum.current.push_back(std::move(line.current));
    }
    return sum;
  }

  std::optional<std::vector<double>> step_of(const minimise::SparseSymmetric& information, const std::vector<double>& gradient,
                                             const std::vector<double>& scale, double damping) {
    if (!factor_->factorize(scaled_and_damped(information, scale, damping))) return std::nullopt;
    std::vector<double> right(gradient.size());
    for (std::size_t c = 0; c < right.size(); ++c) right[c] = -gradient[c] * scale[c];
    std::vector<double> step = factor_->solve(right);
    for (std::size_t c = 0; c < step.size(); ++c) {
      step[c] *= scale[c];
      if (!std::isfinite(step[c])) return std::nullopt;
    }
    return step;
  }

  static double largest(const std::vector<double>& step, const std::vector<double>& scale) {
    double out = 0.0;
    for (std::size_t c = 0; c < step.size(); ++c) out = std::max(out, std::abs(step[c]) / scale[c]);
    return out;
  }

  const Plan& plan_;
  const PartGroups& all_;
  PartsData& data_;
  const PartsFitOptions& options_;
  SparseNormal normal_;
  std::unique_ptr<minimise::SparseFactor> factor_;
  std::size_t steps_ = 0;
};

/// How far the unknowns went, in deviations of each alone.
double distance(const std::vector<double>& from, const PartsFit& to) {
  const std::vector<double> scale = unit_scales(to.information);
  double out = 0.0;
  for (std::size_t c = 0; c < from.size(); ++c) out = std::max(out, std::abs(to.theta[c] - from[c]) / scale[c]);
  return out;
}

}  // namespace

InformationSolver::InformationSolver(const minimise::SparseSymmetric& information)
    : scale_(unit_scales(information)), factor_(sparse_factor()),
      definite_(factor_->factorize(scaled_and_damped(information, scale_, 0.0))) {}

std::vector<double> InformationSolver::operator()(std::vector<double> right) const {
  for (std::size_t c = 0; c < right.size(); ++c) right[c] *= scale_[c];
  std::vector<double> out = factor_->solve(right);
  for (std::size_t c = 0; c < out.size(); ++c) out[c] *= scale_[c];
  return out;
}

PartsFit fit_by_parts(const Plan& plan, const PartGroups& groups, PartsData& data, std::vector<double> start,
                      const PartsFitOptions& options) {
  constexpr int most_rounds = 10;
  constexpr double stays = 1e-3;
  Descent iteration(plan, groups, data, options);
  Point point = iteration.at_joint(std::move(start));
  iteration.accept(point);
  bool converged = false;
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<double> before = point.theta;
    converged = iteration.descend(point);
    if (!converged || (round > 0 && distance(before, iteration.result(point)) < stays)) break;
    if (!data.reweigh()) break;
    point = iteration.at_joint(point.theta);
    iteration.accept(point);
  }
  PartsFit out = iteration.result(point);
  out.converged = converged;
  return out;
}

}  // namespace jointid::ident
