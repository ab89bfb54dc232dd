#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ident/identify.hpp"
#include "plain_estimate.hpp"

namespace jointid::ident {
namespace {

using restrictions::EntryMatrix;
using restrictions::Kind;
using restrictions::Pattern;

std::vector<double> seven_lines() { return {10.0, 25.0, 31.0, 44.0, 52.0, 75.0, 90.0}; }

/// Two substructures and an assembly without any physical sense. Non-square data: more responses than references, joint
/// coordinates in both roles.
MemoryScene random_system(unsigned seed) {
  std::mt19937_64 random(seed);
  const Dofs a_responses = dofs({"1:+Y", "2:+Y", "3:+X", "4:+Y", "4:+RZ"}), a_references = dofs({"4:+RZ", "1:+Y", "4:+Y"});
  const Dofs b_responses = dofs({"5:+RZ", "6:+Y", "5:+Y"}), b_references = dofs({"5:+Y", "6:+Y", "5:+RZ", "7:+Y"});
  MemoryScene system;
  system.substructures = {random_set("a", seven_lines(), a_responses, a_references, 1e-6, random),
                          random_set("b", seven_lines(), b_responses, b_references, 1e-6, random)};
  system.assembly = {random_set("assembly", seven_lines(), joined(a_responses, b_responses),
                                joined(a_references, b_references), 1e-6, random)};
  restrictions::JointSpec joint = joint_of(dofs({"4:+Y", "4:+RZ", "5:+Y", "5:+RZ"}), Kind::stiffness, Pattern::symmetric);
  joint.matrices[Kind::mass] = EntryMatrix{
      {"a", "b", 0.0, 0.0}, {"b", "c", 0.0, 1e-2}, {0.0, 0.0, "a+2*c", "-b"}, {0.0, 1e-2, "-b", 3.0}};
  joint.matrices[Kind::viscous_damping] =
      std::vector<restrictions::Spring>{{joint.dofs[0], joint.dofs[2]}, {joint.dofs[1], joint.dofs[3]}};
  joint.matrices[Kind::hysteretic_damping] = Pattern::diagonal;
  system.scene.joints = {joint};
  return system;
}

/// Errors are held against the largest unknown of the same kind.
void expect_plain(const Plan& plan, const Solution& solution, const PlainEstimate& plain, double tolerance = 1e-10) {
  const std::vector<double> expected = plain.solve();
  EXPECT_EQ(solution.status, Status::ok) << solution.message;
  EXPECT_EQ(solution.fit.equations_used, plain.used());
  EXPECT_EQ(solution.fit.equations_dropped, plain.dropped());
  ASSERT_EQ(solution.unknowns.size(), expected.size());
  std::map<Kind, double> largest;
  const auto& unknowns = plan.restriction.unknowns;
  for (std::size_t u = 0; u < expected.size(); ++u) {
    largest[unknowns[u].kind] = std::max(largest[unknowns[u].kind], std::abs(expected[u]));
  }
  for (std::size_t u = 0; u < expected.size(); ++u) {
    EXPECT_LE(std::abs(solution.unknowns[u].value - expected[u]), tolerance * largest[unknowns[u].kind])
        << solution.unknowns[u].name;
  }
}

/// Solves with every weighting and two Δ and compares with the plain route.
void expect_plain_for_all(MemoryScene& system, const std::vector<std::vector<Equation>>& equations) {
  for (const std::vector<Equation>& subset : equations) {
    for (const weighting::Weighting weighting : all_weightings) {
      for (const double delta : {0.0, 1.1}) {
        SCOPED_TRACE((subset.empty() ? "all" : name(subset[0])) + " " + weighting::name(weighting) + " " +
                     std::to_string(delta));
        system.scene.identify.equations = subset;
        system.scene.identify.weighting = weighting;
        system.scene.identify.delta = delta;
        const auto plan = system.plan();
        const Solution solution = solve(*plan);
        const PlainEstimate plain(*plan, system.substructures, system.assembly);
        expect_plain(*plan, solution, plain);
        if (delta > 0.0) {
          EXPECT_GT(plain.dropped(), 0u);
        }
      }
    }
  }
}

const std::vector<std::vector<Equation>> some_subsets = {
    {}, {Equation::nn}, {Equation::nn, Equation::nj}, {Equation::nj, Equation::jn}, {Equation::nn, Equation::jj}, {Equation::jn}};

void set_nan(frf::FrfSet& set, std::size_t line, std::size_t r, std::size_t c) {
  set.values[set.index(line, r, c)] = std::numeric_limits<double>::quiet_NaN();
}

TEST(LeastSquares, EqualsStackedEquationsOfNonSquareData) {
  for (const unsigned seed : {1u, 2u}) {
    MemoryScene system = random_system(seed);
    expect_plain_for_all(system, some_subsets);
  }
}

TEST(LeastSquares, EqualsStackedEquationsWithMissingFrfs) {
  MemoryScene system = random_system(3);
  set_nan(system.assembly[0], 0, 0, 1);       // one right-hand side
  set_nan(system.assembly[0], 1, 2, 0);       // in A: a whole row of equations
  set_nan(system.substructures[0], 2, 3, 1);  // in B: a whole column
  set_nan(system.substructures[1], 3, 1, 0);
  for (std::size_t c = 0; c < 7; ++c) set_nan(system.assembly[0], 4, 1, c);
  for (std::size_t r = 0; r < 8; ++r) set_nan(system.assembly[0], 5, r, 2);
  system.assembly[0].values[system.assembly[0].index(6, 0, 0)] = std::numeric_limits<double>::infinity();
  expect_plain_for_all(system, some_subsets);
}

TEST(LeastSquares, EqualsStackedEquationsWithFlippedAndPermutedDofs) {
  MemoryScene system = random_system(4);
  const Dofs flipped = dofs({"5:-Y", "4:+RZ", "2:-Y", "1:+Y", "5:+RZ", "6:-Y", "4:-Y"});
  system.assembly[0] = part_of(system.assembly[0], flipped, dofs({"7:-Y", "4:+Y", "1:-Y", "5:+RZ", "4:-RZ", "5:+Y"}));
  system.scene.joints[0].dofs = dofs({"5:-RZ", "4:+Y", "4:-RZ", "5:+Y"});
  system.scene.joints[0].matrices.erase(Kind::viscous_damping);
  expect_plain_for_all(system, {{}, {Equation::nn, Equation::nj}});
}

TEST(LeastSquares, OneFileOfBothSubstructuresGivesTheSameAsTwo) {
  MemoryScene two = random_system(5);
  const Dofs responses = joined(two.substructures[0].header.response, two.substructures[1].header.response);
  const Dofs references = joined(two.substructures[0].header.reference, two.substructures[1].header.reference);
  MemoryScene one = two;
  one.substructures.resize(1);
  one.substructures[0].header.response = responses;
  one.substructures[0].header.reference = references;
  one.substructures[0].values.clear();
  for (std::size_t line = 0; line < seven_lines().size(); ++line) {
    for (const frf::Dof& r : responses) {
      for (const frf::Dof& c : references) {
        one.substructures[0].values.push_back(frf_at(two.substructures, line, r, c, 0.0));
      }
    }
  }
  for (const weighting::Weighting weighting : all_weightings) {
    one.scene.identify.weighting = two.scene.identify.weighting = weighting;
    one.scene.identify.delta = two.scene.identify.delta = 0.9;
    const auto plan_one = one.plan();
    const auto plan_two = two.plan();
    expect_plain(*plan_two, solve(*plan_two), PlainEstimate(*plan_one, one.substructures, one.assembly));
    expect_plain(*plan_one, solve(*plan_one), PlainEstimate(*plan_two, two.substructures, two.assembly));
  }
}

TEST(LeastSquares, AnAssemblyInSeveralFilesIsOneMatrix) {
  MemoryScene system = random_system(6);
  const frf::FrfSet whole = system.assembly[0];
  const Dofs references = whole.header.reference;
  const Dofs first(references.begin(), references.begin() + 3), rest(references.begin() + 3, references.end());
  system.assembly = {part_of(whole, whole.header.response, first), part_of(whole, whole.header.response, rest)};
  expect_plain_for_all(system, {{}});
}

TEST(LeastSquares, ReciprocityOnRequestFillsWhatIsMissing) {
  MemoryScene system = random_system(7);
  // H_bb(4:+Y, 4:+RZ) lacks in the file; its transpose is there.
  set_nan(system.substructures[0], 0, 3, 0);
  const auto without = system.plan();
  const std::size_t used_without = solve(*without).fit.equations_used;
  system.scene.data.reciprocity = true;
  const auto with = system.plan();
  const Solution solution = solve(*with);
  EXPECT_GT(solution.fit.equations_used, used_without);
  // The plain route gets the transposes written out.
  const auto both_roles = [](const frf::FrfSet& set) {
    Dofs all = set.header.response;
    for (const frf::Dof& dof : set.header.reference) {
      if (frf::find_coordinate(all, dof) == frf::npos) all.push_back(dof);
    }
    frf::FrfSet full = set;
    full.header.response = full.header.reference = all;
    full.values.clear();
    for (std::size_t line = 0; line < set.header.lines(); ++line) {
      for (const frf::Dof& r : all) {
        for (const frf::Dof& c : all) {
          const Complex here = frf_at({set}, line, r, c);
          full.values.push_back(std::isnan(here.real()) ? frf_at({set}, line, c, r) : here);
        }
      }
    }
    return full;
  };
  const std::vector<frf::FrfSet> sub = {both_roles(system.substructures[0]), both_roles(system.substructures[1])};
  const std::vector<frf::FrfSet> assembly = {both_roles(system.assembly[0])};
  expect_plain(*with, solution, PlainEstimate(*with, sub, assembly));
}

TEST(LeastSquares, RescaledLinesLeaveWbAloneAndRescaledRowsWbs) {
  const MemoryScene original = random_system(8);
  const auto estimate = [](MemoryScene system, weighting::Weighting weighting) {
    system.scene.identify.weighting = weighting;
    system.scene.identify.equations = {Equation::nn, Equation::nj};
    const auto plan = system.plan();
    return solve(*plan);
  };
  // nn and nj are linear in the rows of [H_nj H_nn] with H_aa and H_ab scaled alike.
  const auto scale_row = [](MemoryScene system, std::size_t line, const std::string& row, double factor) {
    const frf::Dof dof = frf::Dof::parse(row);
    for (auto* sets : {&system.substructures, &system.assembly}) {
      for (frf::FrfSet& set : *sets) {
        const std::size_t r = frf::find_coordinate(set.header.response, dof);
        for (std::size_t c = 0; r != frf::npos && c < set.header.reference.size(); ++c) {
          set.values[set.index(line, r, c)] *= factor;
        }
      }
    }
    return system;
  };
  MemoryScene one_row = scale_row(original, 2, "2:+Y", 1e3);
  MemoryScene whole_line = original;
  for (const char* row : {"1:+Y", "2:+Y", "3:+X", "6:+Y"}) whole_line = scale_row(whole_line, 4, row, 1e-3);
  const auto change = [&](const MemoryScene& scaled, weighting::Weighting weighting) {
    const Solution one = estimate(original, weighting), two = estimate(scaled, weighting);
    double largest = 0.0;
    for (std::size_t u = 0; u < 10; ++u) {
      const double size = std::max(std::abs(one.unknowns[u].value), std::abs(two.unknowns[u].value));
      largest = std::max(largest, std::abs(one.unknowns[u].value - two.unknowns[u].value) / size);
    }
    return largest;
  };
  using weighting::Weighting;
  for (const Weighting alone : {Weighting::wbg, Weighting::wbs}) EXPECT_LE(change(one_row, alone), 1e-10);
  for (const Weighting alone : {Weighting::wa, Weighting::wb, Weighting::wbg, Weighting::wbs}) {
    EXPECT_LE(change(whole_line, alone), 1e-10) << weighting::name(alone);
  }
  EXPECT_GT(change(one_row, Weighting::wb), 1e-3);
  EXPECT_GT(change(whole_line, Weighting::none), 1e-3);
}

}  // namespace
}  // namespace jointid::ident
