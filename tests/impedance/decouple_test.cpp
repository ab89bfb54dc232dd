#include "impedance/decouple/decouple.hpp"

#include "tests/impedance/golden.hpp"

namespace jointid::impedance {
namespace {

using nlohmann::json;

struct Beams {
  std::vector<frf::FrfSet> a, whole;
  DecoupleScene scene;
};

Beams beams(const json& given, const std::string& way) {
  std::vector<std::size_t> a(8), all(12);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  std::copy_n(all.begin(), a.size(), a.begin());
  return {{golden::set_of("A.h5", given["frequency_Hz"], a, golden::triangle(a), given["H_A"], given["sigma_A"])},
          {golden::set_of("AB.h5", given["frequency_Hz"], all, golden::triangle(all), given["H_AB"], given["sigma_AB"])},
          parse_decouple_scene(
              "[data]\nsubstructures = [\"A.h5\"]\nassembly = [\"AB.h5\"]\n[decouple]\ninterface = [\"7:+Y\", \"8:+Y\"]\nway = " +
                  way,
              "scene.toml")};
}

void expect_way(const DecoupledWay& way, const json& expected) {
  ASSERT_EQ(way.lines.size(), expected["H"].size());
  for (std::size_t i = 0; i < way.lines.size(); ++i) {
    ASSERT_TRUE(way.lines[i]);
    double largest = 0.0;
    for (const json& row : expected["H"][i]) {
      for (const json& one : row) largest = std::max(largest, std::abs(golden::complex(one)));
    }
    for (std::size_t r = 0; r < way.dofs.size(); ++r) {
      for (std::size_t c = 0; c < way.dofs.size(); ++c) {
        const auto row = static_cast<Eigen::Index>(r), column = static_cast<Eigen::Index>(c);
        EXPECT_LT(std::abs(way.lines[i]->h(row, column) - golden::complex(expected["H"][i][r][c])), 1e-9 * largest)
            << name(way.way) << i << r << c;
        const double variance = way.lines[i]->variance_re(row, column) + way.lines[i]->variance_im(row, column);
        EXPECT_NEAR(variance / expected["variance"][i][r][c].get<double>(), 1.0, 1e-7) << name(way.way) << i << r << c;
        EXPECT_NEAR(way.lines[i]->covariance[c](row, row).real() / variance, 1.0, 1e-12);
      }
    }
    for (std::size_t k = 0; k < expected["singular_values"][i].size(); ++k) {
      EXPECT_NEAR(way.lines[i]->singular_values(static_cast<Eigen::Index>(k)), expected["singular_values"][i][k].get<double>(),
                  1e-9 * expected["singular_values"][i][0].get<double>());
    }
  }
}

TEST(Decouple, ClosedFormsOfTheBeams) {
  IMPEDANCE_CASE(golden, "decoupling");
  const Beams given = beams(golden["given"], "[\"standard\", \"extended\", \"both\"]");
  const Decoupled found = decouple(given.scene, given.a, given.whole);
  const json& expected = golden["expected"];
  expect_way(found.ways[0], expected["standard"]);
  expect_way(found.ways[1], expected["extended_compatibility"]);
  expect_way(found.ways[2], expected["extended_both"]);
}

TEST(Decouple, TheLikelihoodsReceptanceIsNearerToTheTruth) {
  IMPEDANCE_CASE(golden, "decoupling");
  const Beams given = beams(golden["given"], "[\"likelihood\", \"standard\"]");
  const Decoupled found = decouple(given.scene, given.a, given.whole);
  const json expected = golden["expected"]["ml"];
  double of_likelihood = 0.0, of_standard = 0.0;
  for (std::size_t i = 0; i < found.frequency_hz.size(); ++i) {
    const DecoupledLine& one = *found.ways[0].lines[i];
    const Eigen::MatrixXcd y = one.h;
    const Complex z11 = golden::complex(expected["z_of_B"][i][0]), z12 = golden::complex(expected["z_of_B"][i][1]),
                  z22 = golden::complex(expected["z_of_B"][i][2]), determinant = z11 * z22 - z12 * z12;
    EXPECT_LT(std::abs(y(0, 0) - z22 / determinant), 1e-6 * std::abs(y(0, 0)));
    EXPECT_LT(std::abs(y(0, 1) + z12 / determinant), 1e-6 * std::abs(y(0, 1)));
    const Complex truth = golden::complex(golden["exact_B"][i][0]);  // the interface comes first there
    EXPECT_LT(std::abs(y(0, 0) - truth), 4.0 * std::sqrt(one.variance_re(0, 0) + one.variance_im(0, 0)));
    of_likelihood += std::abs(y(0, 0) - truth) / std::abs(truth);
    of_standard += std::abs(found.ways[1].lines[i]->h(0, 0) - truth) / std::abs(truth);
  }
  EXPECT_LT(2.0 * of_likelihood, of_standard);
}

/// Z = Y⁻¹ again, its covariance by differences.
TEST(Decouple, VariancesOfAReceptanceAreThoseOfDifferences) {
  Eigen::MatrixXcd z(2, 2);
  z << Complex(3.0, 1.0), Complex(-1.0, 0.2), Complex(-1.0, 0.2), Complex(2.0, 0.5);
  Eigen::MatrixXd root = Eigen::MatrixXd::Identity(6, 6);
  root(0, 3) = 0.4;
  root(2, 1) = -0.3;
  const Eigen::MatrixXd covariance = 1e-10 * root * root.transpose();
  const DecoupledLine y = receptance_of(z, covariance);
  double re = 0.0, im = 0.0;
  for (Eigen::Index k = 0; k < 6; ++k) {
    const Eigen::VectorXd d = 1e-5 * root.col(k);
    const Complex a = z(0, 0) + Complex(d(0), d(3)), b = z(0, 1) + Complex(d(1), d(4)), c = z(1, 1) + Complex(d(2), d(5));
    const Complex change = -b / (a * c - b * b) - y.h(0, 1);
    re += std::pow(change.real(), 2);
    im += std::pow(change.imag(), 2);
  }
  EXPECT_NEAR(y.variance_re(0, 1) / re, 1.0, 1e-4);
  EXPECT_NEAR(y.variance_im(0, 1) / im, 1.0, 1e-4);
}

TEST(Decouple, FrfsCarryVariancesAndCovariances) {
  IMPEDANCE_CASE(golden, "decoupling");
  const Beams given = beams(golden["given"], "\"standard\"");
  const Decoupled found = decouple(given.scene, given.a, given.whole);
  frf::FrfSet set = frfs_of(found, found.ways[0]);
  set.header.file = "B.h5";
  frf::validate(set);
  EXPECT_EQ(set.header.response.size(), 6U);  // interface, then what A lacks
  EXPECT_EQ(set.header.response[2].name(), "9:+Y");
  const DecoupledLine& line = *found.ways[0].lines[1];
  EXPECT_EQ(set.covariance[(frf::pair_count(6) + frf::pair_index(2, 1)) * 6 + 3], line.covariance[3](2, 1));
}

TEST(Decouple, BadScenesAreRefused) {
  const auto parse = [](const std::string& rest) {
    return parse_decouple_scene("[data]\nsubstructures = [\"A.h5\"]\nassembly = [\"AB.h5\"]\n[decouple]\n" + rest, "scene.toml");
  };
  EXPECT_THROW(parse("way = \"standard\""), InputError);
  EXPECT_THROW(parse("interface = [\"7:+Y\"]\nway = \"dual\""), InputError);
  EXPECT_THROW(parse("interface = [\"7:+Y\"]\nway = [\"both\", \"both\"]"), InputError);
}

}  // namespace
}  // namespace jointid::impedance
