#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "ident/identify.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/parts/likelihood_by_parts.hpp"
#include "ident/likelihood/parts/parts_covariance.hpp"
#include "ident/plan/coordinates.hpp"
#include "ident/plan/expected_time.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/case/many_joints_problem.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using problems::Problem;

Problem chain(std::size_t joints) {
  return problems::many_joints_problem(problems::chain_of_beams({.joints = joints, .spacing = 1}), {"chain", ""}, false);
}

Scene by_parts(const Problem& problem) {
  Scene scene = problems::scene(problem);
  scene.identify.method = Method::likelihood;
  scene.identify.solver = Solver::by_parts;
  return scene;
}

/// Scaled unknowns of the truth.
std::vector<double> truth(const Problem& problem, const Plan& plan) {
  std::vector<double> out;
  for (std::size_t c = 0; c < plan.columns->size(); ++c) out.push_back(problem.unknowns[c].value / plan.unscale(c));
  return out;
}

/// Half of the Fisher information of a group at one line by the density of its measured FRFs: H free, x(m,l) = [l on s]H − HF at the
/// members' coordinates, motions across joints outside free. Derivatives by central differences, exact for what is bilinear.
MatrixXd information_of_density(const PartGroup& group, const PartGroups& all, const GroupLine& line, const std::vector<double>& theta,
                                double omega0) {
  std::vector<bool> own(group.motions.size(), false);
  for (const GroupMember& member : group.members) {
    for (const std::size_t m : member.motions) own[m] = true;
  }
  std::vector<Index> outside;
  for (std::size_t m = 0; m < own.size(); ++m) {
    if (!own[m]) outside.push_back(at(m));
  }
  const Index references = at(all.references.size()), p = at(theta.size());
  Index h_count = 0;
  for (const MatrixXcd& h : line.measured.parts) h_count += h.size();
  const Index free = at(outside.size()) * references;
  // x of the members' coordinates for given parameters: (S + H Z) x = r
  const auto motions = [&](const Eigen::VectorXcd& parameter) {
    std::vector<double> joint = theta;
    for (Index u = 0; u < p; ++u) joint[std::size_t(u)] += parameter[u].real();
    const GroupImpedance z = group_impedance(group, joint, line.omega, omega0);
    Index next = p;
    MatrixXcd x = line.measured.motion;
    for (const Index m : outside) {
      for (Index l = 0; l < references; ++l) x(m, l) += parameter[next++];
    }
    MatrixXcd g = MatrixXcd::Zero(at(group.rows), at(group.motions.size())), r = MatrixXcd::Zero(at(group.rows), references);
    for (std::size_t s = 0; s < group.members.size(); ++s) {
      const GroupMember& member = group.members[s];
      MatrixXcd h = line.measured.parts[s];
      for (Index i = 0; i < h.size(); ++i) h(i) += parameter[next++];
      for (std::size_t m = 0; m < member.rows.size(); ++m) {
        const Index row = at(member.first_row + m);
        g(row, at(member.motions[m])) += 1.0;
        for (std::size_t a = 0; a < member.forces.size(); ++a) g.row(row) += h(at(m), at(a)) * z.z.row(at(member.forces[a]));
        for (const auto& [l, column] : member.references) r(row, at(l)) += h(at(m), at(column));
      }
    }
    std::vector<Index> inside;
    for (const GroupMember& member : group.members) {
      for (const std::size_t m : member.motions) inside.push_back(at(m));
    }
    const MatrixXcd left = g(Eigen::all, inside);
    const MatrixXcd right = outside.empty() ? r : MatrixXcd(r - g(Eigen::all, outside) * x(outside, Eigen::all));
    x(inside, Eigen::all) = left.fullPivLu().solve(right);
    return x;
  };
  // Rows: errors of x, then of H, over their deviations; columns: parameters (complex, θ real)
  const Index parameters = p + free + h_count, rows = line.measured.motion.size() + h_count;
  MatrixXcd jacobian = MatrixXcd::Zero(rows, parameters);
  for (Index k = 0; k < parameters; ++k) {
    Eigen::VectorXcd step = Eigen::VectorXcd::Zero(parameters);
    double size = 0.0;
    if (k < p) {
      size = 1e-5 * std::abs(theta[std::size_t(k)]);
    } else {
      size = 1e-5 * (k < p + free ? line.measured.motion : line.measured.parts.front()).cwiseAbs().maxCoeff();
    }
    step[k] = size;
    const MatrixXcd slope = (motions(step) - motions(-step)) / (2.0 * size);
    for (Index i = 0; i < slope.size(); ++i) jacobian(i, k) = slope(i) / std::sqrt(line.variance.motion(i));
  }
  Index row = line.measured.motion.size(), column = p + free;
  for (const MatrixXd& variance : line.variance.parts) {
    for (Index i = 0; i < variance.size(); ++i) jacobian(row++, column++) = 1.0 / std::sqrt(variance(i));
  }
  // Complex parameters are free in both parts: project on what they do not reach, then the real part.
  const MatrixXcd nuisance = jacobian.rightCols(parameters - p), wanted = jacobian.leftCols(p);
  const Eigen::VectorXd scale = nuisance.colwise().norm().cwiseInverse();
  const MatrixXcd scaled = nuisance * scale.asDiagonal();
  const MatrixXcd rest = wanted - scaled * scaled.colPivHouseholderQr().solve(wanted);
  return (wanted.adjoint() * rest).real();
}

