#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "beam_chain.hpp"
#include "ident/admissible/sparse_semidefinite.hpp"
#include "tests/require.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using nlohmann::json;

const json& golden(const std::string& name) {
  static const json all = [] {
    const auto file = std::filesystem::path(JOINTID_EXTERNAL_DATA).parent_path() / "golden" / "sparse.json";
    return std::filesystem::exists(file) ? json::parse(std::ifstream(file)) : json();
  }();
  static const json none;
  if (all.is_null()) return none;
  for (const json& each : all["cases"]) {
    if (each["name"] == name) return each;
  }
  return none;
}

/// `chain50_constrained`: the metric of the noise-free local rows and an estimate that violates most constraints.
struct Chain50 {
  BeamChain chain;
  Eigen::MatrixXd information;
  VectorXd estimate;

  Chain50() {
    const json& base = golden("chain50");
    const json& problem = golden("chain50_constrained");
    std::vector<std::pair<std::size_t, std::size_t>> references;
    for (const json& each : base["references"]) references.emplace_back(each[0], each[1]);
    information = chain.local_information(base["lines_hz"].get<std::vector<double>>(), references);
    estimate.resize(information.rows());
    for (Index u = 0; u < estimate.size(); ++u)
      estimate[u] = 1.0 + problem["amplitude"].get<double>() *
                              std::sin(problem["rate"].get<double>() * double(u) + problem["phase"].get<double>());
  }

  Eigen::SparseMatrix<double> sparse() const { return information.sparseView(); }
  double cost(const VectorXd& y) const { return (y - estimate).dot(information * (y - estimate)); }
};

VectorXd vector_of(const json& values) {
  const auto numbers = values.get<std::vector<double>>();
  return Eigen::Map<const VectorXd>(numbers.data(), Index(numbers.size()));
}

TEST(GoldenConstraints, TheChainIsThatOfTheFile) {
  const json& base = golden("chain50");
  if (base.is_null()) JOINTID_SKIP("the golden values are not there");
  const BeamChain chain;
  const std::vector<double> truth = base["truth"];
  for (std::size_t e = 0; e < 50; ++e) {
    for (std::size_t u = 0; u < 6; ++u) EXPECT_NEAR(chain.joint(e)[u], truth[6 * e + u], 1e-12 * truth[6 * e + u]);
  }
  const json& probe = base["probe"][0]["H_asm"];
  const double omega = 2.0 * std::numbers::pi * base["lines_hz"][base["probe"][0]["line"].get<std::size_t>()].get<double>();
  const Eigen::MatrixXcd h = chain.chain_frfs(omega, {{0, 2}});
  EXPECT_NEAR(std::abs(h(0, 0) - std::complex(probe[0][0].get<double>(), probe[0][1].get<double>())) / std::abs(h(0, 0)), 0.0,
              1e-9);
}

TEST(GoldenConstraints, SemidefiniteJoints) {
  if (golden("chain50").is_null()) JOINTID_SKIP("the golden values are not there");
  const Chain50 all;
  std::vector<SymmetricBlock> blocks;
  for (Index first = 0; first < 300; first += 3) {
    const auto truth = all.chain.joint(std::size_t(first / 6));
    const std::size_t half = first % 6 == 0 ? 0 : 3;
    blocks.push_back({Eigen::MatrixXd::Zero(2, 2),
                      {first, first + 1, first + 2},
                      {{{0, 0, truth[half]}}, {{0, 1, truth[half + 1]}, {1, 0, truth[half + 1]}}, {{1, 1, truth[half + 2]}}}});
  }
  const auto fit = solve_sparse_semidefinite(blocks, all.estimate, all.sparse(), 1.0);
  ASSERT_TRUE(fit && fit->converged);
  const json& expected = golden("chain50_constrained")["semidefinite"];
  const VectorXd y = vector_of(expected["y"]);
  EXPECT_LT((fit->x - y).cwiseAbs().maxCoeff(), 2e-5);
  EXPECT_NEAR(all.cost(fit->x), expected["cost"].get<double>(), 1e-7 * all.cost(y));
  Index at_limit = 0;
  for (const Index each : fit->at_limit) at_limit += each > 0 ? 1 : 0;
  EXPECT_EQ(at_limit, expected["blocks_at_limit"].get<Index>());
  VectorXd pull =
      all.information * (fit->x - all.estimate);  // the certificate: made of multipliers, which are Λ ⪰ 0 with tr SΛ = 0
  const double size = pull.norm();
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    VectorXd own = VectorXd::Zero(300);
    blocks[k].add_adjoint(fit->multiplier[k], own);
    pull -= own;
    EXPECT_GE(least_eigenvalue(fit->multiplier[k]), -1e-12 * fit->multiplier[k].norm());
    EXPECT_LT(fit->multiplier[k].cwiseProduct(fit->value[k]).sum(), 1e-9 * expected["cost"].get<double>());
  }
  EXPECT_LT(pull.norm(), 1e-7 * size);
}

TEST(GoldenConstraints, JointsInABox) {
  if (golden("chain50").is_null()) JOINTID_SKIP("the golden values are not there");
  const Chain50 all;
  const json& expected = golden("chain50_constrained")["box"];
  const double lower = expected["lower"], upper = expected["upper"];
  std::vector<SymmetricBlock> blocks;
  for (Index u = 0; u < 300; ++u) {
    blocks.push_back({Eigen::MatrixXd::Constant(1, 1, -lower), {u}, {{{0, 0, 1.0}}}});
    blocks.push_back({Eigen::MatrixXd::Constant(1, 1, upper), {u}, {{{0, 0, -1.0}}}});
  }
  const auto fit = solve_sparse_semidefinite(blocks, all.estimate, all.sparse(), 1.0);
  ASSERT_TRUE(fit && fit->converged);
  EXPECT_LT((fit->x - vector_of(expected["y"])).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(all.cost(fit->x), expected["cost"].get<double>(), 1e-9 * all.cost(fit->x));
  Index at_lower = 0, at_upper = 0;
  for (std::size_t k = 0; k < blocks.size(); ++k) (k % 2 == 0 ? at_lower : at_upper) += fit->at_limit[k];
  EXPECT_EQ(at_lower, expected["at_lower"].get<Index>());
  EXPECT_EQ(at_upper, expected["at_upper"].get<Index>());
}

}  // namespace
}  // namespace jointid::ident
