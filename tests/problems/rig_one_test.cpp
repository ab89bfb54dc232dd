#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/problem.hpp"
#include "tests/test_folder.hpp"

namespace jointid::problems {
namespace {

namespace fs = std::filesystem;
using restrictions::Kind;
using weighting::Weighting;

constexpr int seeds = 20;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

double largest_relative_error(const ident::Matrix& identified, const ident::Matrix& exact) {
  double error = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t j = 0; j < exact.size(); ++j) error = std::max(error, std::abs(identified[i][j] / exact[i][j] - 1.0));
  }
  return error;
}

struct Errors {
  std::vector<double> stiffness, damping, decibel;
};

/// Identifies the rig from binary universal files of 20 simulated tests, with each weighting.
std::map<Weighting, Errors> identify_twenty_tests() {
  const Problem problem = make("rig1");
  std::map<Weighting, Errors> errors;
  for (int seed = 1; seed <= seeds; ++seed) {
    const TestFolder folder;
    const fs::path file = write(problem, folder, {.format = "uff", .seed = static_cast<std::uint64_t>(seed)});
    ident::Scene scene = ident::read_scene(file);
    for (const Weighting weighting : {Weighting::none, Weighting::wa, Weighting::wb, Weighting::wbg, Weighting::wbs}) {
      scene.identify.weighting = weighting;
      const auto plan = ident::make_plan(scene);
      const ident::Solution solution = ident::solve(*plan);
      EXPECT_EQ(solution.status, ident::Status::ok) << solution.message;
      const ident::Matrices& found = solution.bands.front().matrices;
      errors[weighting].stiffness.push_back(largest_relative_error(found.at(Kind::stiffness), scene.truth.at(Kind::stiffness)));
      errors[weighting].damping.push_back(
          largest_relative_error(found.at(Kind::hysteretic_damping), scene.truth.at(Kind::hysteretic_damping)));
      errors[weighting].decibel.push_back(*solution.fit.asm_frf_error);
    }
  }
  return errors;
}

TEST(RigOne, IsIdentifiedFromBinaryUniversalFiles) {
  const auto errors = identify_twenty_tests();
  double best = 1e300, best_decibel = 1e300;
  std::printf("rig1, medians over %d seeds: largest relative error of K, of D, assembly FRF error in dB\n", seeds);
  for (const auto& [weighting, error] : errors) {
    std::printf("  %-5s %8.3f %8.3f %8.3f\n", name(weighting).c_str(), median(error.stiffness), median(error.damping),
                median(error.decibel));
    if (median(error.stiffness) < best) {
      best = median(error.stiffness);
      best_decibel = median(error.decibel);
    }
  }
  EXPECT_LE(best, 0.15);
  EXPECT_LE(best_decibel, 1.0);
}

}  // namespace
}  // namespace jointid::problems
