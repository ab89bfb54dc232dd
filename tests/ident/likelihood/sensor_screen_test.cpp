// Gains of sensors of long scenes: the screen's gradients against those of a pass that has the sensors as unknowns, and its verdicts
// against the scores of such a pass.
#include <gmock/gmock.h>

#include <cmath>

#include "base/eigen.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/errors/gain_scores.hpp"
#include "ident/likelihood/errors/sensor_screen.hpp"
#include "ident/likelihood/findings/bound_of.hpp"
#include "ident/likelihood/model/corrected_line.hpp"
#include "tests/ident/likelihood_case.hpp"

namespace jointid::ident {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Each line 20 times, at frequencies up to the next: receptances that fit a joint of K and D as they do on the first.
frf::FrfSet repeated(const frf::FrfSet& set) {
  constexpr std::size_t times = 20;
  frf::FrfSet out = set;
  out.header.frequency_hz.clear();
  out.values.clear();
  const std::vector<double>& f = set.header.frequency_hz;
  const std::size_t entries = set.header.entries();
  for (std::size_t line = 0; line < f.size(); ++line) {
    const double step = line + 1 < f.size() ? f[line + 1] - f[line] : f[line] - f[line - 1];
    for (std::size_t k = 0; k < times; ++k) {
      out.header.frequency_hz.push_back(f[line] + step * static_cast<double>(k) / static_cast<double>(times));
      const auto first = set.values.begin() + static_cast<std::ptrdiff_t>(line * entries);
      out.values.insert(out.values.end(), first, first + static_cast<std::ptrdiff_t>(entries));
    }
  }
  return out;
}

/// A1 with 600 lines and more.
LikelihoodCase many_lines() {
  LikelihoodCase out("A1", 0.01);
  for (frf::FrfSet& each : out.problem.substructures) each = repeated(each);
  out.problem.assembly = repeated(out.problem.assembly);
  return out;
}

Control one_thread() {
  Control control;
  control.threads = 1;
  return control;
}

/// The FRFs of one response of the assembly times a factor.
void mistake(frf::FrfSet& set, std::size_t response, double factor) {
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t c = 0; c < set.header.reference.size(); ++c) set.values[set.index(line, response, c)] *= factor;
  }
}

struct Fitted {
  std::unique_ptr<Plan> plan;
  std::optional<LinearisedLikelihood> there;

  Fitted(const Scene& scene, const problems::Measurement& data) : plan(problems::plan(scene, data)) {
    Control control = one_thread();
    control.detail = Detail::estimates;
    const Solution solution = ident::solve(*plan, control);
    std::vector<double> theta;
    for (std::size_t c = 0; c < solution.unknowns.size(); ++c) theta.push_back(solution.unknowns[c].value / plan->unscale(c));
    there.emplace(make_estimator(*plan, control).refine(theta, [](std::size_t) {}));
  }

  /// The model of the line has its factors.
  void linearise(std::size_t line, LineModel& model) const {
    const LineData& data = likelihood_plan(*plan)->observations->lines()[line];
    const FittedLine& of = there->line_at(line);
    model.linearise(data, of.joint, there->impedance_of(line, there->fit.theta), of.state, true);
    ASSERT_TRUE(model.reduce(0.0, false));
  }
};

/// All sensors as unknowns of a pass.
Scores full_scores(const Fitted& fitted, std::size_t sensors) {
  ErrorTrials trials;
  trials.add_sensors(*fitted.plan);
  const SystematicLines lines(trials.plan, *fitted.plan->substructures, *fitted.plan->assembly,
                              likelihood_plan(*fitted.plan)->observations->layout().coordinates);
  return sum_over_lines(*fitted.plan, *fitted.there, fitted.there->fit, lines, one_thread(),
                        Scores::none(fitted.there->fit.theta.size() + sensors));
}

TEST(SensorScreen, ItsGradientsAreThoseOfUnknowns) {
  const LikelihoodCase a1 = many_lines();
  const Fitted fitted(a1.scene, problems::polluted(a1.problem, 1, 0));
  const auto screen = SensorScreen::of(*fitted.plan, *fitted.there, fitted.there->fit, 1.0, one_thread());
  ASSERT_NE(screen, nullptr);
  LineModel model(likelihood_plan(*fitted.plan)->observations->layout());
  for (std::size_t i = 0; i < fitted.plan->lines.size(); ++i) {
    if (!(fitted.there->fit.line_weight[i] > 0.0)) continue;
    fitted.linearise(i, model);
    screen->take(i, model);
  }
  const Eigen::VectorXd found = screen->gradient();
  const Scores full = full_scores(fitted, static_cast<std::size_t>(found.size()));
  const Eigen::VectorXd expected = full.gradient.tail(found.size());
  const Eigen::VectorXd deviation = full.information.diagonal().tail(found.size()).cwiseSqrt();
  EXPECT_LT((found - expected).cwiseQuotient(deviation).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_GT(expected.cwiseQuotient(deviation).cwiseAbs().maxCoeff(), 0.1);
}

/// From none to plain ones: what is found is what a pass with all sensors finds.
TEST(SensorScreen, FindsWhatAPassWithAllSensorsFinds) {
  const LikelihoodCase a1 = many_lines();
  std::size_t without = 0, with = 0;
  for (const double gain : {1.0, 1.001, 1.03}) {
    problems::Measurement data = problems::polluted(a1.problem, 2, 0);
    mistake(data.assembly, 0, gain);
    const Fitted fitted(a1.scene, data);
    LinearisedLikelihood::NearbyGradients none;
    const auto tried = try_errors(*fitted.plan, *fitted.there, fitted.there->fit, 1.0, one_thread(), none);
    ASSERT_TRUE(tried);
    const std::size_t known = fitted.there->fit.theta.size();
    const std::vector<GainSuspect> found = suspect_gains(*tried, known);
    (tried->trials.sensors.empty() ? without : with) += 1;
    TriedErrors full;
    full.trials.add_sensors(*fitted.plan);
    full.scores = full_scores(fitted, full.trials.sensors.size());
    const std::vector<GainSuspect> expected = suspect_gains(full, known);
    ASSERT_THAT(found, SizeIs(expected.size())) << gain;
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].sensor, expected[k].sensor) << gain;
      EXPECT_NEAR(found[k].score, expected[k].score, 1e-6 * std::abs(expected[k].score)) << gain;
    }
    if (gain == 1.0) { EXPECT_THAT(found, IsEmpty()); }
    if (gain == 1.03) { EXPECT_THAT(found, ::testing::Not(IsEmpty())); }
  }
  EXPECT_GT(without, 0U);
  EXPECT_GT(with, 0U);
}

TEST(SensorScreen, IsForManyLinesAlone) {
  const LikelihoodCase a1("A1", 0.01);
  const Fitted fitted(a1.scene, problems::polluted(a1.problem, 1, 0));
  EXPECT_EQ(SensorScreen::of(*fitted.plan, *fitted.there, fitted.there->fit, 1.0, one_thread()), nullptr);
}

}  // namespace
}  // namespace jointid::ident
