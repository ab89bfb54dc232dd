#include "tests/impedance/golden.hpp"

namespace jointid::impedance {
namespace {

using nlohmann::json;

IdentifiedLines solve(const json& golden, const std::string& rest) {
  golden::LinesCase given = golden::lines_case(golden["given"]);
  return identify_lines(golden::scene_of(given.dofs, rest), std::move(given.substructures), std::move(given.assembly));
}

const WayResult& of(const IdentifiedLines& found, Way way) { return *std::ranges::find(found.ways, way, &WayResult::way); }

TEST(GoldenLines, ClosedFormsOfSiso) {
  IMPEDANCE_CASE(golden, "siso");
  const json& expected = golden["expected"];
  const IdentifiedLines found = solve(golden,
                                      "lines = \"massless\"\nway = [\"primal\", \"average\", \"off-diagonal\", \"relative\", "
                                      "\"extended\", \"nn\", \"nj\", \"weighed\"]");
  for (const auto& [way, key] : {std::pair(Way::primal, "primal"),
                                 {Way::average, "average"},
                                 {Way::off_diagonal, "off_diagonal"},
                                 {Way::relative, "relative"},
                                 {Way::extended, "extended"},
                                 {Way::nn, "nn_T"},
                                 {Way::nj, "nj"},
                                 {Way::weighed, "gls"}}) {
    golden::expect_values(of(found, way), expected[key]["z"], 1e-9);
    if (expected[key].contains("variance")) golden::expect_variances(of(found, way), expected[key]["variance"], 1e-8);
  }
  for (std::size_t i = 0; i < expected["gls"]["chi2"].size(); ++i) {
    EXPECT_NEAR(of(found, Way::weighed).lines[i]->chi_square, expected["gls"]["chi2"][i].get<double>(),
                1e-8 * expected["gls"]["chi2"][i].get<double>());
    EXPECT_NEAR(found.condition_assembly[i], golden["condition_asm_jj"][i].get<double>(), 1e-9 * found.condition_assembly[i]);
  }
}

TEST(GoldenLines, LikelihoodOfSiso) {
  IMPEDANCE_CASE(golden, "siso");
  const json& expected = golden["expected"];
  golden::expect_likelihood(solve(golden, "lines = \"massless\"").ways[0], expected["ml_massless"], 18.0);
  golden::expect_likelihood(solve(golden, "lines = \"massless\"\n[identify]\nequations = [\"jj\"]").ways[0],
                            expected["ml_massless_jj"], 4.0);
  const IdentifiedLines full = solve(golden, "lines = \"symmetric\"");
  golden::expect_likelihood(full.ways[0], expected["ml_full"], 14.0);
  EXPECT_EQ(full.status, Status::ok) << full.message;
}

TEST(GoldenLines, JointWithMasses) {
  IMPEDANCE_CASE(golden, "siso_mass");
  const json& expected = golden["expected"];
  const IdentifiedLines found =
      solve(golden, "lines = \"symmetric\"\nway = [\"likelihood\", \"dual\", \"primal\", \"extended\"]");
  golden::expect_likelihood(of(found, Way::likelihood), expected["ml_full"], 14.0);
  for (const auto& [way, key] : {std::pair(Way::primal, "primal"), {Way::dual, "primal"}, {Way::extended, "extended"}}) {
    golden::expect_values(of(found, way), expected[key]["z"], 1e-9);
    golden::expect_variances(of(found, way), expected[key]["variance"], 1e-8);
  }
  ASSERT_EQ(found.joint_receptance.size(), found.frequency_hz.size());
  for (std::size_t i = 0; i < found.joint_receptance.size(); ++i) {
    const json& receptance = expected["dual"]["receptance"][i];
    EXPECT_LT(std::abs(found.joint_receptance[i](0, 1) - golden::complex(receptance[1])),
              1e-9 * std::abs(golden::complex(receptance[1])));
  }
  const IdentifiedLines masses = solve(golden, "lines = \"masses\"");
  ASSERT_EQ(masses.ways[0].elements.size(), 3U);
  EXPECT_EQ(masses.ways[0].elements[1].name, "m(1)");
  for (std::size_t i = 0; i < masses.ways[0].lines.size(); ++i) {
    EXPECT_NEAR(masses.ways[0].lines[i]->chi_square, expected["ml_full"]["chi2"][i].get<double>(),
                1e-6);  // the same Z in other elements
  }
}

TEST(GoldenLines, IsolatorsOfSixCoordinates) {
  for (const char* id : {"isolator_kelvin_voigt", "isolator_fractional_zener"}) {
    IMPEDANCE_CASE(golden, id);
    const json& expected = golden["expected"];
    const IdentifiedLines found =
        solve(golden, "lines = \"massless\"\nway = [\"likelihood\", \"average\", \"off-diagonal\", \"relative\", \"weighed\"]");
    golden::expect_likelihood(of(found, Way::likelihood), expected["ml_massless"], 114.0);
    for (const auto& [way, key] : {std::pair(Way::average, "average"),
                                   {Way::off_diagonal, "off_diagonal"},
                                   {Way::relative, "relative"},
                                   {Way::weighed, "gls"}}) {
      golden::expect_values(of(found, way), expected[key]["z"], 1e-9);
      golden::expect_variances(of(found, way), expected[key]["variance"], 1e-6);
    }
  }
}

TEST(GoldenLines, CaseA1) {
  IMPEDANCE_CASE(golden, "a1");
  const json& expected = golden["expected"];
  const IdentifiedLines found = solve(golden, "lines = \"symmetric\"\nway = [\"likelihood\", \"primal\", \"extended\", \"nj\"]");
  golden::expect_likelihood(of(found, Way::likelihood), expected["ml_full"], 190.0);
  for (const auto& [way, key, digits] :
       {std::tuple(Way::primal, "primal", 1e-9), {Way::extended, "extended", 1e-9}, {Way::nj, "nj", 1e-5}}) {
    golden::expect_values(of(found, way), expected[key]["z"], digits);
    golden::expect_variances(of(found, way), expected[key]["variance"], std::max(1e-6, 10.0 * digits));
  }
}

TEST(GoldenLines, DecouplingIsAnIdentificationOfLines) {
  IMPEDANCE_CASE(golden, "decoupling");
  const json& given = golden["given"];
  std::vector<std::size_t> a(8), all(12);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  std::copy_n(all.begin(), a.size(), a.begin());
  std::vector<frf::FrfSet> part = {
      golden::set_of("A.h5", given["frequency_Hz"], a, golden::triangle(a), given["H_A"], given["sigma_A"])};
  std::vector<frf::FrfSet> whole = {
      golden::set_of("AB.h5", given["frequency_Hz"], a, golden::triangle(all), given["H_AB"], given["sigma_AB"])};
  const LineScene scene = golden::scene_of("\"7:+Y\", \"8:+Y\"", "lines = \"symmetric\"", "\"A.h5\"");
  const IdentifiedLines found = identify_lines(scene, std::move(part), std::move(whole));
  json expected = golden["expected"]["ml"];
  expected["z"] = expected["z_of_B"];
  golden::expect_likelihood(found.ways[0], expected, 66.0);
}

TEST(Lines, AMassTakenForNoneIsTold) {
  IMPEDANCE_CASE(golden, "siso_mass");
  const IdentifiedLines found = solve(golden, "lines = \"massless\"");
  EXPECT_NE(found.status, Status::ok);
  EXPECT_NE(found.message.find("contradict structure \"massless\""), std::string::npos) << found.message;
}

TEST(Lines, WithoutDegreesOfFreedomNothingContradicts) {
  IMPEDANCE_CASE(golden, "siso");
  const IdentifiedLines found = solve(golden, "lines = \"symmetric\"\n[identify]\nequations = [\"jj\"]");
  EXPECT_EQ(found.status, Status::doubtful);
  EXPECT_NE(found.message.find("Nothing can contradict"), std::string::npos);
  golden::expect_values(found.ways[0], golden["expected"]["primal"]["z"], 1e-7);  // the closed form is the likelihood's estimate
}

TEST(Lines, AnInterfaceWithoutRotationsIsTold) {
  IMPEDANCE_CASE(golden, "a1");
  golden::LinesCase given = golden::lines_case(golden["given"]);
  const LineScene scene = golden::scene_of("\"7:+Y\", \"9:+Y\"", "lines = \"symmetric\"");
  const IdentifiedLines found = identify_lines(scene, std::move(given.substructures), std::move(given.assembly));
  EXPECT_FALSE(is_usable(found.status)) << found.message;
}

}  // namespace
}  // namespace jointid::impedance
