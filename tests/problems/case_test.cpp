#include "problems/case/case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <set>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "by_case.hpp"
#include "dense/lu.hpp"
#include "problems/case/catalogue.hpp"
#include "problems/case/thesis_beams.hpp"
#include "problems/problem.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::problems {
namespace {

class EveryCase : public ByCase {};

Eigen::MatrixXcd joint_impedance(const Case& definition, double frequency_hz) {
  const double omega = 2.0 * std::numbers::pi * frequency_hz;
  const Complex s(definition.window_rate, omega);
  const std::size_t n = definition.joint_dofs.size();
  Eigen::MatrixXcd z = Eigen::MatrixXcd::Zero(at(n), at(n));
  for (const JointMatrix& matrix : definition.joint) {
    const Complex unit = matrix.kind == Kind::stiffness         ? Complex(1.0)
                         : matrix.kind == Kind::mass            ? s * s
                         : matrix.kind == Kind::viscous_damping ? s
                                                                : Complex(0.0, 1.0);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) z(at(i), at(j)) += unit * matrix.truth[i][j];
    }
  }
  return z;
}

/// One line of the FRF sets over `dofs`; FRFs between two sets are zero.
Eigen::MatrixXcd line_of(const std::vector<frf::FrfSet>& sets, const std::vector<frf::Dof>& dofs,
                         std::size_t line) {
  Eigen::MatrixXcd h = Eigen::MatrixXcd::Zero(at(dofs.size()), at(dofs.size()));
  for (const frf::FrfSet& set : sets) {
    for (std::size_t i = 0; i < dofs.size(); ++i) {
      for (std::size_t j = 0; j < dofs.size(); ++j) {
        const std::size_t r = frf::find_coordinate(set.header.response, dofs[i]);
        const std::size_t c = frf::find_coordinate(set.header.reference, dofs[j]);
        if (r != frf::npos && c != frf::npos) h(at(i), at(j)) = set.values[set.index(line, r, c)];
      }
    }
  }
  return h;
}

/// Coupling by the joint: H_asm = H_sub − H_sj (I + Z_j H_jj)⁻¹ Z_j H_js (docs/formulas.md §2, 6.12) over all
/// measured DOFs. The substructure files alone, the truth alone and the assembly file have to agree.
TEST_P(EveryCase, AssemblyIsTheSubstructuresCoupledByTheTrueJoint) {
  Case definition = definition_;
  definition.accelerometer_mass = 0.0;  // it loads parts and assembly differently, on purpose
  if (definition.name == "G4" || definition.name == "G5") {
    // Its parts are coupled by a rigid, its assembly by a very hard rotary spring: only similar.
    definition.assembly = assembled(definition.substructures, definition.joint_dofs, definition.joint);
  }
  const Problem problem = build(definition);
  const std::vector<frf::Dof>& dofs = problem.assembly.header.response;
  std::vector<frf::Dof> all = dofs;
  for (const frf::Dof& dof : problem.joint_dofs) {
    if (frf::find_coordinate(all, dof) == frf::npos) all.push_back(dof);
  }
  for (std::size_t line = 0; line < problem.assembly.header.lines(); line += 7) {
    const Eigen::MatrixXcd z = joint_impedance(definition, problem.assembly.header.frequency_hz[line]);
    const Eigen::MatrixXcd h = line_of(problem.substructures, all, line);
    Eigen::MatrixXcd to_joint(h.rows(), z.rows());
    for (std::size_t j = 0; j < problem.joint_dofs.size(); ++j) {
      to_joint.col(at(j)) = h.col(at(frf::find_coordinate(all, problem.joint_dofs[j])));
    }
    Eigen::MatrixXcd hjj(z.rows(), z.rows());
    for (std::size_t j = 0; j < problem.joint_dofs.size(); ++j) {
      hjj.row(at(j)) = to_joint.row(at(frf::find_coordinate(all, problem.joint_dofs[j])));
    }
    const Eigen::MatrixXcd identity = Eigen::MatrixXcd::Identity(z.rows(), z.rows());
    const Eigen::MatrixXcd coupled =
        h - to_joint * dense::solve(identity + z * hjj, z) * to_joint.transpose();
    const Eigen::MatrixXcd expected = line_of({problem.assembly}, dofs, line);
    const auto n = at(dofs.size());
    EXPECT_LE((coupled.topLeftCorner(n, n) - expected).cwiseAbs().maxCoeff(),
              1e-8 * expected.cwiseAbs().maxCoeff());
  }
}

