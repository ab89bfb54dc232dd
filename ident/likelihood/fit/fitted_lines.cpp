#include "ident/likelihood/fit/fitted_lines.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "base/eigen.hpp"
#include "base/stop_scope.hpp"
#include "ident/likelihood/model/corrected_line.hpp"
#include "ident/likelihood/model/line_gradient.hpp"
#include "ident/likelihood/line/robust_loss.hpp"

namespace jointid::ident {
namespace {

Eigen::VectorXd pick(const Eigen::VectorXd& all, const std::vector<std::size_t>& which) {
  Eigen::VectorXd out(at(which.size()));
  for (std::size_t i = 0; i < which.size(); ++i) out[at(i)] = all[at(which[i])];
  return out;
}

std::vector<std::vector<double>> nearby(const std::vector<double>& theta, const std::vector<Eigen::VectorXd>& offsets) {
  std::vector<std::vector<double>> out;
  for (const Eigen::VectorXd& offset : offsets) {
    out.push_back(theta);
    for (std::size_t i = 0; i < theta.size(); ++i) out.back()[i] += offset[at(i)];
  }
  return out;
}

std::vector<JointNearby> joints_nearby(const FittedLine& line, const std::vector<std::vector<double>>& nearby,
                                       const std::vector<Eigen::VectorXd>& offsets) {
  std::vector<JointNearby> out;
  for (std::size_t k = 0; k < offsets.size(); ++k) out.push_back({line.joint.at(nearby[k]), pick(offsets[k], line.columns)});
  return out;
}

}  // namespace

FittedLines::FittedLines(LikelihoodData& data, const restrictions::Restriction& restriction, const UnknownColumns& columns, double omega0,
                         std::size_t threads)
    : data_(&data), joint_unknowns_(columns.size()), threads_(threads), own_(data.shares().own(data.lines().size())) {
  if (!data.systematic().empty()) corrected_.resize(data.lines().size());
  for (std::size_t i = 0; i < data.lines().size(); ++i) {
    const LineData& each = data.lines()[i];
    FittedLine line{joint_at(restriction, columns, omega0, each.omega), {}, {}, 0.0, 0.0, 1.0, {}};
    if (!line.joint.columns().empty()) line.redundancy = each.redundancy(data.layout());
    line.columns = line.joint.columns();
    for (std::size_t u = 0; u < data.systematic().size(); ++u) line.columns.push_back(joint_unknowns_ + u);
    if (!own_.has(i)) line.joint = {};
    lines_.push_back(std::move(line));
  }
}

FittedLines::FittedLines(const FittedLines& all, std::size_t every)
    : data_(all.data_), joint_unknowns_(all.joint_unknowns_), corrected_(all.corrected_.size()), threads_(all.threads_), watch_(all.watch_),
      own_(all.own_), as_measured_(all.as_measured_) {
  std::size_t place = 0;
  for (const FittedLine& line : all.lines_) {
    const bool is_taken = line.redundancy > 0.0 && place++ % every == 0;
    lines_.push_back({line.joint, line.columns, {}, is_taken ? line.redundancy : 0.0, 0.0, 1.0, {}});
  }
}

std::size_t FittedLines::used() const {
  return static_cast<std::size_t>(std::ranges::count_if(lines_, [](const FittedLine& line) { return line.redundancy > 0.0; }));
}

const LineData& FittedLines::data_at(std::size_t line, const std::vector<double>& theta) {
  const LineData& measured = data_->lines()[line];
  if (corrected_.empty()) return measured;
  const auto phi = std::span(theta).subspan(std::min(theta.size(), joint_unknowns_));
  corrected_[line] = corrected_line(measured, data_->systematic(), phi);
  return corrected_[line];
}

void FittedLines::for_all(const std::function<void(std::size_t, LineModel&)>& work) {
  std::atomic<std::size_t> begun = 0;
  const StopScope::Ask* const asked = StopScope::current();
  const auto work_on = [&](std::size_t i, LineModel& model) {
    if (!is_looked_at(i)) return;
    const StopScope scope(asked);  // threads of the arena have none
    stop_point();
    if (watch_) watch_(begun++, own_.size());
    work(i, model);
  };
  const auto model_of = [&](std::size_t worker) -> LineModel& {
    if (!models_[worker]) models_[worker] = std::make_unique<LineModel>(layout());
    return *models_[worker];
  };
  if (threads_ == 1) {
    models_.resize(std::max<std::size_t>(1, models_.size()));
    for (std::size_t i = own_.first; i < own_.last; ++i) work_on(i, model_of(0));
    exchange_costs();
    return;
  }
  oneapi::tbb::task_arena arena(threads_ == 0 ? oneapi::tbb::task_arena::automatic : static_cast<int>(threads_));
  models_.resize(std::max(models_.size(), static_cast<std::size_t>(arena.max_concurrency())));
  arena.execute([&] {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(own_.first, own_.last), [&](const auto& range) {
      LineModel& model = model_of(static_cast<std::size_t>(oneapi::tbb::this_task_arena::current_thread_index()));
      for (std::size_t i = range.begin(); i != range.end(); ++i) work_on(i, model);
    });
  });
  exchange_costs();
}

