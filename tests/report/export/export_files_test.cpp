// A joint as cards of other programs: read back by readers of their own and assembled, it gives the same assembly FRFs.
#include "report/export/export_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>
#include <set>

#include "base/error.hpp"
#include "card_readers.hpp"

namespace jointid::report {
namespace {

using restrictions::Kind;
using testing::HasSubstr;
using Complex = std::complex<double>;

std::string text_of(const std::vector<ExportFile>& files, const std::string& suffix) {
  for (const ExportFile& file : files) {
    if (file.suffix == suffix) return file.text;
  }
  return "";
}

/// Draws joints.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  std::vector<frf::Dof> dofs(int nodes) {
    std::vector<frf::Dof> out;
    std::set<int> numbers;
    while (static_cast<int>(numbers.size()) < nodes) numbers.insert(whole(1, 99999999));
    const int count = whole(1, 6);
    for (const int node : numbers) {
      for (int direction = 1; direction <= count; ++direction) out.push_back({node, static_cast<frf::Direction>(direction), +1});
    }
    return out;
  }

  /// Size by kind: at some 1 kHz all matter.
  double size(Kind kind) {
    const double by_kind = kind == Kind::stiffness ? 1e6 : kind == Kind::mass ? 0.3 : kind == Kind::viscous_damping ? 40.0 : 2e4;
    return by_kind * std::pow(10.0, uniform(-1.0, 1.0));
  }

  ident::Matrix matrix(Kind kind, std::size_t n, bool symmetric) {
    ident::Matrix out(n, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        out[i][j] = symmetric && j < i ? out[j][i] : (uniform(0.0, 1.0) < 0.3 ? 0.0 : uniform(-1.0, 1.0) * size(kind));
    }
    return out;
  }

  tasks::ExportedJoint full(bool symmetric) {
    tasks::ExportedJoint joint{.source = "joint.toml",
                               .status = "ok",
                               .dofs = dofs(whole(1, 4)),
                               .matrices = {},
                               .errors = {},
                               .unknowns = {},
                               .covariance = {}};
    for (const Kind kind : restrictions::all_kinds) joint.matrices[kind] = matrix(kind, joint.dofs.size(), symmetric);
    joint.errors = joint.matrices;
    joint.matrices[Kind::stiffness][0][0] = 1.234567e6;
    return joint;
  }

  /// Springs, dampers and lossy springs between two or three nodes, along their directions, and some to the ground.
  tasks::ExportedJoint springs() {
    tasks::ExportedJoint joint{.source = "joint.toml",
                               .status = "ok",
                               .dofs = dofs(whole(2, 3)),
                               .matrices = {},
                               .errors = {},
                               .unknowns = {},
                               .covariance = {}};
    const std::size_t n = joint.dofs.size();
    for (const Kind kind : {Kind::stiffness, Kind::viscous_damping, Kind::hysteretic_damping}) {
      ident::Matrix& x = joint.matrices[kind];
      x.assign(n, std::vector<double>(n, 0.0));
    }
    const auto add = [&](Kind kind, std::size_t i, std::size_t j, double value) {
      ident::Matrix& x = joint.matrices[kind];
      x[i][i] += value;
      if (i == j) return;
      x[j][j] += value;
      x[i][j] -= value;
      x[j][i] -= value;
    };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i; j < n; ++j) {
        if (joint.dofs[i].direction != joint.dofs[j].direction || (i == j && uniform(0.0, 1.0) < 0.8)) continue;
        add(Kind::stiffness, i, j, size(Kind::stiffness));
        if (uniform(0.0, 1.0) < 0.5) add(Kind::viscous_damping, i, j, size(Kind::viscous_damping));
        if (uniform(0.0, 1.0) < 0.5) add(Kind::hysteretic_damping, i, j, size(Kind::hysteretic_damping));
      }
    }
    joint.errors = joint.matrices;
    return joint;
  }

  /// FRFs of parts at the joint's DOFs: a damped structure of some more coordinates.
  Eigen::MatrixXcd receptance(std::size_t n, double omega) {
    const auto size = static_cast<Eigen::Index>(n + 4);
    Eigen::MatrixXd a(size, size);
    for (Eigen::Index i = 0; i < a.size(); ++i) a.data()[i] = uniform(-1.0, 1.0);
    Eigen::MatrixXcd z = (1e6 * Complex(1.0, 0.02)) * (a * a.transpose()).cast<Complex>();
    z.diagonal().array() -= omega * omega * uniform(0.1, 1.0);
    return z.inverse().topLeftCorner(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  }

 private:
  std::mt19937 random_;
};

cards::Assembled truth_of(const tasks::ExportedJoint& joint) {
  const std::size_t n = joint.dofs.size();
  cards::Assembled out(n);
  for (const auto& [kind, to] : {std::pair{Kind::stiffness, &out.k}, std::pair{Kind::mass, &out.m},
                                 std::pair{Kind::viscous_damping, &out.c}, std::pair{Kind::hysteretic_damping, &out.d}}) {
    if (!joint.matrices.contains(kind)) continue;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        (*to)(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = joint.matrices.at(kind)[i][j];
    }
  }
  return out;
}

