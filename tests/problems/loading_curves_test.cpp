#include "problems/thesis/loading_curves.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "asperities.hpp"
#include "frf/file/columns.hpp"
#include "friction/fit/fit.hpp"
#include "friction/law/laws.hpp"
#include "friction/path/loops.hpp"
#include "tests/require.hpp"
#include "tests/test_folder.hpp"

namespace jointid::problems {
namespace {

friction::Family family(const LoadingCurve& problem) {
  if (!problem.ring) return friction::family(problem.law);
  return friction::ring_family(problem.law, problem.ring->inner, problem.ring->outer);
}

friction::Fit fit(const friction::Curve& curve, const std::string& law, const friction::FitOptions& options = {}) {
  return friction::fit(std::span(&curve, 1), friction::family(law), options);
}

TEST(LoadingCurves, LimitsAreThoseOfTheTables) {
  EXPECT_EQ(loading_curves().size(), 48u);
  for (const LoadingCurve& problem : loading_curves()) {
    const double limit = friction::make_element(problem.law, problem.values)->limit();
    EXPECT_NEAR(limit / problem.printed_limit, 1.0, 0.04) << problem.name;
  }
}

TEST(LoadingCurves, WithoutNoiseTheRowsAreFoundAgain) {
  for (const LoadingCurve& problem : loading_curves()) {
    const friction::Curve curve = make_curve(problem, 40, 0.0, 1);
    const friction::Fit found = friction::fit(std::span(&curve, 1), family(problem));
    EXPECT_EQ(found.status, Status::ok) << problem.name;
    for (std::size_t i = 0; i < problem.values.size(); ++i) {
      EXPECT_NEAR(found.curves[0].parameters[i].value / problem.values[i], 1.0, 1e-3) << problem.name << " parameter " << i;
    }
  }
}

TEST(LoadingCurves, AreWrittenWithTheirTruth) {
  const TestFolder folder;
  const LoadingCurve* problem = find_loading_curve("table2.4-3");
  ASSERT_NE(problem, nullptr);
  EXPECT_EQ(find_loading_curve("table2.4-30"), nullptr);
  const auto path = write(*problem, folder, {.seed = 5});
  const frf::Columns read = frf::read_columns(path);
  const friction::Curve curve = make_curve(*problem, 100, 0.01, 5);
  EXPECT_EQ(read.columns[0].unit, "rad");
  EXPECT_EQ(read.columns[0].values, curve.u);
  EXPECT_EQ(read.columns[1].values, curve.value);
  std::ifstream in(folder / "truth.json");
  const auto truth = nlohmann::json::parse(in);
  EXPECT_EQ(truth["parameters"][1]["value"], 4.267);
  EXPECT_EQ(truth["law"], "ren");
  EXPECT_EQ(fit_options(*problem), "--law ren --ring 0.0255,0.038");
}

TEST(AsperityCurves, RankTheLawsAsTheThesis) {
  for (const double separation : {0.0, 1.0}) {
    const friction::Curve curve = Asperities(separation).curve(0.97, 40, 0.002);
    std::vector<double> misfit;
    for (const char* law : {"ren", "shoukry", "burdekin", "bilinear"}) misfit.push_back(fit(curve, law).objective);
    for (std::size_t i = 1; i < misfit.size(); ++i)
      EXPECT_LT(misfit[i - 1], 0.8 * misfit[i]) << "separation " << separation << " law " << i;
    std::printf("separation %g: ren %.2e, shoukry %.2e, burdekin %.2e, bilinear %.2e\n", separation, misfit[0], misfit[1],
                misfit[2], misfit[3]);
  }
}

TEST(AsperityCurves, APresetLimitSpoilsShoukryAndNotRen) {
  const Asperities contact(0.0);
  const friction::Curve curve = contact.curve(0.85, 40, 0.002);
  const friction::FitOptions preset{.limit = contact.limit()};
  const double ren = fit(curve, "ren").objective, ren_preset = fit(curve, "ren", preset).objective;
  const double shoukry = fit(curve, "shoukry").objective, shoukry_preset = fit(curve, "shoukry", preset).objective;
  EXPECT_LT(ren_preset, 2.0 * ren);
  EXPECT_GT(shoukry_preset, 7.0 * shoukry);
  EXPECT_GT(shoukry_preset, 7.0 * ren_preset);
  std::printf("ren %.2e, preset %.2e; shoukry %.2e, preset %.2e\n", ren, ren_preset, shoukry, shoukry_preset);
}

/// Reciprocating friction measured by others; see the README beside the file.
class MeasuredLoops : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(file_)) JOINTID_SKIP(file_ << " is missing: no external data");
    const frf::Columns columns = frf::read_columns(file_);
    friction::Record record{columns.column("Position").values, columns.column("Friction").values};
    for (double& u : record.displacement) u *= 1e-3;
    record = friction::with_force_times(std::move(record), -1e-6);
    for (const friction::Loop& loop : friction::loops(record, 1e-4))
      curves_.push_back(friction::loop_curve("loop", friction::centred(loop)));
  }

  friction::Fit together(const std::string& law, std::vector<std::string> shared) const {
    friction::FitOptions options{.weighting = friction::Weighting::travel};
    options.shared = std::move(shared);
    return friction::fit(curves_, friction::family(law), options);
  }

  std::filesystem::path file_ = std::filesystem::path(JOINTID_EXTERNAL_DATA) / "friction-loops/test_data_2.txt";
  std::vector<friction::Curve> curves_;
};

TEST_F(MeasuredLoops, BilinearStiffnessLimitAndEnergy) {
  ASSERT_EQ(curves_.size(), 49u);
  std::vector<double> stiffness;
  for (const friction::Curve& curve : curves_) {
    const friction::Fit found = fit(curve, "bilinear", {.weighting = friction::Weighting::travel});
    ASSERT_EQ(found.status, Status::ok);
    const friction::CurveFit& one = found.curves[0];
    stiffness.push_back(one.stiffness.value);
    EXPECT_GE(one.limit.value, 2.28);
    EXPECT_LE(one.limit.value, 2.42);
    const friction::Loop loop{{curve.u, curve.value}, curve.turn};
    EXPECT_NEAR(one.element->cycle_energy(loop.amplitude()) / loop.energy(), 1.0, 0.035);
  }
  std::ranges::nth_element(stiffness, stiffness.begin() + 24);
  EXPECT_GE(stiffness[24], 40e3);
  EXPECT_LE(stiffness[24], 41e3);
}

TEST_F(MeasuredLoops, ARicherElementBeatsTheBilinearOneByAic) {
  const friction::Fit bilinear = together("bilinear", {"a", "k"}), ren = together("ren", {"a", "b", "k"});
  EXPECT_LT(ren.aic, bilinear.aic - 1000.0);
  EXPECT_GE(bilinear.curves[0].stiffness.value, 40e3);
  EXPECT_LE(bilinear.curves[0].stiffness.value, 41e3);
  EXPECT_THAT(bilinear.findings, testing::Contains(testing::HasSubstr("residuals of neighbouring samples are correlated")));
}

}  // namespace
}  // namespace jointid::problems