void FittedLines::exchange_costs() {
  if (data_->shares().size() == 1) return;
  std::vector<double> costs;
  for (const FittedLine& line : lines_) costs.insert(costs.end(), {line.cost, line.reduced.cost});
  data_->shares().complete(costs, lines_.size());
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].cost = costs[2 * i];
    lines_[i].reduced.cost = costs[2 * i + 1];
  }
}

bool FittedLines::look_at_some(std::size_t count) {
  const std::size_t every = used() / count;
  passed_over_.assign(every > 1 ? lines_.size() : 0, true);
  for (std::size_t i = 0, place = 0; i < passed_over_.size(); ++i) {
    if (lines_[i].redundancy > 0.0 && place++ % every == 0) passed_over_[i] = false;
  }
  return every > 1;
}

void FittedLines::begin(const std::vector<double>& theta) {
  for_all([&](std::size_t i, LineModel&) { lines_[i].state = first_state(layout(), data_at(i, theta), impedance(i, theta)); });
}

void FittedLines::linearise(const std::vector<double>& theta) {
  for_all([&](std::size_t i, LineModel& model) {
    lines_[i].reduced = linearised(data_at(i, theta), impedance(i, theta), model, lines_[i]);
  });
}

void FittedLines::linearise_frfs(const std::vector<double>& theta) {
  for_all([&](std::size_t i, LineModel& model) {
    lines_[i].reduced = linearised(data_at(i, theta), impedance(i, theta), model, lines_[i], false);
  });
}

void FittedLines::take_linearised_costs() {
  for (FittedLine& line : lines_) line.cost = line.reduced.cost;
}

void FittedLines::advance(const std::vector<double>& theta, const std::vector<double>& next, const Eigen::VectorXd& step) {
  for_all([&](std::size_t i, LineModel& model) {
    FittedLine& line = lines_[i];
    const ComplexMatrix z = line.joint.at(theta);
    model.prepare(z, line.state);
    model.advance(line.reduced.answer(pick(step, line.columns)) + line.reduced.own, line.joint.at(next) - z, line.state);
  });
}

void FittedLines::arrive(const std::vector<double>& theta) {
  constexpr double far = 2.0;
  for_all([&](std::size_t i, LineModel& model) {
    FittedLine& line = lines_[i];
    const LineData& data = data_at(i, theta);
    const ComplexMatrix z = line.joint.at(theta);
    line.cost = cost_on_constraint(layout(), data, z, line.state);
    if (!(line.cost <= far * std::max(line.reduced.cost, line.redundancy))) {
      ident::relax(data, z, model, line, Relaxation::beginning);
    }
  });
}

/// `settles`: whether the FRFs of the line were optimised.
void FittedLines::settle_by(const std::vector<double>& theta, const Settles& settles) {
  std::atomic<bool> relaxed = false;
  for_all([&](std::size_t i, LineModel& model) {
    if (settles(data_at(i, theta), impedance(i, theta), model, lines_[i])) relaxed = true;
  });
  if (data_->shares().any(relaxed) && relax_stuck(theta)) linearise(theta);
}

void FittedLines::settle(const std::vector<double>& theta, Relaxation until) {
  settle_by(theta, [until](const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line) {
    return ident::settle(data, z, model, line, until);
  });
}

void FittedLines::settle_measured(const std::vector<double>& theta) {
  settle_by(theta, [](const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line) {
    ident::settle_measured(data, z, model, line);
    return true;
  });
}

void FittedLines::take_gradients(const std::vector<double>& theta) {
  for_all([&](std::size_t i, LineModel& model) {
    FittedLine& line = lines_[i];
    const LineData& data = data_at(i, theta);
    const ComplexMatrix z = line.joint.at(theta);
    if (line.followed && has_plain_errors(data)) {
      take_gradient(data, z, layout(), line);
    } else {
      line.cost = line_cost(layout(), data, z, line.state.sub_jn, line.state.sub_jj);
      line.reduced = linearised(data, z, model, line);
    }
  });
}

void FittedLines::relax(const std::vector<double>& theta) {
  for_all([&](std::size_t i, LineModel& model) { ident::relax(data_at(i, theta), impedance(i, theta), model, lines_[i]); });
  relax_stuck(theta);
}