/// Largest difference of the FRFs of assemblies by either joint, over the largest FRF.
double difference(Draw& draw, const cards::Assembled& truth, const cards::Assembled& read) {
  double worst = 0.0;
  for (const double hz : {35.0, 410.0, 1900.0}) {
    const double omega = 2.0 * std::numbers::pi * hz;
    const Eigen::MatrixXcd h = draw.receptance(static_cast<std::size_t>(truth.k.rows()), omega),
                           one = Eigen::MatrixXcd::Identity(h.rows(), h.rows());
    const Eigen::MatrixXcd a = (one + h * truth.impedance(omega)).inverse() * h,
                           b = (one + h * read.impedance(omega)).inverse() * h;
    worst = std::max(worst, (a - b).cwiseAbs().maxCoeff() / a.cwiseAbs().maxCoeff());
  }
  return worst;
}

cards::Assembled read_back(const tasks::ExportedJoint& joint, ExportTarget target, ExportWay way) {
  const std::vector<ExportFile> files =
      export_files(joint, {.target = target, .way = way, .millimetres = false, .first_id = 900001});
  if (target == ExportTarget::nastran) return cards::read_nastran(text_of(files, ".bdf"), joint.dofs);
  if (target == ExportTarget::ansys) return cards::read_ansys(text_of(files, ".inp"), joint.dofs);
  if (target == ExportTarget::abaqus) return cards::read_abaqus(text_of(files, ".inp"), joint.dofs);
  cards::Assembled out(joint.dofs.size());
  for (const auto& [suffix, to] :
       {std::pair{"_K.mtx", &out.k}, std::pair{"_M.mtx", &out.m}, std::pair{"_C.mtx", &out.c}, std::pair{"_D.mtx", &out.d}}) {
    const std::string text = text_of(files, suffix);
    if (!text.empty()) *to = cards::read_market(text);
  }
  return out;
}

TEST(Export, MatricesReadBackGiveTheSameAssembly) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Draw draw(seed);
    const tasks::ExportedJoint joint = draw.full(true);
    for (const ExportTarget target :
         {ExportTarget::nastran, ExportTarget::ansys, ExportTarget::abaqus, ExportTarget::matrix_market})
      EXPECT_LT(difference(draw, truth_of(joint), read_back(joint, target, ExportWay::matrix)), 1e-9)
          << seed << " " << static_cast<int>(target);
  }
}

TEST(Export, UnsymmetricMatricesToo) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Draw draw(seed);
    const tasks::ExportedJoint joint = draw.full(false);
    for (const ExportTarget target : {ExportTarget::nastran, ExportTarget::abaqus, ExportTarget::matrix_market})
      EXPECT_LT(difference(draw, truth_of(joint), read_back(joint, target, ExportWay::matrix)), 1e-9)
          << seed << " " << static_cast<int>(target);
    if (joint.dofs.size() > 1) {
      EXPECT_THROW(read_back(joint, ExportTarget::ansys, ExportWay::matrix), InputError);
      EXPECT_THROW(read_back(joint, ExportTarget::nastran, ExportWay::springs), InputError);
    }
  }
}

TEST(Export, SpringsAndBushesReadBackGiveTheSameAssembly) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Draw draw(seed);
    const tasks::ExportedJoint joint = draw.springs();
    for (const ExportTarget target : {ExportTarget::nastran, ExportTarget::ansys, ExportTarget::abaqus}) {
      for (const ExportWay way : {ExportWay::springs, ExportWay::bush}) {
        if (target == ExportTarget::ansys && way == ExportWay::bush) continue;
        EXPECT_LT(difference(draw, truth_of(joint), read_back(joint, target, way)), 1e-9)
            << seed << " " << static_cast<int>(target);
      }
    }
  }
}

/// Any symmetric joint is springs between all pairs of its DOFs, some of them negative.
TEST(Export, AnySymmetricJointIsScalarSpringsOfNastran) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Draw draw(seed);
    const tasks::ExportedJoint joint = draw.full(true);
    EXPECT_LT(difference(draw, truth_of(joint), read_back(joint, ExportTarget::nastran, ExportWay::springs)), 1e-9) << seed;
  }
}

tasks::ExportedJoint one_spring() {
  tasks::ExportedJoint joint{.source = "joint.toml",
                             .status = "ok",
                             .dofs = {frf::Dof::parse("4:+Y"), frf::Dof::parse("5:+Y")},
                             .matrices = {},
                             .errors = {},
                             .unknowns = {},
                             .covariance = {}};
  joint.matrices[Kind::stiffness] = {{2e6, -2e6}, {-2e6, 2e6}};
  joint.matrices[Kind::hysteretic_damping] = {{1e4, -1e4}, {-1e4, 1e4}};
  joint.errors[Kind::stiffness] = {{3e3, 3e3}, {3e3, 3e3}};
  joint.unknowns = {{.name = "K[4:+Y,5:+Y]", .unit = "N/m", .value = 2e6, .std_error = 3e3, .ci95 = {}, .rounding = {}}};
  joint.covariance = {{9e6}};
  return joint;
}