TEST_P(EveryCase, FrfSetsHaveTheirSizesAndTheSceneNamesThem) {
  const Problem problem = build(definition_);
  std::vector<frf::FrfSet> sets = problem.substructures;
  sets.push_back(problem.assembly);
  for (const frf::FrfSet& set : sets) {
    EXPECT_NO_THROW(frf::validate(set.header));
    EXPECT_EQ(set.values.size(), set.header.lines() * set.header.entries());
    EXPECT_EQ(set.header.frequency_hz, frequencies(definition_.axis));
    EXPECT_THAT(problem.scene, testing::HasSubstr("\"" + set.header.file + "\""));
    EXPECT_FALSE(set.header.nodes.empty());
  }
  for (const frf::Dof& dof : problem.joint_dofs) {
    EXPECT_THAT(problem.scene, testing::HasSubstr("\"" + dof.name() + "\""));
  }
}

TEST_P(EveryCase, NoiseChangesEverySetAndRepeats) {
  const Problem problem = build(definition_);
  const Measurement first = polluted(problem, 1, 0);
  const Measurement again = polluted(problem, 1, 0);
  ASSERT_EQ(first.substructures.size(), problem.substructures.size());
  EXPECT_EQ(first.assembly.values, again.assembly.values);
  EXPECT_NE(first.assembly.values, problem.assembly.values);
  EXPECT_NE(first.assembly.values, polluted(problem, 1, 1).assembly.values);
  for (std::size_t i = 0; i < problem.substructures.size(); ++i) {
    EXPECT_NE(first.substructures[i].values, problem.substructures[i].values);
    EXPECT_EQ(first.substructures[i].header.response, problem.substructures[i].header.response);
  }
}

TEST_P(EveryCase, TheTruthIsSymmetricOverTheJointDofs) {
  for (const JointMatrix& matrix : definition_.joint) {
    ASSERT_EQ(matrix.truth.size(), definition_.joint_dofs.size());
    for (std::size_t i = 0; i < matrix.truth.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) EXPECT_EQ(matrix.truth[i][j], matrix.truth[j][i]);
    }
  }
}

/// The unknowns that the scene declares are those of the problem, and their exact values give the true
/// matrices.
TEST_P(EveryCase, ExactUnknownsGiveTheTruth) {
  const Problem problem = build(definition_);
  restrictions::JointSpec spec;
  spec.dofs = problem.joint_dofs;
  for (const JointMatrix& matrix : definition_.joint) spec.matrices[matrix.kind] = matrix.spec;
  const restrictions::Restriction restriction = restrictions::build({spec});
  ASSERT_EQ(restriction.unknowns.size(), problem.unknowns.size());
  std::vector<double> exact;
  for (std::size_t i = 0; i < problem.unknowns.size(); ++i) {
    EXPECT_EQ(restriction.unknowns[i].name, problem.unknowns[i].name);
    exact.push_back(problem.unknowns[i].value);
  }
  for (const auto& [kind, truth] : problem.truth) {
    const std::vector<double> matrix = restriction.matrix(kind, exact);
    const std::size_t n = truth.size();
    for (std::size_t i = 0; i < n * n; ++i) {
      const double expected = truth[i / n][i % n];
      EXPECT_NEAR(matrix[i], expected, 1e-12 * std::abs(expected)) << restrictions::key(kind) << ' ' << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, EveryCase, testing::ValuesIn(ByCase::all()), ByCase::name_of);

TEST(Catalogue, HasEveryCaseOnce) {
  std::set<std::string> names;
  for (const ProblemInfo& info : list()) EXPECT_TRUE(names.insert(info.name).second) << info.name;
  for (const char* name : {"A1", "A11", "B", "C1", "C2", "D3", "E3", "F3", "G5", "H3", "rig1"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(Catalogue, AnUnknownNameSuggestsTheNearest) {
  try {
    make("rig3");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean rig"));
  }
}

TEST(Catalogue, CoordinatesAreNumberedAsInTheThesis) {
  EXPECT_EQ(coordinates({7, 8})[0].name(), "4:+Y");
  EXPECT_EQ(coordinates({7, 8})[1].name(), "4:+RZ");
}

TEST(Catalogue, TheStartOfTable621IsAsPrinted) {
  const Problem h4 = make("H4");
  const BeamSection start = {.width = 0.07, .thickness = 0.015, .youngs_modulus = 2.07e11, .density = 7547.0};
  const Matrix k = element_stiffness(start, 0.25);
  EXPECT_NEAR(k[0][0] / joint_stiffness()[0][0], 4.73, 0.01);
  EXPECT_NEAR(k[0][1] / joint_stiffness()[0][1], 3.94, 0.01);
  EXPECT_NEAR(k[1][1] / joint_stiffness()[1][1], 3.28, 0.01);
  EXPECT_THAT(h4.scene, testing::HasSubstr("start = { stiffness = [["));
}

}  // namespace
}  // namespace jointid::problems