bool FittedLines::relax_stuck(const std::vector<double>& theta) {
  const auto far = std::ranges::count_if(lines_, &FittedLine::far_from_fitting);
  // A few lines far from fitting may be stuck. Where there are many it is the joint.
  if (far == 0 || 4 * static_cast<std::size_t>(far) > lines_.size()) return false;
  for_all([&](std::size_t i, LineModel& model) { relax_again(data_at(i, theta), impedance(i, theta), model, lines_[i]); });
  return true;
}

void FittedLines::answer(const std::vector<FittedLine>& before, const std::vector<double>& theta, const Eigen::VectorXd& step) {
  for_all([&](std::size_t i, LineModel&) {
    FittedLine& line = lines_[i];
    line.state = before[i].state;
    move(layout(), before[i].reduced.answer(pick(step, line.columns)), 1.0, line.state.sub_jn, line.state.sub_jj);
    put_on_constraint(layout(), line.joint.at(theta), line.state);
    line.followed = before[i].reduced.tells();
  });
}

Eigen::MatrixXd FittedLines::gradients_nearby(const std::vector<FittedLine>& before, const std::vector<double>& theta,
                                              const std::vector<Eigen::VectorXd>& offsets, std::vector<Eigen::MatrixXd> gradients) {
  const std::vector<std::vector<double>> nearby = ident::nearby(theta, offsets);
  gradients.resize(lines_.size());
  for_all([&](std::size_t i, LineModel& model) {
    const FittedLine& line = before[i];
    if (!line.reduced.tells() || gradients[i].size() > 0) return;
    const LineData& data = data_at(i, theta);
    gradients[i] = has_plain_errors(data)
                       ? ident::gradients_nearby(data, line.joint.at(theta), model, line, joints_nearby(line, nearby, offsets))
                       : relaxed_gradients(i, before[i], nearby, offsets, model);
  });
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(at(theta.size()), at(offsets.size()));
  for (std::size_t l = own_.first; l < own_.last; ++l) {
    for (Eigen::Index i = 0; i < gradients[l].rows(); ++i) {
      sums.row(at(lines_[l].columns[static_cast<std::size_t>(i)])) += lines_[l].weight * gradients[l].row(i);
    }
  }
  data_->shares().sum({sums.data(), static_cast<std::size_t>(sums.size())});
  return sums;
}

Eigen::MatrixXd FittedLines::gradients_nearby(std::size_t i, const std::vector<double>& theta,
                                              const std::vector<Eigen::VectorXd>& offsets, LineModel& model) const {
  const FittedLine& line = lines_[i];
  const LineData& data = data_->lines()[i];
  if (!corrected_.empty() || !has_plain_errors(data) || !line.reduced.tells()) return {};
  const std::vector<JointNearby> joints = joints_nearby(line, nearby(theta, offsets), offsets);
  return ident::gradients_nearby(data, line.joint.at(theta), model, line, joints, true);
}

/// Of a line whose errors are not plain.
Eigen::MatrixXd FittedLines::relaxed_gradients(std::size_t i, const FittedLine& before, const std::vector<std::vector<double>>& nearby,
                                               const std::vector<Eigen::VectorXd>& offsets, LineModel& model) {
  Eigen::MatrixXd out(at(before.columns.size()), at(nearby.size()));
  for (std::size_t k = 0; k < nearby.size(); ++k) {
    FittedLine line = before;
    const ComplexMatrix z = line.joint.at(nearby[k]);
    move(layout(), before.reduced.answer(pick(offsets[k], line.columns)), 1.0, line.state.sub_jn, line.state.sub_jj);
    const LineData& data = data_at(i, nearby[k]);
    ident::relax(data, z, model, line);
    out.col(at(k)) = linearised(data, z, model, line).gradient;
  }
  return out;
}

void FittedLines::follow(const std::vector<FittedLine>& before, const std::vector<double>& theta, const Eigen::VectorXd& step,
                         Relaxation until) {
  std::atomic<bool> relaxed = false;
  for_all([&](std::size_t i, LineModel& model) {
    FittedLine& line = lines_[i];
    const LineData& data = data_at(i, theta);
    const ReducedLine& reduced = before[i].reduced;
    const Eigen::VectorXd own_step = pick(step, line.columns);
    const ComplexMatrix z = line.joint.at(theta);
    const LineStep answer = reduced.answer(own_step);
    const auto cost_after = [&](const LineStep& change) {
      line.state = before[i].state;
      move(layout(), change, 1.0, line.state.sub_jn, line.state.sub_jj);
      return cost_on_constraint(layout(), data, z, line.state);
    };
    line.cost = cost_after(reduced.own + answer);
    const bool as_predicted = line.is_as_predicted(line.cost, reduced.cost_after(own_step));
    line.followed = as_predicted && reduced.tells();
    if (as_predicted) {
      if (until == Relaxation::end && !has_plain_errors(data)) ident::relax(data, z, model, line);
      return;
    }
    const double unmoved = cost_after(LineStep::Zero(answer.size()));
    if (cost_after(answer) > unmoved) line.state = before[i].state;
    ident::relax(data, z, model, line, until);
    relaxed = true;
  });
  if (data_->shares().any(relaxed)) relax_stuck(theta);
}