class GroupsOfThree : public testing::TestWithParam<std::size_t> {};

TEST_P(GroupsOfThree, InformationIsThatOfTheDensityOfTheirFrfs) {
  const Problem problem = chain(2);
  const auto plan = problems::plan(by_parts(problem), {problem.substructures, problem.assembly});
  const PartGroups all = part_groups(*plan, plan->equations, GetParam());
  EXPECT_EQ(all.groups.size(), (3 + GetParam() - 1) / GetParam());
  PartsData data(*plan, all);
  data.read({});
  const std::vector<double> exact = truth(problem, *plan);
  for (std::size_t g = 0; g < all.groups.size(); ++g) {
    const GroupLine& line = data.groups()[g][3];
    std::vector<double> theta;
    for (const std::size_t place : line.columns) theta.push_back(exact[data.columns(g)[place]]);
    const GroupImpedance impedance = group_impedance(all.groups[g], theta, line.omega, plan->omega0);
    const GroupLinearisation found(all.groups[g], all, line, impedance);
    EXPECT_LT(found.cost(), 1e-12);
    const MatrixXd expected = information_of_density(all.groups[g], all, line, theta, plan->omega0);
    const Eigen::VectorXd scale = expected.diagonal().cwiseSqrt().cwiseInverse();
    const MatrixXd off = scale.asDiagonal() * (found.information() - expected) * scale.asDiagonal();
    EXPECT_LT(off.cwiseAbs().maxCoeff(), 1e-5) << g;
  }
}

INSTANTIATE_TEST_SUITE_P(ByParts, GroupsOfThree, testing::Values(1, 2, 3));

TEST(ByParts, ExactFrfsGiveTheTruth) {
  const Problem problem = chain(3);
  const auto plan = problems::plan(by_parts(problem), {problem.substructures, problem.assembly});
  EXPECT_THAT(plan->notes, testing::Contains(testing::HasSubstr("goes by parts")));
  const Solution found = solve(*plan);
  ASSERT_EQ(found.status, Status::ok) << found.message;
  EXPECT_EQ(found.used.solver, "by-parts");
  for (std::size_t u = 0; u < problem.unknowns.size(); ++u)
    EXPECT_NEAR(found.unknowns[u].value / problem.unknowns[u].value, 1.0, 1e-6) << problem.unknowns[u].name;
}

