#include <fstream>

#include "base/statistics.hpp"
#include "impedance/decouple/decouple.hpp"
#include "problems/lines/line_problem.hpp"
#include "tests/impedance/golden.hpp"

namespace jointid::impedance {
namespace {

/// Errors of all elements over their standard errors: rms, and how many of their parts are within 1.96.
struct Normalised {
  double rms = 0.0, coverage = 0.0;
};

Normalised normalised(const WayResult& way, const std::vector<std::vector<Complex>>& truth, std::size_t stride = 1) {
  Normalised out;
  double count = 0.0;
  for (std::size_t i = 0; i < way.lines.size(); ++i) {
    for (std::size_t t = 0; t < truth[i].size(); ++t) {
      const auto k = static_cast<Eigen::Index>(t);
      const Complex error = way.lines[i]->z(k) - truth[i * stride][t];
      const double re = error.real() / way.lines[i]->re_error(k), im = error.imag() / way.lines[i]->im_error(k);
      out.rms += re * re + im * im;
      out.coverage += (std::abs(re) < normal_95) + (std::abs(im) < normal_95);
      count += 2.0;
    }
  }
  return {std::sqrt(out.rms / count), out.coverage / count};
}

TEST(LineProblems, TheRubberMountsLawIsFound) {
  const problems::LineProblem problem = problems::polluted(problems::make_line_problem("isolator-zener"), 1);
  const LineScene scene = parse_line_scene(problem.scene, "isolator-zener.toml");
  const IdentifiedLines found = identify_lines(scene, problem.substructures, problem.assembly);
  EXPECT_EQ(found.status, Status::ok) << found.message;
  const Normalised errors = normalised(found.ways.front(), problem.truth);
  EXPECT_NEAR(errors.rms, 1.0, 0.25);
  EXPECT_GT(errors.coverage, 0.88);
  EXPECT_EQ(found.laws.front().law, LawKind::fractional_zener);
  const std::vector<double> theta = {3e4, 9e4, 0.00265, 0.6};
  for (std::size_t k = 0; k < theta.size(); ++k) {
    EXPECT_LT(std::abs(found.laws.front().parameters[k].value - theta[k]), 4.0 * found.laws.front().parameters[k].std_error) << k;
  }
}

TEST(LineProblems, AnIsolatorOfSixCoordinates) {
  const problems::LineProblem problem = problems::polluted(problems::make_line_problem("isolator"), 1);
  const LineScene scene =
      parse_line_scene(problem.scene + "\n[frequency]\nrange = [60.0, 1000.0]\nstep = 96.0\n", "isolator.toml");
  const IdentifiedLines found = identify_lines(scene, problem.substructures, problem.assembly);
  const Normalised errors = normalised(found.ways.front(), problem.truth, 4);
  EXPECT_NEAR(errors.rms, 1.0, 0.15);
  EXPECT_NEAR(errors.coverage, 0.95, 0.04);
  EXPECT_NEAR(found.chi_square / found.freedom, 1.0, 0.1);
  EXPECT_EQ(found.laws.front().law, LawKind::fractional_zener);
  const auto& parameters = found.laws.front().parameters;
  ASSERT_EQ(parameters.size(), 24U);  // 21 stiffnesses, then what they share
  EXPECT_LT(std::abs(parameters[21].value - 4.0), 4.0 * parameters[21].std_error);
  EXPECT_LT(std::abs(parameters[23].value - 0.5), 4.0 * parameters[23].std_error);
}

TEST(LineProblems, ABeamDecoupled) {
  const problems::LineProblem problem = problems::polluted(problems::make_line_problem("decoupling-beams"), 1);
  const DecoupleScene scene = parse_decouple_scene(problem.scene, "decoupling-beams.toml");
  const Decoupled found = decouple(scene, problem.substructures, problem.assembly);
  EXPECT_NEAR(found.likelihood.chi_square / found.likelihood.freedom, 1.0, 0.1);
  std::vector<double> of_likelihood, of_standard;
  for (std::size_t i = 0; i < problem.truth.size(); ++i) {
    const Complex truth = problem.truth[i][0];
    of_likelihood.push_back(std::abs(found.ways[0].lines[i]->h(0, 0) - truth) / std::abs(truth));
    of_standard.push_back(std::abs(found.ways[1].lines[i]->h(0, 0) - truth) / std::abs(truth));
  }
  EXPECT_LT(median(of_likelihood), 0.6 * median(of_standard));
}

TEST(LineScenes, MistakesAreRefusedWithTheirPlace) {
  const auto refused = [](const std::string& joint) -> std::string {
    try {
      golden::scene_of("\"1:+Y\", \"2:+Y\"", joint);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refused("lines = \"masless\"").find("massless"), std::string::npos);
  EXPECT_NE(refused("lines = \"symmetric\"\nway = \"primary\"").find("primal"), std::string::npos);
  EXPECT_NE(refused("lines = \"massless\"\nlaw_masses = true").find("law_masses"), std::string::npos);
  EXPECT_NE(refused("lines = \"massless\"\nlaws = [\"zener\", \"zener\"]").find("twice"), std::string::npos);
  EXPECT_NE(refused("lines = { matrix = [[\"a\", 1.0], [1.0, \"a\"]] }").find("known numbers"), std::string::npos);
  EXPECT_NE(refused("lines = { matrix = [[\"a\", \"b\"], [\"c\", \"a\"]] }").find("not symmetric"), std::string::npos);
  EXPECT_NE(refused("lines = \"massless\"\nfacing = [[\"1:+Y\", \"9:+Y\"]]").find("9:+Y"), std::string::npos);
  EXPECT_NE(refused("lines = \"massless\"\nsplines = 12").find("smooth"), std::string::npos);
  EXPECT_NE(refused("lines = \"massless\"\n[identify]\nmethod = \"one\"").find("method"), std::string::npos);
  EXPECT_EQ(refused("lines = { springs = { k1 = [\"1:+Y\", \"2:+Y\"] } }"), "");
}

TEST(LineScenes, ANamedSpringIsTheMasslessJoint) {
  const problems::LineProblem problem = problems::polluted(problems::make_line_problem("isolator-zener"), 2);
  const auto solve = [&](const std::string& lines) {
    return identify_lines(
        parse_line_scene(
            "[data]\nsubstructures = [\"A\", \"B\"]\nassembly = [\"AB\"]\n[joint]\ndofs = [\"2:+Y\", \"3:+Y\"]\nlines = " + lines,
            "s.toml"),
        problem.substructures, problem.assembly);
  };
  const IdentifiedLines named = solve("{ matrix = [[\"a\", \"-a\"], [\"-a\", \"a\"]] }"), massless = solve("\"massless\"");
  EXPECT_EQ(named.ways[0].elements[0].name, "Z.a");
  for (std::size_t i = 0; i < massless.frequency_hz.size(); ++i) {
    EXPECT_LT(std::abs(named.ways[0].lines[i]->z(0) - massless.ways[0].lines[i]->z(0)),
              1e-6 * massless.ways[0].lines[i]->re_error(0));
  }
}

}  // namespace
}  // namespace jointid::impedance
