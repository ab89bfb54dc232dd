#include "ident/judgement/line_jackknife.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/eigen.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/equations/linear_plan.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t least_lines = 4, most_groups = 12;

/// Puts other lines into a plan for as long as it lives.
class OtherLines {
 public:
  explicit OtherLines(Plan& plan) : plan_(plan), all_(plan.lines) {}
  ~OtherLines() { plan_.lines = std::move(all_); }
  OtherLines(const OtherLines&) = delete;
  OtherLines& operator=(const OtherLines&) = delete;

  const std::vector<Line>& all() const { return all_; }

 private:
  Plan& plan_;
  std::vector<Line> all_;
};

std::vector<std::vector<Line>> groups_of(const std::vector<Line>& lines, std::size_t most_lines, bool bands) {
  const std::size_t count = std::min(most_lines, lines.size()), groups = std::min(count, most_groups);
  std::vector<std::vector<Line>> out(groups);
  for (std::size_t i = 0; i < count; ++i) {
    out[bands ? i % groups : i * groups / count].push_back(lines[(2 * i + 1) * lines.size() / (2 * count)]);
  }
  return out;
}

/// The systems of the groups, each on its own.
std::vector<minimise::Accumulator> systems_of(Plan& plan, const std::vector<std::vector<Line>>& groups, const Control& control) {
  Control quick = control;
  quick.detail = Detail::estimates;
  quick.progress = {};
  RunTime time;
  std::vector<minimise::Accumulator> out;
  for (const std::vector<Line>& group : groups) {
    plan.lines = group;
    out.push_back(assemble(plan, time, quick).accumulator);
    out.back().flush();
  }
  return out;
}

}  // namespace

std::optional<Eigen::MatrixXd> line_jackknife(Plan& plan, std::size_t most_lines, const Control& control) {
  if (plan.lines.size() < least_lines || linear_plan(plan) == nullptr) return std::nullopt;
  OtherLines lines(plan);
  const auto groups = groups_of(lines.all(), most_lines, !plan.columns->limits_hz().empty());
  std::vector<minimise::Accumulator> systems = systems_of(plan, groups, control);
  const Eigen::Index unknowns = at(plan.columns->size()), count = at(groups.size());
  Eigen::MatrixXd found(unknowns, count);
  for (std::size_t left_out = 0; left_out < systems.size(); ++left_out) {
    minimise::Accumulator rest(plan.columns->size(), systems.front().reduction());
    for (std::size_t g = 0; g < systems.size(); ++g) {
      if (g != left_out) rest.merge(systems[g]);
    }
    const minimise::LinearSolution linear = solve(plan, rest, minimise::Condition::skip);
    if (linear.rank != plan.columns->size()) return std::nullopt;
    for (Eigen::Index u = 0; u < unknowns; ++u) found(u, at(left_out)) = linear.y[static_cast<std::size_t>(u)];
  }
  if (!found.allFinite()) return std::nullopt;
  const Eigen::MatrixXd apart = found.colwise() - found.rowwise().mean();
  const auto g = static_cast<double>(count);
  std::size_t used = 0;
  for (const auto& group : groups) used += group.size();
  const double to_all = static_cast<double>(used) / static_cast<double>(lines.all().size());
  return (g - 1.0) / g * to_all * apart * apart.transpose();
}

}  // namespace jointid::ident