TEST(Export, ChoosesSpringsForSprings) {
  const std::string text =
      text_of(export_files(one_spring(),
                           {.target = ExportTarget::nastran, .way = ExportWay::automatic, .millimetres = false, .first_id = 7}),
              ".bdf");
  EXPECT_THAT(text, HasSubstr("$ K between 4:+Y and 5:+Y = 2e+06 N/m, standard error 3e+03\n"));
  EXPECT_THAT(text, HasSubstr("GE: D between 4:+Y and 5:+Y = 10000 N/m, standard error not stated"));
  EXPECT_THAT(
      text,
      HasSubstr(
          "CELAS2* 7               2.000000000000+64               2\n*       5               2               5.000000000000-3"));
  tasks::ExportedJoint negative = one_spring();
  for (auto& row : negative.matrices[Kind::stiffness]) {
    for (double& value : row) value = -value;
  }
  EXPECT_THAT(export_files(negative, {}).front().text, HasSubstr("DMIG*   KJOINT"));
}

TEST(Export, MillimetresMakeAConsistentSystem) {
  tasks::ExportedJoint joint = one_spring();
  joint.dofs = {frf::Dof::parse("4:+Y"), frf::Dof::parse("4:+RZ")};
  joint.matrices[Kind::stiffness] = {{2e6, 3e3}, {3e3, 5e2}};
  joint.matrices[Kind::mass] = {{2.0, 0.5}, {0.5, 0.25}};
  const std::string text =
      export_files(joint, {.target = ExportTarget::abaqus, .way = ExportWay::matrix, .millimetres = true, .first_id = 1})
          .front()
          .text;
  const cards::Assembled read = cards::read_abaqus(text, joint.dofs);
  EXPECT_NEAR(read.k(0, 0), 2e3, 1e-9);     // N/mm
  EXPECT_NEAR(read.k(0, 1), 3e3, 1e-9);     // N/rad
  EXPECT_NEAR(read.k(1, 1), 5e5, 1e-9);     // N mm/rad
  EXPECT_NEAR(read.m(0, 0), 2e-3, 1e-12);   // t
  EXPECT_NEAR(read.m(0, 1), 0.5, 1e-12);    // t mm
  EXPECT_NEAR(read.m(1, 1), 250.0, 1e-12);  // t mm²
  EXPECT_THAT(text, HasSubstr("2000 N/mm, standard error 3"));
  EXPECT_THAT(text, HasSubstr("M(4:+RZ,4:+RZ) = 250 t*mm^2"));
}

TEST(Export, CovarianceHasTheUnknowns) {
  const std::string text = text_of(export_files(one_spring(), {}), "_covariance.csv");
  EXPECT_THAT(text, HasSubstr("unknown,unit,value,standard error,\"K[4:+Y,5:+Y]\"\n\"K[4:+Y,5:+Y]\",N/m,2000000,3000,9000000\n"));
}

void expect_refused(const tasks::ExportedJoint& joint, ExportTarget target, ExportWay way, const std::string& problem) {
  try {
    export_files(joint, {.target = target, .way = way, .millimetres = false, .first_id = 1});
    ADD_FAILURE() << "accepted, not: " << problem;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(problem));
    EXPECT_FALSE(error.parts().remedy.empty());
  }
}

TEST(Export, RefusesWhatElementsDoNotHold) {
  tasks::ExportedJoint joint = one_spring();
  joint.matrices[Kind::mass] = {{1.0, 0.0}, {0.0, 1.0}};
  expect_refused(joint, ExportTarget::abaqus, ExportWay::springs, "no mass");
  expect_refused(joint, ExportTarget::nastran, ExportWay::bush, "no mass");
  expect_refused(joint, ExportTarget::matrix_market, ExportWay::springs, "no springs");
  expect_refused(joint, ExportTarget::ansys, ExportWay::bush, "no bush for ansys");
  joint = one_spring();
  joint.dofs[1] = frf::Dof::parse("5:+X");
  expect_refused(joint, ExportTarget::nastran, ExportWay::bush, "one direction");
  expect_refused(joint, ExportTarget::ansys, ExportWay::springs, "one direction");
  joint = one_spring();
  joint.matrices.erase(Kind::stiffness);
  expect_refused(joint, ExportTarget::abaqus, ExportWay::springs, "stiffness that is not there");
  expect_refused(joint, ExportTarget::nastran, ExportWay::bush, "without stiffness");
  joint.matrices[Kind::hysteretic_damping] = {{0.0, 0.0}, {0.0, 0.0}};
  expect_refused(joint, ExportTarget::nastran, ExportWay::automatic, "zero");
  EXPECT_THROW(parse_export_target("nastrn"), InputError);
  EXPECT_THROW(parse_export_way("spring"), InputError);
}

}  // namespace
}  // namespace jointid::report
