#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <sstream>

#include "base/eigen.hpp"
#include "ident/newton/response_line.hpp"
#include "ident/plan/coordinates.hpp"
#include "problems/case/many_joints_problem.hpp"
#include "tests/golden_json.hpp"
#include "tests/require.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using nlohmann::json;
using problems::ManyJoints;

json golden_case(const std::string& name) { return jointid::golden_case("sparse.json", "name", name); }

frf::Dof dof_at(const ManyJoints& structure, const json& place) {
  return structure.parts[place[0].get<std::size_t>()].dofs()[place[1].get<std::size_t>()];
}

/// chain50_loose3: the share of K that each joint has left, from FRFs at six coordinates with the noise of the file; the other
/// program's weights are those of the exact FRFs.
class LooseChain {
 public:
  /// `free`: joints whose share is unknown, the others as they should be.
  LooseChain(const json& golden, const std::vector<std::size_t>& free)
      : golden_(golden), structure_(problems::many_joints("loose-3")) {
    structure_.references.clear();
    for (const json& each : golden["sensors"]) structure_.references.push_back(dof_at(structure_, each));
    structure_.frequency_hz = golden["lines_hz"].get<std::vector<double>>();
    std::vector<restrictions::JointSpec> joints;
    for (std::size_t e = 0; e < structure_.joints.size(); ++e) {
      const problems::BeamJoint& joint = structure_.joints[e];
      const bool is_free = std::ranges::find(free, e) != free.end();
      restrictions::JointSpec& spec = joints.emplace_back();
      spec.name = "j" + std::to_string(e + 1);
      spec.dofs = joint.dofs;
      spec.matrices[restrictions::Kind::stiffness] = entries(joint.over_dofs(joint.relative_stiffness), is_free);
      spec.matrices[restrictions::Kind::hysteretic_damping] = entries(joint.over_dofs(joint.relative_damping), false);
    }
    restriction_ = restrictions::build(joints);
    columns_ = std::make_unique<UnknownColumns>(restriction_, joints);
    form_lines();
  }

  /// JᵀJ, Jᵀf and χ² at shares of K.
  struct Normal {
    MatrixXd information;
    Eigen::VectorXd gradient;
    double chi_square = 0.0;
  };
  Normal at_shares(const std::vector<double>& left) const {
    const Index n = at(columns_->size());
    Normal out{MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n), 0.0};
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const Index rows = at(lines_[i].rows());
      Eigen::VectorXd f(rows);
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(rows, n);
      EXPECT_TRUE(lines_[i].linearise(left, f.data(), jacobian.data()));
      f = weight_[i].cwiseProduct(f);
      jacobian = weight_[i].asDiagonal() * jacobian;
      out.information += jacobian.transpose() * jacobian;
      out.gradient += jacobian.transpose() * f;
      out.chi_square += f.squaredNorm();
    }
    return out;
  }

 private:
  static restrictions::EntryMatrix entries(const Matrix& numbers, bool is_free) {
    restrictions::EntryMatrix out(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      for (const double value : numbers[i]) {
        std::ostringstream text;
        text << std::setprecision(17) << value << "*share";
        out[i].push_back(is_free ? restrictions::Entry(text.str()) : restrictions::Entry(value));
      }
    }
    return out;
  }

  /// The assembly with the loose joints of the file, motion at the sensors [sensors × references] line by line.
  std::vector<Eigen::MatrixXcd> exact_motions() const {
    ManyJoints loose = structure_;
    for (const auto& [joint, lost] : golden_["loose"].items()) {
      for (auto& row : loose.joints[std::stoul(joint)].relative_stiffness) {
        for (double& element : row) element *= 1.0 - lost.get<double>();
      }
    }
    const frf::FrfSet assembly = problems::assembly_receptances(loose);
    std::vector<Eigen::MatrixXcd> out;
    for (std::size_t i = 0; i < structure_.frequency_hz.size(); ++i) {
      Eigen::MatrixXcd& h = out.emplace_back(at(golden_["sensors"].size()), at(golden_["references"].size()));
      for (Index r = 0; r < h.rows(); ++r) {
        for (Index c = 0; c < h.cols(); ++c)
          h(r, c) = element(assembly, i, golden_["sensors"][static_cast<std::size_t>(r)],
                            golden_["references"][static_cast<std::size_t>(c)]);
      }
    }
    return out;
  }

  Complex element(const frf::FrfSet& set, std::size_t line, const json& row, const json& column) const {
    return set.values[set.index(line, frf::find_coordinate(set.header.response, dof_at(structure_, row)),
                                frf::find_coordinate(set.header.reference, dof_at(structure_, column)))];
  }

  void form_lines() {
    std::vector<frf::FrfSet> parts;
    for (std::size_t s = 0; s < structure_.parts.size(); ++s) parts.push_back(problems::part_receptances(structure_, s));
    Dofs sensors, references;
    for (const json& each : golden_["sensors"]) sensors.push_back(dof_at(structure_, each));
    for (const json& each : golden_["references"]) references.push_back(dof_at(structure_, each));
    std::size_t k = 0;
    const auto exact = exact_motions();
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const auto block = [&](const Dofs& rows, const Dofs& columns) {
        Eigen::MatrixXcd out = Eigen::MatrixXcd::Zero(at(rows.size()), at(columns.size()));
        for (const frf::FrfSet& part : parts) fill(part, i, rows, columns, out);
        return out;
      };
      const Dofs& joint = restriction_.dofs;
      ReachableFrfs frfs{block(sensors, references), block(sensors, joint), block(joint, references), block(joint, joint),
                         exact[i]};
      Eigen::VectorXd weight(2 * exact[i].size());
      for (Index r = 0; r < exact[i].rows(); ++r) {
        for (Index c = 0; c < exact[i].cols(); ++c) {
          const double size = 0.01 * std::abs(exact[i](r, c)) / std::sqrt(6.0), order = static_cast<double>(++k);
          const auto fraction = [order](double step) { return step * order - std::floor(step * order); };
          frfs.nn(r, c) += size * std::sqrt(-2.0 * std::log(fraction(0.7548776662466927))) *
                           std::polar(1.0, 2.0 * std::numbers::pi * fraction(0.5698402909980532));
          const Index place = r * exact[i].cols() + c;
          weight[place] = weight[place + exact[i].size()] = 1.0 / size;
        }
      }
      if (i + 1 == exact.size()) last_ = frfs.nn;
      weight_.push_back(std::move(weight));
      lines_.emplace_back(std::move(frfs),
                          joint_at(restriction_, *columns_, 1.0, 2.0 * std::numbers::pi * structure_.frequency_hz[i]));
    }
  }

  static void fill(const frf::FrfSet& part, std::size_t line, const Dofs& rows, const Dofs& columns, Eigen::MatrixXcd& to) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::size_t row = frf::find_coordinate(part.header.response, rows[r]);
      for (std::size_t c = 0; row != frf::npos && c < columns.size(); ++c) {
        const std::size_t column = frf::find_coordinate(part.header.reference, columns[c]);
        if (column != frf::npos) to(at(r), at(c)) = part.values[part.index(line, row, column)];
      }
    }
  }

 public:
  const Eigen::MatrixXcd& noisy_last_line() const { return last_; }

 private:
  const json& golden_;
  ManyJoints structure_;
  restrictions::Restriction restriction_;
  std::unique_ptr<UnknownColumns> columns_;
  std::vector<ResponseLine> lines_;
  std::vector<Eigen::VectorXd> weight_;
  Eigen::MatrixXcd last_;
};

