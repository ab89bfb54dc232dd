// A part that is a model whose resonances are off by several of their widths.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>

#include "base/complex.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "tests/models/model_sample.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;

constexpr double loss = 0.01, level = 0.01, spring = 4e7, turning_spring = 3e4;

/// Of steel, eight elements, free.
problems::Structure steel_beam(std::int64_t first_node, double length, double stiffness = 1.0, double mass = 1.0) {
  problems::BeamLine line;
  line.first_node = first_node;
  for (int i = 0; i <= 8; ++i) line.x.push_back(length * i / 8.0);
  problems::Structure out =
      problems::beam({.width = 0.03, .thickness = 0.012, .youngs_modulus = 2.1e11 * stiffness, .density = 7800.0 * mass}, line);
  out.add_proportional_damping(loss);
  return out;
}

std::vector<frf::Dof> named(const std::vector<std::string>& names) {
  std::vector<frf::Dof> out;
  for (const std::string& name : names) out.push_back(frf::Dof::parse(name));
  return out;
}

/// Measured with 1 % noise, whose variances the file states.
void measure(const problems::Structure& structure, const std::vector<frf::Dof>& dofs, std::mt19937_64& random,
             const std::filesystem::path& file) {
  models::MatrixModel model(models::matrices_of(structure));
  std::vector<std::size_t> places;
  for (const frf::Dof& dof : dofs) places.push_back(structure.index(dof));
  frf::FrfSet set;
  set.header.file = file.string();
  set.header.response = set.header.reference = dofs;
  set.header.noise = frf::NoiseRecord::variance;
  for (int l = 0; l < 99; ++l) set.header.frequency_hz.push_back(30.0 + 15.0 * l);
  std::normal_distribution<double> normal;
  for (const double hz : set.header.frequency_hz) {
    const auto exact = model.receptance(angular(hz), places, places);
    for (Eigen::Index i = 0; i < exact->rows(); ++i) {
      for (Eigen::Index j = 0; j < exact->cols(); ++j) {
        const double deviation = level * std::abs((*exact)(i, j)) / std::sqrt(2.0);
        const double re = normal(random), im = normal(random);
        set.values.push_back((*exact)(i, j) + deviation * Complex(re, im));
        set.variance.emplace_back(deviation * deviation, deviation * deviation);
      }
    }
  }
  frf::write_hdf5(set, file);
}

/// Two beams on a spring and a turning spring with losses; the second is a model. `stiffness`, `mass`: ln of the true ones over
/// the model's.
Solution identified(double stiffness, double mass, unsigned seed) {
  const TestFolder folder;
  std::mt19937_64 random(seed);
  const problems::Structure a = steel_beam(1, 0.55), model = steel_beam(101, 0.45);
  measure(a, named({"1:+Y", "3:+Y", "5:+Y", "7:+Y", "9:+Y", "9:+RZ"}), random, folder / "a.h5");
  problems::Structure both = problems::merged(a, steel_beam(101, 0.45, std::exp(stiffness), std::exp(mass)));
  const std::vector<frf::Dof> ends = named({"9:+Y", "101:+Y", "9:+RZ", "101:+RZ"});
  for (const auto& [first, k, own_loss] : {std::tuple(0, spring, 0.03), std::tuple(2, turning_spring, 0.05)}) {
    const restrictions::Spring between{ends[static_cast<std::size_t>(first)], ends[static_cast<std::size_t>(first) + 1]};
    both.add(Kind::stiffness, between, k);
    both.add(Kind::hysteretic_damping, between, k * own_loss);
  }
  measure(both, named({"1:+Y", "3:+Y", "5:+Y", "7:+Y", "9:+Y", "103:+Y", "105:+Y", "107:+Y", "109:+Y"}), random,
          folder / "ab.h5");
  models::write_market(folder / "m.mtx", models::sparse_matrix(model, Kind::mass));
  models::write_market(folder / "k.mtx", models::sparse_matrix(model, Kind::stiffness));
  models::write_text(folder / "b.toml",
                     "mass = \"m.mtx\"\nstiffness = \"k.mtx\"\nloss_factor = 0.01\nstiffness_error = 0.02\nmass_error = 0.01\n"
                     "dofs = " +
                         models::dof_list(model.dofs()) + "\n");
  const std::string springs = R"(springs = [["9:+Y", "101:+Y"], ["9:+RZ", "101:+RZ"]])";
  const std::string text =
      "[data]\nsubstructures = [\"a.h5\", \"b.toml\"]\nassembly = [\"ab.h5\"]\n[joint]\n"
      "dofs = [\"9:+Y\", \"9:+RZ\", \"101:+Y\", \"101:+RZ\"]\n[joint.stiffness]\n" +
      springs + "\n[joint.hysteretic_damping]\n" + springs + "\n[identify]\nmethod = \"likelihood\"\n[[data.gains]]\ngain = 0\n";
  Control control;
  control.judgement = Judgement::data;  // as the command asks: it stops what no joint explains
  return solve(*make_plan(parse_scene(text, folder / "scene.toml")), control);
}

TEST(ModelScales, OfOneDeviationAreFound) {
  struct Truth {
    double stiffness, mass;
    unsigned seed;
  };
  // From the model as it is, the first ends far away.
  for (const Truth& truth : {Truth{0.01879, 0.00522, 57}, Truth{0.0205, -0.0196, 1}, Truth{-0.02, 0.01, 2}}) {
    const Solution found = identified(truth.stiffness, truth.mass, truth.seed);
    ASSERT_EQ(found.systematic.size(), 2u);
    ASSERT_TRUE(found.systematic[0].std_error && found.unknowns[0].std_error) << truth.stiffness << ' ' << found.message;
    EXPECT_NEAR(std::log(found.systematic[0].value), truth.stiffness, 5.0 * *found.systematic[0].std_error);
    EXPECT_NEAR(std::log(found.systematic[1].value), truth.mass, 5.0 * *found.systematic[1].std_error);
    EXPECT_NEAR(found.unknowns[0].value, spring, 5.0 * *found.unknowns[0].std_error);
  }
}

}  // namespace
}  // namespace jointid::ident
