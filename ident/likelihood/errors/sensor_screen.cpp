#include "ident/likelihood/errors/sensor_screen.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/model/corrected_line.hpp"
#include "ident/likelihood/model/line_gradient.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t screened_lines = 128, fewest_to_screen = 4 * screened_lines;
constexpr double information_safety = 2.0;  ///< by so much that of the spread lines may be off
constexpr double least_independent = 1e-6;  ///< of the information on a gain: what all else has to leave of it
constexpr double promising_score = 4.0;     ///< on the spread lines

/// Σ over both parts of weight² · a · b.
double squared_weight_times(Complex weight, Complex a, Complex b) {
  return weight.real() * weight.real() * a.real() * b.real() + weight.imag() * weight.imag() * a.imag() * b.imag();
}

/// Adds −weight² · ∂value/∂gain · (value − predicted) of the elements of a line.
class GainGradientSum {
 public:
  GainGradientSum(const SystematicTerms& terms, Eigen::VectorXd& out) : terms_(terms), out_(out) {}

  template <class Predicted>
  void add(const std::vector<Element>& elements, const Channel& channel, const Predicted& predicted) {
    for (std::size_t i = 0; i < elements.size(); ++i, ++element_) {
      const Complex weight = channel.weight[i];
      if (weight == Complex(0.0)) continue;
      const Complex residual = channel.value[i] - predicted(elements[i]);
      for (std::size_t t = terms_.first[element_]; t < terms_.first[element_ + 1]; ++t)
        out_[at(terms_.terms[t].unknown)] -= squared_weight_times(weight, terms_.terms[t].derivative(residual), residual);
    }
  }

 private:
  const SystematicTerms& terms_;
  Eigen::VectorXd& out_;
  std::size_t element_ = 0;
};

}  // namespace

std::unique_ptr<SensorScreen> SensorScreen::of(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit,
                                               double inflation, const Control& control) {
  const Observations& observations = *likelihood_plan(plan)->observations;
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < fit.line_weight.size(); ++i) {
    if (fit.line_weight[i] > 0.0) used.push_back(i);
  }
  if (used.size() < fewest_to_screen || !observations.systematic().empty()) return nullptr;
  if (!observations.has_independent_errors()) return nullptr;
  ErrorTrials sensors;
  sensors.add_sensors(plan);
  if (sensors.sensors.empty() || sensors.sensors.size() > ErrorTrials::most) return nullptr;
  std::unique_ptr<SensorScreen> out(new SensorScreen(plan, estimator, fit, inflation, std::move(sensors)));
  out->look(used, control);
  return out;
}

SensorScreen::SensorScreen(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit, double inflation,
                           ErrorTrials sensors)
    : plan_(plan),
      observations_(*likelihood_plan(plan)->observations),
      estimator_(estimator),
      fit_(fit),
      inflation_(inflation),
      sensors_(std::move(sensors)),
      lines_(sensors_.plan, *plan.substructures, *plan.assembly, observations_.layout().coordinates),
      unknowns_(sensors_.plan.unknowns()),
      of_lines_(fit.line_weight.size()) {}

/// Of lines alone.
Scores SensorScreen::scores_of(const std::vector<std::size_t>& lines, const Control& control) const {
  LikelihoodFit some = fit_;
  some.line_weight.assign(fit_.line_weight.size(), 0.0);
  for (const std::size_t line : lines) some.line_weight[line] = fit_.line_weight[line];
  Scores out = sum_over_lines(plan_, estimator_, some, lines_, control, Scores::none(fit_.theta.size() + sensors_.sensors.size()));
  observations_.shares().sum({out.information.data(), static_cast<std::size_t>(out.information.size())});
  observations_.shares().sum({out.gradient.data(), static_cast<std::size_t>(out.gradient.size())});
  return out;
}

