#include "ident/likelihood/findings/joint_errors.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "frf/set/frf_set.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/bound_of.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

constexpr double step = 1e-3;  ///< standard deviations to either side

/// Part FRFs of a line as estimated, when the joint is some way along each of its unknowns, over the whole way.
class Answer {
 public:
  Answer(const Plan& plan, const LinearisedLikelihood& estimator, const std::vector<double>& theta)
      : observations_(*likelihood_plan(plan)->observations), estimator_(estimator), theta_(theta) {}

  /// d/dθ of all pairs, [pair, columns of the line]; zero of those that are not there.
  Eigen::MatrixXcd of(std::size_t line, const Eigen::VectorXd& deviation) const {
    const FittedLine& fitted = estimator_.line_at(line);
    const std::size_t size = observations_.layout().coordinates.size();
    Eigen::MatrixXcd out = Eigen::MatrixXcd::Zero(at(frf::pair_count(size)), at(fitted.columns.size()));
    if (!fitted.reduced.back || !fitted.reduced.tells()) return out;
    for (std::size_t k = 0; k < fitted.columns.size(); ++k) {
      const double way = step * deviation[at(fitted.columns[k])];
      if (!(way > 0.0)) continue;
      const Symmetric<Complex> above = moved(line, k, way), below = moved(line, k, -way);
      for (std::size_t r = 0; r < size; ++r) {
        for (std::size_t s = 0; s <= r; ++s) {
          const Complex slope = (above.at(r, s) - below.at(r, s)) / (2.0 * way);
          if (std::isfinite(slope.real()) && std::isfinite(slope.imag())) out(at(frf::pair_index(r, s)), at(k)) = slope;
        }
      }
    }
    return out;
  }

 private:
  Symmetric<Complex> moved(std::size_t line, std::size_t k, double way) const {
    const FittedLine& fitted = estimator_.line_at(line);
    std::vector<double> theta = theta_;
    theta[fitted.columns[k]] += way;
    const ComplexMatrix z = estimator_.impedance_of(line, theta);
    LineState state = fitted.state;
    const LineLayout& layout = observations_.layout();
    move(layout, fitted.reduced.answer(way * Eigen::VectorXd::Unit(at(fitted.columns.size()), at(k))), 1.0, state.sub_jn,
         state.sub_jj);
    put_on_constraint(layout, z, state);
    return observations_.estimated(line, state, z).substructures;
  }

  const Observations& observations_;
  const LinearisedLikelihood& estimator_;
  const std::vector<double>& theta_;
};

}  // namespace

void require_joint_errors(const Plan& plan) {
  const auto fail = [&](const char* place, const char* problem, const char* remedy) {
    throw InputError(
        {.kind = ErrorKind::usage, .file = plan.scene.file.string(), .place = place, .problem = problem, .remedy = remedy});
  };
  const LikelihoodPlan* const own = likelihood_plan(plan);
  if (!own) {
    fail("[identify] method", "only method \"likelihood\" gives the errors that a joint shares with the parts",
         "set method = \"likelihood\"");
  }
  if (plan.admissible) fail("[joint]", "what bounds and ties do to the errors is not carried into a coupling", "leave them out");
  if (!own->observations->systematic().empty()) {
    fail("[data]", "gains, masses and errors of models as unknowns are not carried into a coupling",
         "correct the files for what was found");
  }
  if (!plan.scene.couple_first.pairs.empty()) {
    fail("[joint] couple_first", "parts that were coupled before are other FRFs than those of the files", "leave it out");
  }
  if (plan.scene.data.regenerate.any()) {
    fail("[data] regenerate", "FRFs of modal models are other ones than those of the files", "leave it out");
  }
  for (std::size_t c = 0; c < plan.columns->size(); ++c) {
    if (plan.columns->band_of(c)) fail("[joint]", "a joint with bands has no one matrix", "identify without bands");
  }
}

JointErrors joint_errors(const Plan& plan, const std::vector<double>& values, const Control& control) {
  require_joint_errors(plan);
  std::vector<double> theta;
  Eigen::VectorXd unit(at(values.size()));
  for (std::size_t c = 0; c < values.size(); ++c) {
    unit[at(c)] = plan.unscale(c);
    theta.push_back(values[c] / unit[at(c)]);
  }
  LinearisedLikelihood there = make_estimator(plan, control).at(theta);
  const Eigen::MatrixXd scaled = minimise::covariance_of(there.fit.information);
  const Observations& observations = *likelihood_plan(plan)->observations;
  JointErrors out;
  out.coordinates = observations.layout().coordinates;
  const Eigen::VectorXd deviation = scaled.diagonal().cwiseSqrt();
  const Answer answer(plan, there, theta);
  for (std::size_t line = 0; line < plan.lines.size(); ++line) {
    stop_if(control.interrupted);
    const std::vector<std::size_t>& columns = there.line_at(line).columns;
    const Eigen::MatrixXd of_line = scaled(columns, Eigen::all) * unit.asDiagonal();
    const Eigen::MatrixXcd common = answer.of(line, deviation) * of_line.cast<Complex>();
    out.frequency_hz.push_back(plan.lines[line].frequency_hz);
    out.common.emplace_back();
    for (Eigen::Index pair = 0; pair < common.rows(); ++pair) {
      for (Eigen::Index m = 0; m < common.cols(); ++m) out.common.back().push_back(common(pair, m));
    }
  }
  out.covariance = unit.asDiagonal() * minimise::covariance_of(there.godambe_information()) * unit.asDiagonal();
  return out;
}

}  // namespace jointid::ident
