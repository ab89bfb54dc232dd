#include "ident/newton/response_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/statistics.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t most_kept = 8'000'000;  // numbers

double square_sum(std::span<const double> values) {
  return std::transform_reduce(values.begin(), values.end(), 0.0, std::plus<>(), [](double each) { return each * each; });
}

}  // namespace

ResponseProblem::ResponseProblem(std::vector<ResponseLine> lines, std::size_t unknowns)
    : lines_(std::move(lines)), weight_(lines_.size(), 1.0), scale_(unknowns, 1.0), used_(lines_.size(), 1) {
  const std::vector<double> free(unknowns, 0.0);
  std::vector<std::vector<double>> norms(unknowns);
  std::vector<double> changes;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Line* const line = line_at(i, free, true);
    if (!line) continue;
    changes.push_back(std::sqrt(lines_[i].change()));
    const std::size_t count = lines_[i].columns().size();
    for (std::size_t t = 0; t < count; ++t) {
      double sum = 0.0;
      for (std::size_t row = 0; row < lines_[i].rows(); ++row) sum += std::pow(line->jacobian[row * count + t], 2);
      norms[lines_[i].columns()[t]].push_back(std::sqrt(sum));
    }
  }
  const double change = median(std::move(changes));
  for (std::size_t t = 0; t < unknowns; ++t) {
    const double middle = median(std::move(norms[t]));
    if (middle > 0.0) scale_[t] = (change > 0.0 ? change : 1.0) / middle;
  }
}

std::size_t ResponseProblem::residuals() const {
  std::size_t rows = 0;
  for (const ResponseLine& line : lines_) rows += line.rows();
  return rows;
}

std::vector<double> ResponseProblem::scaled(const std::vector<double>& theta) const {
  std::vector<double> q(theta);
  for (std::size_t t = 0; t < q.size(); ++t) q[t] /= scale_[t];
  return q;
}

std::vector<double> ResponseProblem::theta(std::span<const double> q) const {
  std::vector<double> theta(q.begin(), q.end());
  for (std::size_t t = 0; t < theta.size(); ++t) theta[t] *= scale_[t];
  return theta;
}

void ResponseProblem::work_out(std::size_t line, const std::vector<double>& theta, bool with_jacobian, Line& to) const {
  to.defined = false;
  if (interrupted_ && interrupted_()) return;
  const ResponseLine& own = lines_[line];
  to.f.resize(own.rows());
  if (with_jacobian) to.jacobian.resize(own.rows() * own.columns().size());
  to.defined = own.rows() > 0 &&
               (with_jacobian ? own.linearise(theta, to.f.data(), to.jacobian.data()) : own.residual(theta, to.f.data()));
}

/// Null where the line is not defined.
const ResponseProblem::Line* ResponseProblem::line_at(std::size_t line, const std::vector<double>& theta, bool with_jacobian) const {
  if (!kept_.empty() && theta == kept_at_ && kept_[line].defined) return &kept_[line];
  work_out(line, theta, with_jacobian, at_hand_);
  return at_hand_.defined ? &at_hand_ : nullptr;
}

void ResponseProblem::keep(const std::vector<double>& theta) {
  kept_at_.clear();
  std::size_t numbers = 0;
  for (const ResponseLine& line : lines_) numbers += line.rows() * (line.columns().size() + 1);
  if (numbers > most_kept) return;
  kept_.resize(lines_.size());
  for (std::size_t i = 0; i < lines_.size(); ++i) work_out(i, theta, true, kept_[i]);
  kept_at_ = theta;
}

bool ResponseProblem::each_line(std::span<const double> q, bool with_jacobian, const RowVisitor& visit) const {
  const std::vector<double> at = theta(q);
  std::vector<double> factor;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (!used_[i] || lines_[i].rows() == 0) continue;
    const Line* const line = line_at(i, at, with_jacobian);
    if (!line) return false;
    const auto& columns = lines_[i].columns();
    factor.clear();
    for (const std::size_t column : columns) factor.push_back(weight_[i] * scale_[column]);
    visit({line->f, with_jacobian ? std::span<const double>(line->jacobian) : std::span<const double>(), weight_[i], factor, columns});
  }
  return true;
}

