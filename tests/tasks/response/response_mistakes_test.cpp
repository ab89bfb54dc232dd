// What a laboratory does wrong, as `jointid response` tells it of the FRFs of parts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <complex>
#include <functional>
#include <random>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "report/response/response_text.hpp"
#include "tasks/response/read_response_scene.hpp"
#include "tasks/response/response_scene.hpp"
#include "tasks/response/run_response.hpp"
#include "tests/tasks/response/response_sample.hpp"

namespace jointid::tasks {
namespace {

using testing::HasSubstr;

/// One mistake of a laboratory: H of a line and its frequency, as measured instead.
struct Mistake {
  const char* file;
  std::function<Eigen::MatrixXcd(const Eigen::MatrixXcd&, double omega)> made;
  std::vector<std::string> told;  ///< one doubt each
};

void change(const std::filesystem::path& path, const Mistake& mistake) {
  frf::FrfSet set = frf::load(*frf::open(path));
  const std::size_t n = set.header.response.size();
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    Eigen::MatrixXcd h(n, n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) h(at(i), at(j)) = set.values[set.index(line, i, j)];
    }
    h = mistake.made(h, angular(set.header.frequency_hz[line]));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) set.values[set.index(line, i, j)] = h(at(i), at(j));
    }
  }
  frf::write(set, path);
}

/// Each is named with its part; of a part that a sign, a quantity or a gain would put right, that.
TEST(ResponseMistakes, NamesTheMistakesOfALaboratory) {
  using Matrix = Eigen::MatrixXcd;
  const auto rows = [](double first, double second) {
    return [=](const Matrix& h, double) -> Matrix { return Eigen::Vector2d(first, second).asDiagonal() * h; };
  };
  const std::vector<Mistake> mistakes = {
      {"two.csv",
       [](const Matrix& h, double) -> Matrix { return -h; },
       {"3:\\+X are not passive.*−H would be: signs turned round"}},
      {"two.csv", [](const Matrix& h, double w) -> Matrix { return -w * w * h; }, {"accelerances taken for receptances"}},
      {"two.csv", [](const Matrix& h, double w) -> Matrix { return Complex(0.0, w) * h; }, {"mobilities taken for receptances"}},
      {"two.csv", [](const Matrix& h, double w) -> Matrix { return std::polar(1.0, -0.01 * w) * h; }, {"channels with a time delay"}},
      {"one.csv", rows(1.0, -1.0), {"reciprocal.*1:\\+X/2:\\+X.*turned round", "other sign of 2:\\+X.*turned round"}},
      {"one.csv", rows(9.81, 1.0), {"reciprocal.*9.81 times as large: a gain"}},
      {"one.csv",
       [](const Matrix& h, double) -> Matrix { return h.colwise().reverse(); },
       {"reciprocal.*1:", "not passive.*exchanged labels"}},
  };
  const std::string text = parts_scene("values = [3.0]\n", "[1]");
  for (std::size_t i = 0; i < mistakes.size(); ++i) {
    const TestFolder folder;
    write_parts(folder);
    EXPECT_THAT(run_parts(text, folder).doubts, testing::IsEmpty());
    change(folder / mistakes[i].file, mistakes[i]);
    const std::vector<std::string> doubts = run_parts(text, folder).doubts;
    ASSERT_GE(doubts.size(), mistakes[i].told.size()) << i;
    for (std::size_t k = 0; k < mistakes[i].told.size(); ++k) {
      EXPECT_THAT(doubts[k], testing::ContainsRegex(mistakes[i].told[k])) << i;
      EXPECT_THAT(doubts[k], HasSubstr(mistakes[i].file));
      EXPECT_EQ(doubts[k].find('\n'), std::string::npos);
    }
  }
}

/// Noise that the files state is no mistake, however large; unstated it would be one.
TEST(ResponseMistakes, StatedNoiseIsNoMistake) {
  const TestFolder folder;
  write_parts(folder);
  const std::string text = parts_scene("values = [3.0]\n", "[1]");
  for (const bool stated : {false, true}) {
    write_parts(folder);
    for (const char* name : {"one.csv", "two.csv"}) {
      frf::FrfSet set = frf::load(*frf::open(folder / name));
      std::mt19937_64 generator(5);
      std::normal_distribution<double> normal;
      if (stated) {
        set.header.noise = frf::NoiseRecord::variance;
        set.variance.clear();
      }
      for (Complex& value : set.values) {
        const double deviation = 0.1 * std::abs(value), re = normal(generator);
        value += deviation * Complex(re, normal(generator));
        if (stated) set.variance.emplace_back(deviation * deviation, deviation * deviation);
      }
      frf::write(set, folder / name);
    }
    EXPECT_EQ(run_parts(text, folder).doubts.empty(), stated);
  }
}

/// A joint that is as good as none (its law in units a billion times too small), and one that all but sticks.
TEST(ResponseMistakes, SaysWhatAJointDoesThatIsNone) {
  const TestFolder folder;
  write_parts(folder);
  const auto told = [&](const std::string& parameters) {
    const std::string text = replaced(parts_scene("values = [2.0, 3.0]\n", "[1, 3]"), "[0.01, 150.0]", parameters);
    const ResponseScene scene = parse_response_scene(text, folder / "scene.toml");
    return report::response_text(scene, run_response(scene));
  };
  EXPECT_THAT(told("[0.01, 1.5e-9]"), HasSubstr("joint 2:+X–3:+X takes all the motion"));
  EXPECT_THAT(told("[0.01, 1.5]"), testing::Not(HasSubstr("takes all the motion")));
  EXPECT_THAT(told("[1e-14, 1e14]"), HasSubstr("may be softened until the response changes"));
}

/// Lines further apart than a resonance is wide: its height is not known, and that is said.
TEST(ResponseMistakes, SaysWhereAPeakIsNarrowerThanTheLines) {
  const TestFolder folder;
  const auto narrow = [&](std::size_t every) {
    write_parts(folder);
    for (const char* name : {"one.csv", "two.csv"}) {
      const frf::FrfSet fine = frf::load(*frf::open(folder / name));
      frf::FrfSet coarse = fine;
      coarse.header.frequency_hz.clear();
      coarse.values.clear();
      const std::size_t entries = fine.header.entries();
      for (std::size_t line = every - 1; line < fine.header.lines(); line += every) {
        coarse.header.frequency_hz.push_back(fine.header.frequency_hz[line]);
        for (std::size_t e = 0; e < entries; ++e) coarse.values.push_back(fine.values[line * entries + e]);
      }
      frf::write(coarse, folder / name);
    }
    const std::string text = parts_scene("range = [1.0, 4.0]\n", "[1]");
    const ResponseScene scene = parse_response_scene(text, folder / "scene.toml");
    return report::response_text(scene, run_response(scene));
  };
  EXPECT_THAT(narrow(8), HasSubstr("ts height between them is not known"));
  EXPECT_THAT(narrow(1), testing::Not(HasSubstr("ts height between them is not known")));
}

}  // namespace
}  // namespace jointid::tasks