void SensorScreen::look(const std::vector<std::size_t>& used, const Control& control) {
  std::vector<std::size_t> halves[2];
  for (std::size_t k = 0; k < screened_lines; ++k) halves[k % 2].push_back(used[(2 * k + 1) * used.size() / (2 * screened_lines)]);
  in_all_ = static_cast<double>(used.size()) / static_cast<double>(screened_lines);
  const std::size_t known = fit_.theta.size();
  const Scores one = scores_of(halves[0], control), other = scores_of(halves[1], control);
  spread_ = one;
  spread_ += other;
  own_ = left_of(spread_, known).information.diagonal();
  const Eigen::VectorXd first = left_of(one, known).information.diagonal(), second = left_of(other, known).information.diagonal();
  const Eigen::VectorXd all = spread_.information.diagonal().tail(own_.size());
  agree_ = (own_.array() >= least_independent * all.array()).all() && (first.array() <= information_safety * second.array()).all() &&
           (second.array() <= information_safety * first.array()).all();
}

/// A sensor that no line has tells nothing: its gradient and its information are 0.
bool SensorScreen::is_promising() const {
  const Eigen::VectorXd gradient = left_of(spread_, fit_.theta.size()).gradient.cwiseAbs();
  return agree_ && (gradient.array() <= promising_score * inflation_ * own_.array().sqrt()).all();
}

void SensorScreen::take(std::size_t i, LineModel& model) {
  const LineLayout& layout = model.layout();
  Room& room = rooms_.local();
  room.data = observations_.lines()[i];
  observations_.write_systematic_frfs(i, lines_, *room.frfs);
  room.data.systematic = room.frfs;
  write_terms(room.data, unknowns_, room.terms);
  const ComplexMatrix z = estimator_.impedance_of(i, fit_.theta);
  LineState state = estimator_.state_of(i);
  const LineStep own = model.own_step(gradient_of(layout, room.data, estimator_.line_at(i).joint, z, state).own);
  move(layout, own, 1.0, state.sub_jn, state.sub_jj);
  put_on_constraint(layout, z, state);
  const ComplexMatrix za = z * state.asm_jn;
  const auto of = [](const ComplexMatrix& matrix) { return [&matrix](const Element& e) { return matrix(at(e.row), at(e.column)); }; };
  of_lines_[i] = Eigen::VectorXd::Zero(at(unknowns_.size()));
  GainGradientSum sum(room.terms, of_lines_[i]);
  sum.add(layout.sub_jn, room.data.sub_jn, of(state.sub_jn));
  sum.add(layout.sub_jj, room.data.sub_jj, of(state.sub_jj));
  sum.add(layout.asm_jn, room.data.asm_jn, of(state.asm_jn));
  sum.add(layout.asm_jj, room.data.asm_jj, of(state.asm_jj));
  sum.add(layout.drop_nn, room.data.drop_nn, [&](const Element& e) { return predicted_difference(state, za, e); });
}

Eigen::VectorXd SensorScreen::gradient() const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(own_.size());
  for (std::size_t i = 0; i < of_lines_.size(); ++i) {
    if (of_lines_[i].size() > 0) out += fit_.line_weight[i] * of_lines_[i];
  }
  observations_.shares().sum({out.data(), static_cast<std::size_t>(out.size())});
  return out;
}

/// What the unknowns of the fit are still off by moves a gain by little, and is taken as it acts on the spread lines, twice.
bool SensorScreen::excludes_all(const Eigen::VectorXd& known) const {
  const Eigen::Index r = known.size(), sensors = own_.size();
  const Eigen::VectorXd step = dense::solve_symmetric(spread_.information.topLeftCorner(r, r), known);
  const Eigen::VectorXd moved = spread_.information.bottomLeftCorner(sensors, r) * step;
  const Eigen::VectorXd most = gradient().cwiseAbs() + 2.0 * moved.cwiseAbs();
  const Eigen::VectorXd least = own_ * (in_all_ / information_safety);
  return agree_ && (most.array() <= significant * inflation_ * least.array().sqrt()).all();
}

}  // namespace jointid::ident
