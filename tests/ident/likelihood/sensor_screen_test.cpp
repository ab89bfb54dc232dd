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
#include "problems/case/many_joints_problem.hpp"
#include "tests/ident/likelihood_case.hpp"

namespace jointid::ident {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr std::size_t many_lines = 1100;

/// Two beams of one element and a joint, many lines.
problems::Problem beams() {
  problems::ManyJoints chain = problems::chain_of_beams({.beam = {.elements = 1}, .joints = 1, .spacing = 1});
  const double first = chain.frequency_hz.front(), last = chain.frequency_hz.back();
  chain.frequency_hz.clear();
  for (std::size_t i = 0; i < many_lines; ++i)
    chain.frequency_hz.push_back(first + (last - first) * static_cast<double>(i) / static_cast<double>(many_lines - 1));
  problems::Problem problem = problems::many_joints_problem(chain, {"two beams", ""}, false);
  std::get<frf::NoiseModel>(problem.noise).level = 0.01;
  return problem;
}

Scene scene_of(const problems::Problem& problem) {
  Scene scene = problems::scene(problem);
  const frf::NoiseModel& noise = std::get<frf::NoiseModel>(problem.noise);
  scene.noise = NoiseSection{.model = frf::name(noise.kind), .level = noise.level, .frf_model = noise};
  scene.identify = {};
  scene.identify.method = Method::likelihood;
  return scene;
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

  Fitted(const problems::Problem& problem, const problems::Measurement& data) : plan(problems::plan(scene_of(problem), data)) {
    Control control = one_thread();
    control.detail = Detail::estimates;
    const Solution solution = ident::solve(*plan, control);
    std::vector<double> theta;
    for (std::size_t c = 0; c < solution.unknowns.size(); ++c) theta.push_back(solution.unknowns[c].value / plan->unscale(c));
    there.emplace(make_estimator(*plan, control).at(theta));
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
  const problems::Problem problem = beams();
  const Fitted fitted(problem, problems::polluted(problem, 1, 0));
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
  const problems::Problem problem = beams();
  std::size_t without = 0, with = 0;
  for (const double gain : {1.0, 1.0003, 1.001, 1.003, 1.03}) {
    problems::Measurement data = problems::polluted(problem, 2, 0);
    mistake(data.assembly, 0, gain);
    const Fitted fitted(problem, data);
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
  const Fitted fitted(a1.problem, problems::polluted(a1.problem, 1, 0));
  EXPECT_EQ(SensorScreen::of(*fitted.plan, *fitted.there, fitted.there->fit, 1.0, one_thread()), nullptr);
}

}  // namespace
}  // namespace jointid::ident
