
#include "report/couple/couple_plots.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "frf/hdf5/hdf5_file.hpp"
#include "problems/case/coupling_problem.hpp"
#include "report/couple/couple_page.hpp"
#include "report/equivalent/equivalent_page.hpp"
#include "report/equivalent/equivalent_text.hpp"
#include "report/page/contents.hpp"
#include "report/page/limits.hpp"
#include "tasks/couple/couple_frfs.hpp"
#include "tests/test_folder.hpp"

namespace jointid::cli {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const report::CurvePlot& curves(const report::PlotGroup& group, std::size_t choice, std::size_t plot) {
  return std::get<report::CurvePlot>(group.choices.at(choice).plots.at(plot));
}

TEST(CouplePlots, TheIntervalOfAMagnitudeIsThatOfTheErrorAlongIt) {
  const frf::Dof dof = frf::Dof::parse("1:+Y");
  // Real: the imaginary error turns H, and does not lengthen it. 3 + 4i: (9·0.25 + 16·1)/25² = (0.1708…)².
  const tasks::PredictedFrf frf{dof, dof, {2.0, {3.0, 4.0}, 0.0}, {{0.01, 5.0}, {0.25, 1.0}, {0.01, 0.01}}, {}};
  const report::PlotGroup group = report::predicted_plots({10.0, 20.0, 30.0}, {frf}, 100);
  const auto& series = curves(group, 0, 0).series;
  ASSERT_EQ(series.size(), 3u);
  EXPECT_NEAR(series[1].y[0], 2.0 * std::exp(1.959964 * 0.05), 1e-6);
  EXPECT_NEAR(series[2].y[0], 2.0 / std::exp(1.959964 * 0.05), 1e-6);
  EXPECT_NEAR(std::log(series[1].y[1] / 5.0) / 1.959964, std::sqrt(18.25) / 25.0, 1e-6);
  EXPECT_TRUE(std::isnan(series[0].y[2]) && std::isnan(series[1].y[2]) && std::isnan(series[2].y[2]));
}

/// A receptance of 2 m/N with a standard error of 0.1 is an accelerance of −2ω²·1000 mm/s²/N with one of 100 ω².
TEST(CouplePlots, OfTheQuantityAndTheUnitsThatAreAskedFor) {
  const frf::Dof dof = frf::Dof::parse("1:+Y"), turn = frf::Dof::parse("2:+RZ");
  const tasks::PredictedFrf point{dof, dof, {2.0}, {{0.01, 0.01}}, {3.0}, {4.0}}, moment{dof, turn, {2.0}, {}, {}};
  const report::Display display{.millimetres = true, .quantity = frf::Quantity::accelerance};
  const report::PlotGroup group = report::predicted_plots({10.0}, {point, moment}, 100, display);
  const double square = std::pow(2.0 * std::numbers::pi * 10.0, 2);
  const auto& magnitude = curves(group, 0, 0);
  EXPECT_EQ(magnitude.y.label, "accelerance (mm/s²/N)");
  const std::array<double, 3> right = {4000.0 * square, 3000.0 * square, 2000.0 * square};  // measured, all, predicted
  for (std::size_t i = 0; i < right.size(); ++i) EXPECT_NEAR(magnitude.series[i].y[0], right[i], 1e-10 * right[i]);
  EXPECT_NEAR(magnitude.series[3].y[0], right[2] * std::exp(1.959964 * 0.05), 1e-6 * right[2]);
  EXPECT_EQ(curves(group, 1, 0).y.label, "accelerance (mm/s²/(N·mm))");
  EXPECT_NEAR(curves(group, 1, 0).series[0].y[0], 2.0 * square, 1e-10 * square);
}

/// 5e-6 m, 4e6 ± 2e3 N/m.
TEST(EquivalentText, OfTheUnitsThatAreAskedFor) {
  const std::vector<tasks::LevelJoint> levels = {{"a.h5", 5e-6, 31, {4e6, 1e5, 2e3, 0.01, true}}};
  const ident::EquivalentScene scene;
  EXPECT_THAT(report::equivalent_csv(levels), HasSubstr("5e-06,4000000,100000,0.01"));
  const report::Display display{.millimetres = true};
  EXPECT_THAT(
      report::equivalent_csv(levels, display),
      testing::AllOf(HasSubstr("displacement [mm],stiffness [N/mm],damping [N/mm],misfit"), HasSubstr("0.005,4000,100,0.01")));
  EXPECT_THAT(report::equivalent_text(scene, levels, display),
              testing::AllOf(HasSubstr("k N/mm"), HasSubstr("4000"), Not(HasSubstr("N/m "))));
  EXPECT_THAT(report::equivalent_page(scene, levels, display),
              testing::AllOf(HasSubstr("k (N/mm)"), HasSubstr("displacement (mm)")));
}

class CoupleReport : public testing::Test {
 protected:
  void SetUp() override {
    scene_ = ident::read_couple_scene(
        problems::write(problems::make_coupling("coupling-C"), folder_, {.format = "h5", .seed = 1, .clean = false}));
  }

