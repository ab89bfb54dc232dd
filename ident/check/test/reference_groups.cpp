#include "ident/check/test/reference_groups.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/eigen.hpp"
#include "base/text.hpp"

namespace jointid::ident {
namespace {

constexpr double least_gap = 0.693, least_contrast = 1.386;  ///< log 2, log 4
constexpr std::size_t most_coordinates = 96;

/// Mean logarithms across and within a split.
struct SplitSums {
  double across = 0.0, within = 0.0, across_count = 0.0, within_count = 0.0;

  double contrast() const {
    if (across_count == 0.0) return 0.0;
    if (within_count == 0.0) return 0.0;
    return across / across_count - within / within_count;
  }
};

double contrast(const Eigen::MatrixXd& logs, const std::vector<bool>& in) {
  SplitSums sums;
  for (Eigen::Index i = 0; i < logs.rows(); ++i) {
    for (Eigen::Index j = i + 1; j < logs.cols(); ++j) {
      if (!std::isfinite(logs(i, j))) continue;
      const bool crosses = in[static_cast<std::size_t>(i)] != in[static_cast<std::size_t>(j)];
      (crosses ? sums.across : sums.within) += logs(i, j);
      (crosses ? sums.across_count : sums.within_count) += 1.0;
    }
  }
  return sums.contrast();
}

/// The best of all cuts of the order.
std::vector<bool> best_cut(const Eigen::MatrixXd& logs) {
  const auto n = static_cast<std::size_t>(logs.rows());
  std::vector<bool> in(n, true), best = in;
  double most = 0.0;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    in[k] = false;
    if (const double now = contrast(logs, in); now > most) {
      most = now;
      best = in;
    }
  }
  return best;
}

/// Moves single elements as long as that sharpens the split.
double sharpen(const Eigen::MatrixXd& logs, std::vector<bool>& in) {
  double best = contrast(logs, in);
  for (bool moved = true; moved;) {
    moved = false;
    for (std::size_t k = 0; k < in.size(); ++k) {
      in[k] = !in[k];
      if (const double now = contrast(logs, in); now > best + 0.01) {
        best = now;
        moved = true;
      } else {
        in[k] = !in[k];
      }
    }
  }
  return best;
}

}  // namespace

std::vector<std::size_t> upper_group(const std::vector<double>& levels) {
  const std::size_t n = levels.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> logs(n);
  std::ranges::transform(levels, logs.begin(), [](double level) { return std::log(std::max(level, 1e-12)); });
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return logs[a] < logs[b]; });
  const double total = std::accumulate(logs.begin(), logs.end(), 0.0);
  double below = 0.0, most = 0.0;
  std::size_t cut = n;
  double apart = 0.0;
  for (std::size_t k = 1; k < n; ++k) {
    below += logs[order[k - 1]];
    const auto low = static_cast<double>(k), high = static_cast<double>(n - k);
    const double gap = (total - below) / high - below / low, between = low * high * gap * gap;
    if (between > most) {
      most = between;
      cut = k;
      apart = gap;
    }
  }
  if (!(apart > least_gap)) return {};
  std::vector<std::size_t> out(order.begin() + static_cast<std::ptrdiff_t>(cut), order.end());
  std::ranges::sort(out);
  return out;
}

std::vector<std::size_t> group_that_differs(const Eigen::MatrixXd& cells) {
  const auto n = static_cast<std::size_t>(cells.rows());
  if (n < 3 || n > most_coordinates) return {};
  const Eigen::MatrixXd logs =
      cells.unaryExpr([](double cell) { return std::isfinite(cell) ? std::log(std::max(cell, 1e-12)) : cell; });
  std::vector<bool> in = best_cut(logs);
  if (!(sharpen(logs, in) > least_contrast)) return {};
  const auto count = static_cast<std::size_t>(std::ranges::count(in, true));
  const bool wanted = 2 * count < n || (2 * count == n && in.back());
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < n; ++k) {
    if (in[k] == wanted) out.push_back(k);
  }
  return out;
}

std::string group_text(const std::vector<frf::Dof>& dofs) {
  constexpr std::size_t all = 4;
  if (dofs.size() <= all) return comma_list(dofs, [](const frf::Dof& dof) { return dof.name(); });
  return dofs[0].name() + ", " + dofs[1].name() + " … " + dofs.back().name() + " (" + std::to_string(dofs.size()) + ")";
}

}  // namespace jointid::ident