/// Of 30 unknowns and their errors: normalised errors of size 1, χ² as it should be, and intervals of the sandwich.
TEST(ByParts, NoisyFrfsGiveEstimatesAsGoodAsTheirErrors) {
  const Problem problem = chain(5);
  const auto plan = problems::plan(by_parts(problem), problems::polluted(problem, 3, 0));
  Control control;
  control.judgement = Judgement::fit;
  const Solution found = solve(*plan, control);
  ASSERT_EQ(found.status, Status::ok) << found.message;
  EXPECT_EQ(found.intervals, IntervalKind::sandwich);
  double squares = 0.0;
  for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
    const double z = (found.unknowns[u].value - problem.unknowns[u].value) / found.unknowns[u].std_error.value();
    EXPECT_LT(std::abs(z), 4.0) << problem.unknowns[u].name;
    squares += z * z;
  }
  EXPECT_GT(squares, 0.3 * static_cast<double>(problem.unknowns.size()));
  EXPECT_LT(squares, 2.2 * static_cast<double>(problem.unknowns.size()));
  const ChiSquare& chi_square = found.fit.chi_square.value();
  EXPECT_NEAR(chi_square.value / chi_square.degrees_of_freedom, 1.0, 0.15);
  ASSERT_FALSE(found.parts.empty());
  for (const PartMisfit& part : found.parts) EXPECT_NEAR(part.chi_square / part.degrees_of_freedom, 1.0, 0.35) << part.files;
  EXPECT_TRUE(found.fit.asm_frf_error);
}

/// A condition whose FRFs are not all there is left out, and nothing else changes.
TEST(ByParts, FrfsThatAreMissingLeaveTheRest) {
  const Problem problem = chain(3);
  problems::Measurement data{problem.substructures, problem.assembly};
  data.assembly.values[data.assembly.index(2, 1, 0)] = Complex(std::nan(""), std::nan(""));
  data.substructures[1].values[data.substructures[1].index(4, 2, 1)] = Complex(std::nan(""), std::nan(""));
  const auto plan = problems::plan(by_parts(problem), std::move(data));
  const Solution found = solve(*plan);
  const auto whole = problems::plan(by_parts(problem), {problem.substructures, problem.assembly});
  EXPECT_LT(found.fit.equations_used, solve(*whole).fit.equations_used);
  for (std::size_t u = 0; u < problem.unknowns.size(); ++u)
    EXPECT_NEAR(found.unknowns[u].value / problem.unknowns[u].value, 1.0, 1e-6) << problem.unknowns[u].name;
}