  std::string page_of(const tasks::CoupleResult& result) const {
    return report::couple_page(scene_, result, tasks::read_predicted(result, report::most_frfs));
  }

  tasks::CoupleResult couple(bool bounds) const { return tasks::couple(scene_, folder_ / "out.h5", bounds); }

  TestFolder folder_;
  ident::CoupleScene scene_;
};

TEST_F(CoupleReport, ReadsBackWhatWasWritten) {
  scene_.options.uncertainty = true;
  scene_.options.noise = frf::NoiseModel{.level = 0.05};
  const tasks::CoupleResult result = couple(true);
  const std::vector<tasks::PredictedFrf> frfs = tasks::read_predicted(result, 8);
  const frf::FrfSet set = frf::load(*frf::open_hdf5(result.result.path)), all = frf::load(*frf::open_hdf5(result.with_all->path));
  ASSERT_EQ(frfs.size(), 8u);
  for (std::size_t e = 0; e < frfs.size(); ++e) {
    const std::size_t r = frf::find_coordinate(set.header.response, frfs[e].response),
                      c = frf::find_coordinate(set.header.reference, frfs[e].reference);
    EXPECT_EQ(r == c, e < set.header.response.size()) << "point FRFs come first";
    for (const std::size_t line : {std::size_t{0}, std::size_t{64}, set.header.lines() - 1}) {
      EXPECT_EQ(frfs[e].value[line], set.values[set.index(line, r, c)]);
      EXPECT_EQ(frfs[e].variance[line], set.variance[set.index(line, r, c)]);
      EXPECT_EQ(frfs[e].with_all[line], all.values[all.index(line, r, c)]);
    }
  }
  EXPECT_EQ(tasks::read_predicted(result, 1000).size(), set.header.entries());
}

TEST_F(CoupleReport, SaysWhatIsLeftOutAndWhy) {
  const std::string page = page_of(couple(true));
  EXPECT_THAT(page, HasSubstr("3 of 5"));
  EXPECT_THAT(page, HasSubstr("2 of 5 conditions are left out: the alphas have a gap"));
  EXPECT_THAT(page, HasSubstr("with all conditions"));
  scene_.find_dependent = false;
  const std::string plain = page_of(couple(false));
  EXPECT_THAT(plain, Not(HasSubstr("with all conditions")));
  EXPECT_THAT(plain, Not(HasSubstr("left out")));
}

TEST_F(CoupleReport, TheThresholdPartsTheSingularValuesOfEveryLine) {
  scene_.find_dependent = false;
  scene_.options.method = coupling::Method::grc;
  for (const auto threshold : {coupling::Threshold::fixed, coupling::Threshold::picard}) {
    scene_.options.threshold = threshold;
    const tasks::CoupleResult result = couple(false);
    const report::PlotGroup group = report::condition_plots(result, 10000);
    const auto& series = curves(group, 0, 1).series;
    const auto& kept = curves(group, 0, 2).series[0].y;
    ASSERT_EQ(series.size(), 6u);
    for (std::size_t line = 0; line < kept.size(); ++line) {
      const double level = std::isnan(series[5].y[line]) ? 0.0 : series[5].y[line];
      const bool drops = kept[line] < 5.0;
      const double judged = series[drops ? static_cast<std::size_t>(kept[line]) : 4].y[line];
      ASSERT_EQ(drops, judged <= level) << coupling::name(threshold) << " line " << line;
    }
  }
}

TEST(CouplePlots, AlphasThatAreNotThereAreLeftOut) {
  EXPECT_THAT(report::alpha_plots({1.0}, {coupling::LineRecord{}}, {"a"}, {}, 10).choices, IsEmpty());
  const report::PlotGroup group = report::alpha_plots(
      {1.0, 2.0}, {coupling::LineRecord{.alpha = {0.5}}, coupling::LineRecord{.alpha = {std::nan("")}}}, {"a"}, 0.3, 10);
  EXPECT_THAT(curves(group, 0, 0).series[0].y, ElementsAre(0.5, testing::IsNan()));
  EXPECT_EQ(curves(group, 0, 0).level, 0.3);
}

}  // namespace
}  // namespace jointid::cli