void FittedLines::weigh_robustly() {
  for (FittedLine& line : lines_) line.weight = line.redundancy > 0.0 ? robust_weight(line.cost / tolerance_, line.redundancy) : 0.0;
}

void FittedLines::weigh_alike() {
  for (FittedLine& line : lines_) line.weight = 1.0;
}

void FittedLines::choose_tolerance() {
  std::vector<double> ratios;
  for (const FittedLine& line : lines_) {
    if (line.redundancy > 0.0) ratios.push_back(line.cost / line.redundancy);
  }
  if (!ratios.empty()) tolerance_ = line_tolerance(std::move(ratios));
}

void FittedLines::take_variances_here(const std::vector<double>& theta) {
  if (!variances_by_law()) return;
  as_measured_ = false;
  for (std::size_t i = own_.first; i < own_.last; ++i) {
    if (lines_[i].redundancy > 0.0) data_->weigh_at(i, lines_[i].state, impedance(i, theta));
  }
}

void FittedLines::take_variances_as_measured() {
  if (!std::exchange(as_measured_, true)) data_->weigh_as_measured();
}

double FittedLines::loss() const {
  double sum = 0.0;
  for (const FittedLine& line : lines_) {
    if (line.redundancy > 0.0) sum += tolerance_ * robust_loss(line.cost / tolerance_, line.redundancy);
  }
  return sum;
}

double FittedLines::expected() const {
  double sum = 0.0;
  for (const FittedLine& line : lines_) sum += std::max(0.0, line.redundancy);
  return sum;
}

void FittedLines::add_to(Eigen::MatrixXd& information, Eigen::VectorXd& gradient) const {
  const Eigen::Index unknowns = gradient.size();
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(unknowns, unknowns + 1);
  for (std::size_t l = own_.first; l < own_.last; ++l) {
    const FittedLine& line = lines_[l];
    if (line.redundancy <= 0.0) continue;
    const auto& columns = line.columns;
    for (std::size_t i = 0; i < columns.size(); ++i) sums(at(columns[i]), unknowns) += line.weight * line.reduced.gradient[at(i)];
    add_information(l, line.weight, sums);
  }
  data_->shares().sum({sums.data(), static_cast<std::size_t>(sums.size())});
  information += sums.leftCols(unknowns);
  gradient += sums.col(unknowns);
}

void FittedLines::add_information(std::size_t line, double weight, Eigen::MatrixXd& information) const {
  if (lines_[line].redundancy <= 0.0) return;
  const auto& columns = lines_[line].columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      information(at(columns[i]), at(columns[j])) += weight * lines_[line].reduced.information(at(i), at(j));
    }
  }
}

bool FittedLines::fit(std::size_t unknowns, double deviations) const {
  double chi_square = 0.0, expected = -static_cast<double>(unknowns);
  std::size_t fitting = 0, outliers = 0;
  for (const FittedLine& line : lines_) {
    if (line.redundancy <= 0.0) continue;
    if (line.cost > outlying * line.redundancy) {
      ++outliers;
      continue;
    }
    ++fitting;
    chi_square += line.cost;
    expected += line.redundancy;
  }
  return 4 * outliers <= fitting && chi_square <= expected + deviations * std::sqrt(2.0 * std::max(0.0, expected));
}

double FittedLines::linearised_misfit() const {
  double misfit = 0.0, redundancy = 0.0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const FittedLine& line = lines_[i];
    if (!is_looked_at(i)) continue;
    misfit += line.redundancy * std::log1p(line.reduced.cost / line.redundancy);
    redundancy += line.redundancy;
  }
  return redundancy > 0.0 ? misfit / redundancy : 0.0;
}

std::size_t FittedLines::bytes() const {
  std::size_t sum = 0;
  for (const FittedLine& line : lines_) {
    const LineState& state = line.state;
    const ReducedLine& reduced = line.reduced;
    sum += sizeof(FittedLine) +
           sizeof(Complex) *
               static_cast<std::size_t>(state.sub_jn.size() + state.sub_jj.size() + state.asm_jn.size() + state.asm_jj.size()) +
           sizeof(double) * (static_cast<std::size_t>(reduced.information.size() + reduced.gradient.size() + reduced.own.size()) +
                              (reduced.back ? reduced.back->numbers() : 0));
  }
  return sum;
}

}  // namespace jointid::ident