TEST(ByParts, WhatDoesNotGoWithItIsRefused) {
  const Problem problem = chain(3);
  Scene scene = by_parts(problem);
  scene.identify.bootstrap = 10;
  const auto message = [&](problems::Measurement data) -> std::string {
    try {
      problems::plan(scene, std::move(data));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message({problem.substructures, problem.assembly}), testing::HasSubstr("does not go with a bootstrap"));
  scene.identify.bootstrap = 0;
  const frf::FrfSet blind = problems::without(problem.assembly, {problem.joint_dofs.front()});
  EXPECT_THAT(message({problem.substructures, blind}), testing::HasSubstr("motion at all joint coordinates"));
}

/// Two of ten joints lack a half and a third of their stiffness: named first, and surely; the others are sound.
TEST(ByParts, LooseJointsAreNamedFirst) {
  const Problem problem = problems::loose_joints_problem(problems::chain_of_beams({.joints = 10}), {{3, 0.5}, {7, 0.33}}, {"loose", ""});
  const auto plan = problems::plan(problems::scene(problem), problems::polluted(problem, 1, 0));
  ASSERT_EQ(name(plan->solver), "by-parts");
  const Solution found = solve(*plan);
  ASSERT_EQ(found.loose.size(), 10u) << found.message;
  EXPECT_EQ(found.loose[0].joint, "j4");
  EXPECT_EQ(found.loose[1].joint, "j8");
  for (std::size_t k = 0; k < 10; ++k) {
    const LooseJoint& each = found.loose[k];
    EXPECT_EQ(each.probability > 0.95, k < 2) << each.joint << " " << each.probability;
    const double lost = each.joint == "j4" ? 0.5 : each.joint == "j8" ? 0.33 : 0.0;
    EXPECT_NEAR(each.lost, lost, 4.5 * each.std_error.value()) << each.joint;
    EXPECT_LT(*each.std_error, 0.05);
  }
}

/// Where the scene names no solver: from 150 unknowns on.
TEST(ByParts, AreChosenForManyJoints) {
  for (const std::size_t joints : {std::size_t{24}, std::size_t{25}}) {
    const Problem problem = chain(joints);
    Scene scene = problems::scene(problem);
    scene.identify.method = Method::likelihood;
    const auto plan = problems::plan(scene, {problem.substructures, problem.assembly});
    EXPECT_EQ(name(plan->solver), joints == 25 ? "by-parts" : "gauss-helmert");
  }
}

Problem star(std::size_t joints) {
  return problems::many_joints_problem(problems::star_of_beams({.joints = joints}), {"star", ""}, false);
}

/// One part with all joints has the FRFs of all of them in its covariance: the whole likelihood is the shorter one there.
TEST(ByParts, AreNotChosenWhereOnePartCarriesTheJoints) {
  for (const std::size_t joints : {std::size_t{24}, std::size_t{26}}) {
    const Problem problem = star(joints);
    Scene scene = problems::scene(problem);
    scene.identify.method = Method::likelihood;
    const problems::Measurement data{problem.substructures, problem.assembly};
    const auto chosen = problems::plan(scene, data);
    EXPECT_EQ(name(chosen->solver), "gauss-helmert") << joints;
    scene.identify.solver = Solver::by_parts;
    const auto parts = problems::plan(scene, data);
    EXPECT_EQ(name(parts->solver), "by-parts") << joints;
    EXPECT_LT(expected_seconds(chosen->cost, 1), expected_seconds(parts->cost, 1)) << joints;
    if (joints < 25) continue;
    EXPECT_THAT(chosen->notes, testing::Contains(testing::HasSubstr("one substructure carries 156 of 156 unknowns")));
  }
}

/// Nor do they give the start of the whole likelihood there: rows do.
TEST(ByParts, GiveNoStartThatTakesLongerThanAMinute) {
  const std::vector<std::pair<Problem, bool>> all = {{chain(24), false}, {chain(26), false}, {star(24), true}, {star(26), true}};
  for (const auto& [problem, is_star] : all) {
    Scene scene = problems::scene(problem);
    scene.identify.method = Method::likelihood;
    scene.identify.solver = Solver::gauss_helmert;
    const auto plan = problems::plan(scene, {problem.substructures, problem.assembly});
    EXPECT_EQ(likelihood_plan(*plan)->start->scene.identify.method, is_star ? Method::one : Method::likelihood)
        << is_star << ' ' << problem.unknowns.size();
  }
}

/// With fewer unknowns where the whole likelihood would take too long, of more than eight substructures.
TEST(ByParts, AreChosenInPlaceOfAnHour) {
  Cost quick, slow;
  quick.lines = slow.lines = 16;
  quick.iteration = {.expected = 8, .flops = 1e6, .matrix = 100};
  slow.iteration = {.expected = 8, .flops = 1e13, .matrix = 1000};
  for (const std::size_t joints : {std::size_t{4}, std::size_t{9}}) {
    const Problem problem = chain(joints);
    Scene scene = problems::scene(problem);
    scene.identify.method = Method::likelihood;
    const auto plan = problems::plan(scene, {problem.substructures, problem.assembly});
    EXPECT_FALSE(is_better_by_parts(*plan, quick));
    EXPECT_EQ(is_better_by_parts(*plan, slow), joints == 9);
  }
}

/// The whole likelihood of an assembly that was not excited at its joints starts from the likelihood by parts, whatever its size.
TEST(ByParts, AreTheStartOfTheWholeLikelihood) {
  const Problem problem = chain(4);
  Scene scene = problems::scene(problem);
  scene.identify.method = Method::likelihood;
  scene.identify.solver = Solver::gauss_helmert;
  const auto plan = problems::plan(scene, problems::polluted(problem, 1, 0));
  Control control;
  control.detail = Detail::estimates;
  control.judgement = Judgement::none;
  const Solution found = solve(*plan, control);
  ASSERT_EQ(found.status, Status::ok) << found.message;
  const ChiSquare& chi_square = found.fit.chi_square.value();
  EXPECT_NEAR(chi_square.value / chi_square.degrees_of_freedom, 1.0, 0.2);
  for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
    const Estimate& estimate = found.unknowns[u];
    EXPECT_LT(std::abs(estimate.value - problem.unknowns[u].value), 4.5 * estimate.std_error.value()) << estimate.name;
  }
}

}  // namespace
}  // namespace jointid::ident
