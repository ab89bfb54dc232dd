// Responses of parts by their modal models, between the lines of their files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "report/response/response_text.hpp"
#include "tasks/response/read_response_scene.hpp"
#include "tasks/response/response_result.hpp"
#include "tasks/response/response_scene.hpp"
#include "tasks/response/run_response.hpp"
#include "tests/tasks/response/response_sample.hpp"

namespace jointid::tasks {
namespace {

using testing::HasSubstr;

/// The same structure by its matrices.
std::string matrices_scene(const std::string& frequency) {
  return "[structure]\nmodal_damping = 0.02\nmass = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]\n"
         "stiffness = [[500.0, -200.0, 0.0], [-200.0, 210.0, 0.0], [0.0, 0.0, 90.0]]\n[[joints]]\ndofs = [2, 3]\n" +
         std::string(sample_joint) + "[force]\ndof = 1\namplitudes = [8.0]\n[frequency]\n" + frequency +
         "[response]\ndofs = [1, 3]\nharmonics = [1, 3]\n";
}

/// Frequencies that are no lines: the response of the matrices to the accuracy of the models.
TEST(ResponseModal, ModelsOfPartsAnswerBetweenLines) {
  const TestFolder folder;
  write_parts(folder);
  const ResponseResult modal =
      run_parts(parts_scene("modal_model = true\nrange = [2.013, 3.987]\npoints = 9\n", "[1, 3]"), folder);
  const ResponseResult exact = run_parts(matrices_scene("range = [2.013, 3.987]\npoints = 9\n"), folder);
  EXPECT_THAT(modal.doubts, testing::IsEmpty());
  ASSERT_EQ(modal.levels[0].points.size(), 9u);
  for (std::size_t i = 0; i < 9; ++i) {
    const Eigen::MatrixXcd& a = modal.levels[0].points[i].response;
    const Eigen::MatrixXcd& b = exact.levels[0].points[i].response;
    ASSERT_EQ(a.rows(), b.rows());
    EXPECT_LE((a - b).cwiseAbs().maxCoeff(), 1e-4 * b.cwiseAbs().maxCoeff()) << i;
  }
}

/// Frequency and damping of the peak, from the lines beside it, against those that the matrices tell.
TEST(ResponseModal, PeaksOfModelsHaveAFrequencyAndADamping) {
  const TestFolder folder;
  write_parts(folder);
  const ResponseResult modal =
      run_parts(parts_scene("modal_model = true\nrange = [2.013, 3.987]\npoints = 81\n", "[1, 3]"), folder);
  const ResponseResult exact = run_parts(matrices_scene("range = [2.013, 3.987]\npoints = 81\n"), folder);
  ASSERT_TRUE(modal.levels[0].peak_mode);
  ASSERT_TRUE(exact.levels[0].peak_mode);
  EXPECT_NEAR(modal.levels[0].peak_mode->omega, exact.levels[0].peak_mode->omega, 5e-3 * exact.levels[0].peak_mode->omega);
  EXPECT_NEAR(modal.levels[0].peak_mode->ratio, exact.levels[0].peak_mode->ratio, 0.05 * exact.levels[0].peak_mode->ratio);
}

/// Harmonics beyond the band become error bars.
TEST(ResponseModal, HarmonicsBeyondTheBandAreErrorBars) {
  const TestFolder folder;
  write_parts(folder);
  const std::string text = parts_scene("modal_model = true\nvalues = [3.3333]\n", "[1, 3, 5, 7, 9]");
  const ResponseResult run = run_parts(text, folder);
  ASSERT_EQ(run.levels[0].left_out.size(), 1u);
  EXPECT_EQ(run.levels[0].points[0].harmonics, (std::vector<int>{1, 3, 5}));
  EXPECT_GT(run.levels[0].left_out[0](0, 0), 0.0);
  EXPECT_LT(run.levels[0].left_out[0](0, 0), 0.05 * std::abs(run.levels[0].points[0].response(0, 0)));
  const ResponseScene scene = parse_response_scene(text, folder / "scene.toml");
  EXPECT_THAT(report::response_text(scene, run), HasSubstr("their error bar"));
  EXPECT_EQ(nlohmann::json::parse(report::response_json(scene, run))["levels"][0]["points"][0]["left_out"][0].size(), 3u);
}

TEST(ResponseModal, SaysWhereThereIsNoModel) {
  const TestFolder folder;
  write_parts(folder);
  EXPECT_THROW(run_parts(parts_scene("modal_model = true\nvalues = [50.0]\n", "[1]"), folder), InputError);
  EXPECT_THAT(error_of(parts_scene("modal_model = true\n", "[1]")), HasSubstr("neither range nor values"));
  EXPECT_THAT(error_of(chain + replaced(rest, "points = 41", "modal_model = true")), HasSubstr("matrices need no modal model"));
  EXPECT_THAT(error_of(parts_scene("range = [2.0, 3.0]\npoints = 5\n", "[1]")), HasSubstr("points belong to a range"));
}

/// One line each: FRFs that are not reciprocal, and such as would feed the joint with energy.
TEST(ResponseModal, DoubtsFrfsThatNoStructureHas) {
  const TestFolder folder;
  write_parts(folder);
  frf::FrfSet set = frf::load(*frf::open(folder / "one.csv"));
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    set.values[set.index(line, 0, 1)] *= 1.5;
    set.values[set.index(line, 1, 1)] *= -1.0;
  }
  frf::write(set, folder / "one.csv");
  const std::string text = replaced(parts_scene("values = [3.0]\n", "[1]"), "[\"2:+X\", \"3:+X\"]", "[\"1:+X\", \"2:+X\"]");
  const ResponseResult run = run_parts(text, folder);
  ASSERT_EQ(run.doubts.size(), 2u);
  EXPECT_THAT(run.doubts[0], HasSubstr("not reciprocal"));
  EXPECT_THAT(run.doubts[1], HasSubstr("not passive"));
}

}  // namespace
}  // namespace jointid::tasks
