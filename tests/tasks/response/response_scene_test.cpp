#include "tasks/response/response_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/control.hpp"
#include "base/error.hpp"
#include "frf/set/frf_source.hpp"
#include "models/files/matrix_file.hpp"
#include "report/response/response_text.hpp"
#include "response/structure/modal_damping.hpp"
#include "tasks/response/read_response_scene.hpp"
#include "tasks/response/response_result.hpp"
#include "tasks/response/run_response.hpp"
#include "tests/tasks/response/response_sample.hpp"

namespace jointid::tasks {
namespace {

using testing::HasSubstr;

TEST(ResponseScene, ReadsAllThatItSays) {
  const ResponseScene scene = parse_response_scene(chain + rest, "scene.toml");
  EXPECT_EQ(scene.joints.size(), 1u);
  EXPECT_EQ(scene.joints[0].positive.coordinate, 1);
  EXPECT_EQ(scene.joints[0].negative->coordinate, 2);
  EXPECT_EQ(scene.joints[0].joint.name, "2–3");
  EXPECT_EQ(scene.joints[0].joint.values(), (std::vector<double>{0.004, 1.5, 150.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(scene.levels, (std::vector<double>{1.0, 3.0}));
  EXPECT_EQ(scene.harmonics.fixed, (std::vector<int>{1, 3, 5}));
  EXPECT_EQ(scene.responses[1].coordinate, 2);
}

TEST(ResponseScene, SaysInOneLineWhatIsWrong) {
  const std::string good = chain + rest;
  const std::vector<std::array<std::string, 3>> wrong = {
      {"law = \"ren\"", "law = \"rem\"", "rem"},
      {"parameters = { a = 0.004, b = 1.5, k = 150.0 }", "", "'parameters' is missing"},
      {"b = 1.5, ", "", "'b' is missing"},
      {"b = 1.5", "c = 1.5", "'c' is not known here"},
      {"{ a = 0.004, b = 1.5, k = 150.0 }", "[0.004, 1.5]", "law ren has 3 parameters, here are 2"},
      {"a = 0.004", "a = -0.004", "a"},
      {"dofs = [2, 3]", "dofs = [2, 4]", "4 is not a whole number from 1 to 3"},
      {"dofs = [2, 3]", "dofs = [2, 2]", "both ends are 2"},
      {"dofs = [2, 3]", "dofs = [1, 2, 3]", "one end or two"},
      {"dof = 1", "dof = 1.5", "1.5 is not a whole number"},
      {"amplitudes = [1.0, 3.0]", "amplitudes = [0.0]", "amplitudes[1]"},
      {"harmonics = [1, 3, 5]", "harmonics = [3, 5]", "harmonic 1 of the force is not among them"},
      {"harmonics = [1, 3, 5]", "harmonics = [1, 5, 3]", "harmonic 3 does not ascend"},
      {"range = [2.0, 4.0]", "range = [0.0, 4.0]", "begins at 0 Hz"},
      {"range = [2.0, 4.0]", "values = [2.0]", "points belong to a range"},
      {"[frequency]\nrange = [2.0, 4.0]\npoints = 41", "", "'frequency' is missing"},
      {"mass = [[1.0, 0.0, 0.0]", "mass = [[1.0, 0.1, 0.0]", "not symmetric"},
      {"damping = [[0.5, -0.16, 0.0], [-0.16, 0.32, -0.04], [0.0, -0.04, 0.21]]", "damping = [[0.5]]", "the mass matrix 3"},
      {"[structure]", "[data]\nparts = [\"a.h5\"]\n[structure]", "both [data] and [structure]"},
      {"[response]", "[responses]", "did you mean response?"},
  };
  for (const auto& [what, by, message] : wrong) {
    const std::string found = error_of(replaced(good, what, by));
    EXPECT_THAT(found, HasSubstr(message)) << what << " → " << by;
    EXPECT_EQ(found.find('\n'), std::string::npos);
  }
  EXPECT_THAT(error_of(rest), HasSubstr("there is no structure"));
}

/// A slider as itself, as a table, as two side by side and as one behind a spring: the same responses, and names of parameters.
TEST(ResponseScene, LawsAreTablesOrMadeOfParts) {
  const std::string ren = "law = \"ren\"\nparameters = { a = 0.004, b = 1.5, k = 150.0 }";
  const auto run_with = [&](const std::string& law) {
    return run_response(parse_response_scene(replaced(chain + rest, ren, law), "scene.toml"));
  };
  const ResponseResult slider = run_with("law = \"bilinear\"\nparameters = { a = 0.004, k = 150.0 }");
  const std::vector<std::string> same = {
      "law = \"generalised\"\nparameters = { k = 150.0, slip = [[0.0, 0.004], [1.0, 0.004]] }",
      "law = \"parallel\"\nparts = [{ law = \"bilinear\", parameters = [0.004, 100.0] },\n"
      "         { law = \"bilinear\", parameters = { a = 0.004, k = 50.0 } }]\ndeviations = { \"2.k\" = 5.0 }",
      "law = \"series\"\nparts = [{ law = \"bilinear\", parameters = [0.002, 300.0] },\n"
      "         { law = \"parallel\", parts = [{ law = \"spring\", parameters = [300.0] }] }]",
  };
  for (const std::string& law : same) {
    const ResponseResult other = run_with(law);
    for (std::size_t level = 0; level < 2; ++level) {
      const auto &expected = slider.levels[level].points, &found = other.levels[level].points;
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_TRUE(found[i].converged);
        EXPECT_LT((found[i].response - expected[i].response).cwiseAbs().maxCoeff(),
                  1e-10 * expected[i].response.cwiseAbs().maxCoeff());
      }
    }
  }
  const std::vector<std::array<std::string, 2>> wrong = {
      {"law = \"series\"", "the key 'parts' is missing"},
      {"law = \"series\"\nparameters = [1.0]", "law series has the parameters of its parts"},
      {"law = \"parallel\"\nparts = [{ law = \"ren\" }]", "[joints[1].parts[1]]: the key 'parameters' is missing"},
      {"law = \"parallel\"\nparts = [{ parameters = [1.0] }]", "the key 'law' is missing"},
      {"law = \"ren\"\nparts = [{ law = \"ren\" }]", "law ren has no parts"},
      {"parts = [{ law = \"ren\" }]", "there are parts and no law"},
      {"law = \"generalised\"\nparameters = { k = 1.0, slip = [[0.0, 1.0], [2.0, 3.0]] }", "point 2: shares are at most 1"},
      {"law = \"generalised\"\nparameters = { k = 1.0, slip = [[0.0]] }", "slip[1]: a point is [share that slips, displacement]"},
      {"law = \"rem\"\nparameters = [1.0]",
       "valid: ren, shoukry, burdekin, bilinear, iwan, spring, power, square, exponential-offset, menq, menq-shape, bending-root, "
       "bending-root-shape, generalised, series, parallel"},
  };
  for (const auto& [law, message] : wrong) EXPECT_THAT(error_of(replaced(chain + rest, ren, law)), HasSubstr(message)) << law;
}

TEST(ResponseScene, FindsPeaksOverLevels) {
  const ResponseScene scene = parse_response_scene(chain + rest, "scene.toml");
  const ResponseResult run = run_response(scene);
  ASSERT_EQ(run.levels.size(), 2u);
  EXPECT_TRUE(all_converged(run));
  for (const LevelResponse& level : run.levels) {
    ASSERT_TRUE(level.peak && level.refined);
    for (const auto& point : level.points) EXPECT_LE(std::abs(point.response(0, 0)), std::abs(level.peak->response(0, 0)));
  }
  EXPECT_LT(run.levels[1].peak->omega, run.levels[0].peak->omega);  // friction softens
  EXPECT_THAT(report::response_text(scene, run), HasSubstr("peak Hz"));
  const auto json = nlohmann::json::parse(report::response_json(scene, run));
  EXPECT_EQ(json["status"], "ok");
  EXPECT_EQ(json["levels"][0]["points"].size(), 41u);
  EXPECT_EQ(json["levels"][0]["points"][0]["responses"][1].size(), 3u);
  EXPECT_THAT(
      report::response_csv(run),
      HasSubstr("force [N],frequency [Hz],harmonic,dof,re [m],im [m],std dev re [m],std dev im [m],left out [m]\n1,2,1,1,"));
}

TEST(ResponseScene, TellsDeviationsOfTheLaw) {
  const std::string known = replaced(chain + rest, "[force]", "deviations = { k = 5.0 }\n[force]");
  const ResponseScene scene =
      parse_response_scene(replaced(known, "range = [2.0, 4.0]\npoints = 41", "values = [2.9]"), "scene.toml");
  EXPECT_EQ(scene.joints[0].deviations, (std::vector<double>{0.0, 0.0, 5.0}));
  const ResponseResult run = run_response(scene);
  ASSERT_EQ(run.levels[0].deviations.size(), 1u);
  EXPECT_GT(run.levels[0].deviations[0].amplitude(0, 0), 0.0);
  EXPECT_THAT(report::response_text(scene, run), HasSubstr("std dev"));
  EXPECT_EQ(nlohmann::json::parse(report::response_json(scene, run))["levels"][0]["points"][0]["response_deviations"][0].size(),
            3u);
  EXPECT_THAT(error_of(replaced(known, "k = 5.0", "q = 5.0")), HasSubstr("'q' is not known here"));
}

/// The point of it all: two parts known by their FRFs alone respond as their matrices say.
TEST(ResponseScene, FilesOfPartsGiveWhatMatricesGive) {
  const TestFolder folder;
  Eigen::MatrixXd k1(2, 2), k2(1, 1);
  k1 << 500.0, -200.0, -200.0, 210.0;
  k2 << 90.0;
  const Eigen::MatrixXd m1 = Eigen::MatrixXd::Identity(2, 2), m2 = Eigen::MatrixXd::Identity(1, 1);
  const response::MatrixStructure one = {m1, response::modal_damping(m1, k1, 0.02), k1},
                                  two = {m2, response::modal_damping(m2, k2, 0.02), k2};
  write_part(folder / "one.csv", one, 1);
  write_part(folder / "two.csv", two, 3);
  const std::string joint = "law = \"bilinear\"\nparameters = [0.01, 150.0]\n";
  const std::string end = "amplitudes = [8.0]\n[frequency]\nrange = [2.0, 4.0]\n";
  const std::string files = "[data]\nparts = [\"one.csv\", \"two.csv\"]\n[[joints]]\ndofs = [\"2:+X\", \"3:+X\"]\n" + joint +
                            "[force]\ndof = \"1:+X\"\n" + end +
                            "[response]\ndofs = [\"1:+X\", \"3:+X\"]\nharmonics = [1, 3, 5]\n";
  const std::string matrices =
      "[structure]\nmodal_damping = 0.02\nmass = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]\n"
      "stiffness = [[500.0, -200.0, 0.0], [-200.0, 210.0, 0.0], [0.0, 0.0, 90.0]]\n[[joints]]\ndofs = [2, 3]\n" +
      joint + "[force]\ndof = 1\n" + end + "points = 41\n[response]\ndofs = [1, 3]\nharmonics = [1, 3, 5]\n";
  const ResponseResult measured = run_response(parse_response_scene(files, folder / "scene.toml"));
  const ResponseResult computed = run_response(parse_response_scene(matrices, folder / "scene.toml"));
  ASSERT_EQ(measured.levels[0].points.size(), 41u);
  EXPECT_TRUE(all_converged(measured));
  EXPECT_TRUE(measured.doubts.empty());
  for (std::size_t i = 0; i < 41; ++i) {
    const Eigen::MatrixXcd& a = measured.levels[0].points[i].response;
    const Eigen::MatrixXcd& b = computed.levels[0].points[i].response;
    EXPECT_LE((a - b).cwiseAbs().maxCoeff(), 1e-8 * b.cwiseAbs().maxCoeff()) << i;
  }
  // The ninth harmonic of 4 Hz is beyond the last line.
  const std::string more = replaced(files, "[1, 3, 5]", "[1, 3, 5, 7, 9]");
  const ResponseScene beyond = parse_response_scene(more, folder / "scene.toml");
  const ResponseResult dropped = run_response(beyond);
  EXPECT_EQ(dropped.levels[0].points.back().dropped.size(), 2u);
  const std::vector<frf::FrfSet> sets = {frf::load(*frf::open(folder / "one.csv")), frf::load(*frf::open(folder / "two.csv"))};
  const ResponseResult in_memory = run_response(beyond, sets);
  EXPECT_EQ(in_memory.levels[0].points[3].response, dropped.levels[0].points[3].response);
  EXPECT_THAT(report::response_text(beyond, dropped), HasSubstr("harmonics beyond the lines of the files are dropped"));
  EXPECT_THROW(run_response(parse_response_scene(replaced(files, "\"1:+X\"\n", "\"1:+Y\"\n"), folder / "scene.toml")),
               InputError);
  EXPECT_THROW(run_response(parse_response_scene(replaced(files, "[2.0, 4.0]", "[50.0, 60.0]"), folder / "scene.toml")),
               InputError);
}

TEST(RunResponse, TellsHowFarItIsAndStops) {
  const ResponseScene scene = parse_response_scene(chain + rest, "scene.toml");
  std::vector<std::string> stages;
  std::size_t last = 0;
  ident::Control control;
  control.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 41u);
    if (stages.empty() || stages.back() != stage) stages.push_back(stage);
    last = done;
  };
  run_response(scene, control);
  EXPECT_THAT(stages, testing::ElementsAre("1 N", "3 N"));
  EXPECT_GE(last, 40u);
  control.interrupted = [] { return true; };
  EXPECT_THROW(run_response(scene, control), Interrupted);
}

TEST(MatrixFile, ReadsMatrixMarketAndText) {
  const TestFolder folder;
  const auto written = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
    return folder / name;
  };
  Eigen::MatrixXd expected(2, 2);
  expected << 2.0, -1.0, -1.0, 3.0;
  const std::string head = "%%MatrixMarket matrix ";
  for (const auto& path :
       {written("a.mtx", head + "coordinate real symmetric\n2 2 3\n1 1 2\n2 1 -1\n2 2 3\n"),
        written("b.mtx", head + "array real general\n2 2\n2\n-1\n-1\n3\n"), written("c.csv", "2,-1\n-1,3\n")}) {
    EXPECT_EQ(models::read_symmetric_matrix(path), expected) << path;
  }
  for (const std::string text :
       {"coordinate real symmetric\n2 2 3\n1 1 2\n", "coordinate real symmetric\n2 2 1\n3 1 2\n",
        "coordinate complex symmetric\n1 1 1\n1 1 2 0\n", "array real general\n2 2\n2\n1\n-1\n3\n",
        "coordinate real general\n2 3 0\n", "coordinate real general\n1e9 1e9 0\n", "array real general\n1 1\nnan\n"}) {
    EXPECT_THROW(models::read_symmetric_matrix(written("d.mtx", head + text)), InputError) << text;
  }
  EXPECT_THROW(models::read_symmetric_matrix(folder / "absent.mtx"), InputError);
}

/// More than most_full coordinates stay sparse and give what fewer would: a long chain is the same at its first masses.
TEST(ResponseScene, LargeModelsStaySparse) {
  const TestFolder folder;
  const auto write = [&](const std::string& name, Eigen::Index n, double diagonal, double beside) {
    std::ofstream out(folder / name);
    out << "%%MatrixMarket matrix coordinate real symmetric\n" << n << " " << n << " " << 2 * n - 1 << "\n";
    for (Eigen::Index i = 1; i <= n; ++i) {
      out << i << " " << i << " " << diagonal << "\n";
      if (i < n) out << i + 1 << " " << i << " " << beside << "\n";
    }
  };
  const auto run_of = [&](Eigen::Index n, const std::string& further) {
    write("m.mtx", n, 1.0, 0.0);
    write("c.mtx", n, 20.0, -9.0);
    write("k.mtx", n, 2000.0, -900.0);
    const std::string text =
        "[structure]\nmass = \"m.mtx\"\ndamping = \"c.mtx\"\nstiffness = \"k.mtx\"\n[[joints]]\ndofs = [2, 3]\nlaw = "
        "\"bilinear\"\n"
        "parameters = [0.002, 800.0]\n[force]\ndof = 1\namplitudes = [20.0]\n[frequency]\nvalues = [5.0, 6.0]\n"
        "[response]\ndofs = [1, 3]\nharmonics = [1, 3, 5]\n" +
        further;
    const ResponseScene scene = parse_response_scene(text, folder / "scene.toml");
    EXPECT_EQ(scene.sparse.has_value(), n > most_full);
    EXPECT_EQ(coordinates(scene), n);
    return run_response(scene);
  };
  const ResponseResult small = run_of(200, ""), large = run_of(1000, "");
  EXPECT_TRUE(all_converged(large));
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::MatrixXcd &a = large.levels[0].points[i].response, &b = small.levels[0].points[i].response;
    EXPECT_LE((a - b).cwiseAbs().maxCoeff(), 1e-9 * b.cwiseAbs().maxCoeff());
  }
  EXPECT_THROW(run_of(1000, "stability = true\n"), InputError);
  EXPECT_THROW(run_of(1000, "[transient]\nduration = 1.0\n"), InputError);
}

}  // namespace
}  // namespace jointid::tasks