bool ResponseProblem::evaluate(std::span<const double> q, std::span<double> r, std::span<double> jacobian) const {
  std::ranges::fill(r, 0.0);
  std::ranges::fill(jacobian, 0.0);
  std::size_t row = 0;
  return each_line(q, !jacobian.empty(), [&](const Rows& rows) {
    const std::size_t count = rows.columns.size();
    for (std::size_t i = 0; i < rows.f.size(); ++i, ++row) {
      r[row] = rows.weight * rows.f[i];
      for (std::size_t t = 0; t < count && !rows.jacobian.empty(); ++t) {
        jacobian[row * unknowns() + rows.columns[t]] = rows.factor[t] * rows.jacobian[i * count + t];
      }
    }
  });
}

void ResponseProblem::weigh_at(std::span<const double> q) {
  const std::vector<double> at = theta(q);
  keep(at);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    weight_[i] = 0.0;
    const Line* const line = line_at(i, at, true);
    if (!line) continue;
    const auto& columns = lines_[i].columns();
    double sum = 0.0;
    for (std::size_t k = 0; k < line->jacobian.size(); k += columns.size()) {
      for (std::size_t t = 0; t < columns.size(); ++t) sum += std::pow(line->jacobian[k + t] * scale_[columns[t]], 2);
    }
    if (sum > 0.0) weight_[i] = 1.0 / std::sqrt(sum);
  }
}

void ResponseProblem::distrust_outliers(std::span<const double> q) {
  const std::vector<double> at = theta(q);
  std::vector<double> sizes(lines_.size(), 0.0), known;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Line* const line = line_at(i, at, false);
    if (!line) continue;
    sizes[i] = weight_[i] * std::sqrt(square_sum(line->f) / static_cast<double>(line->f.size()));
    known.push_back(sizes[i]);
  }
  const double limit = 2.25 * median(std::move(known));
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (sizes[i] > limit) weight_[i] *= std::sqrt(limit / sizes[i]);
  }
}

void ResponseProblem::select_at(std::span<const double> q, const std::function<bool()>& draw) {
  const std::vector<double> at = theta(q);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Line* const line = line_at(i, at, false);
    used_[i] = line && lines_[i].correlation(line->f.data()) > 0.0;
  }
  const std::size_t least = 2 * unknowns();
  if (selected() < least) select_all();
  if (!draw) return;
  const std::vector<char> before = used_;
  for (char& used : used_) used = draw() && used;
  if (selected() < least) used_ = before;
}

void ResponseProblem::select_all() { std::ranges::fill(used_, char{1}); }

std::size_t ResponseProblem::selected() const { return static_cast<std::size_t>(std::ranges::count(used_, char{1})); }

double ResponseProblem::cost(std::span<const double> q) const {
  double sum = 0.0;
  const bool defined = each_line(q, false, [&](const Rows& rows) { sum += rows.weight * rows.weight * square_sum(rows.f); });
  return defined ? sum : std::numeric_limits<double>::infinity();
}

double ResponseProblem::misfit(std::span<const double> q) const {
  const std::vector<double> at = theta(q);
  double sum = 0.0, lines = 0.0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (lines_[i].rows() == 0 || !(lines_[i].change() > 0.0)) continue;
    lines += 1.0;
    const Line* const line = line_at(i, at, false);
    sum += line ? std::log1p(square_sum(line->f) / lines_[i].change()) : std::numeric_limits<double>::infinity();
  }
  return lines > 0.0 ? sum / lines : std::numeric_limits<double>::infinity();
}

}  // namespace jointid::ident