std::vector<std::size_t> all_joints() {
  std::vector<std::size_t> out(50);
  std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

TEST(GoldenJoints, LooseJointsOfFewSensorsAreRefitted) {
  const json golden = golden_case("chain50_loose3");
  if (golden.is_null()) JOINTID_SKIP("no golden values; set JOINTID_EXTERNAL_DATA");
  const LooseChain chain(golden, {11, 26, 37});
  for (Index k = 0; k < 12; ++k) {
    const Complex expected(golden["H_noisy_last_line"][static_cast<std::size_t>(k)][0],
                           golden["H_noisy_last_line"][static_cast<std::size_t>(k)][1]);
    EXPECT_LE(std::abs(chain.noisy_last_line()(k / 2, k % 2) - expected), 1e-8 * std::abs(expected)) << k;
  }
  std::vector<double> left = {0.3, 0.5, 0.2};
  for (int step = 0; step < 5; ++step) {
    const auto normal = chain.at_shares(left);
    const Eigen::VectorXd change = -normal.information.ldlt().solve(normal.gradient);
    for (std::size_t c = 0; c < 3; ++c) left[c] += change[at(c)];
  }
  const auto end = chain.at_shares(left);
  const MatrixXd covariance = end.information.inverse();
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(1.0 - left[c], golden["refit_s"][c].get<double>(), 1e-7);
    EXPECT_NEAR(std::sqrt(covariance(at(c), at(c))) / golden["refit_sd"][c].get<double>(), 1.0, 1e-5);
  }
  EXPECT_NEAR(end.chi_square / golden["refit_chi2"].get<double>(), 1.0, 1e-6);
}

TEST(GoldenJoints, AllSharesOfTheLooseChainAreFixedByFewSensors) {
  const json golden = golden_case("chain50_loose3");
  if (golden.is_null()) JOINTID_SKIP("no golden values; set JOINTID_EXTERNAL_DATA");
  const LooseChain chain(golden, all_joints());
  std::vector<double> left(50, 1.0);
  EXPECT_NEAR(chain.at_shares(left).chi_square / golden["chi2_nominal"].get<double>(), 1.0, 1e-6);
  for (const auto& [joint, lost] : golden["loose"].items()) left[std::stoul(joint)] = 1.0 - lost.get<double>();
  const MatrixXd covariance = chain.at_shares(left).information.ldlt().solve(MatrixXd::Identity(50, 50));
  for (std::size_t c = 0; c < 50; ++c)
    EXPECT_NEAR(std::sqrt(covariance(at(c), at(c))) / golden["sd_if_all_50_are_free_at_truth"][c].get<double>(), 1.0, 2e-5) << c;
}

}  // namespace
}  // namespace jointid::ident
