#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "beam_chain.hpp"
#include "tests/ident/memory_systems.hpp"
#include "tests/require.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using nlohmann::json;

const json& golden_case(const std::string& name) {
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

/// `chain50_loose3`: the parts exact, six sensors and two references on the chain, 1 % noise by the file's formula.
MemoryScene loose3() {
  const json& problem = golden_case("chain50_loose3");
  BeamChain chain;
  chain.lost.assign(50, 0.0);
  for (const auto& [joint, lost] : problem["loose"].items()) chain.lost[std::stoul(joint)] = lost;
  const auto name = [](std::size_t part, std::size_t coordinate) {
    return frf::Dof::parse(std::to_string(10 * part + coordinate / 2 + 1) + (coordinate % 2 == 0 ? ":+Y" : ":+RZ"));
  };
  MemoryScene out;
  frf::FrfSet assembly;
  assembly.header.file = "assembly";
  assembly.header.frequency_hz = problem["lines_hz"].get<std::vector<double>>();
  assembly.header.noise = frf::NoiseRecord::variance;
  std::vector<std::pair<std::size_t, std::size_t>> sensors, forces;
  for (const json& each : problem["sensors"]) sensors.emplace_back(each[0], each[1]);
  for (const json& each : problem["references"]) forces.emplace_back(each[0], each[1]);
  for (const auto& [part, coordinate] : sensors) assembly.header.response.push_back(name(part, coordinate));
  for (const auto& [part, coordinate] : forces) assembly.header.reference.push_back(name(part, coordinate));
  double number = 0.0;
  for (const double hz : assembly.header.frequency_hz) {
    const Eigen::MatrixXcd h = chain.chain_frfs(2.0 * std::numbers::pi * hz, forces);
    for (const auto& [part, coordinate] : sensors) {
      for (Index l = 0; l < h.cols(); ++l) {
        number += 1.0;
        const Complex exact = h(6 * Index(part) + Index(coordinate), l);
        const double u1 = std::fmod(0.7548776662466927 * number, 1.0), u2 = std::fmod(0.5698402909980532 * number, 1.0);
        const double size = 0.01 * std::abs(exact) / std::sqrt(6.0);
        assembly.values.push_back(exact + std::polar(size * std::sqrt(-2.0 * std::log(u1)), 2.0 * std::numbers::pi * u2));
        assembly.variance.emplace_back(size * size, size * size);
      }
    }
  }
  for (std::size_t part = 0; part < chain.parts(); ++part) {
    frf::FrfSet own;
    own.header.file = "part " + std::to_string(part);
    own.header.frequency_hz = assembly.header.frequency_hz;
    own.header.noise = frf::NoiseRecord::variance;
    for (std::size_t c = 0; c < 6; ++c) own.header.response.push_back(name(part, c));
    own.header.reference = own.header.response;
    for (const double hz : own.header.frequency_hz) {
      const BeamChain::Complex6 h = chain.free_frfs(part, 2.0 * std::numbers::pi * hz);
      for (Index r = 0; r < 6; ++r) {
        for (Index c = 0; c < 6; ++c) {
          own.values.push_back(h(r, c));
          own.variance.push_back(1e-18 * std::norm(h(r, c)) * Complex(1.0, 1.0));
        }
      }
    }
    out.substructures.push_back(std::move(own));
  }
  out.assembly = {std::move(assembly)};
  out.scene.data.substructures.resize(chain.parts());
  out.scene.data.assembly.resize(1);
  scene::Matrix start(200, std::vector<double>(200, 0.0));
  for (std::size_t e = 0; e < 50; ++e) {
    restrictions::JointSpec joint;
    joint.name = "j" + std::to_string(e);
    for (const auto& [part, c] : {std::pair(e, 4), std::pair(e, 5), std::pair(e + 1, 0), std::pair(e + 1, 1)})
      joint.dofs.push_back(name(part, std::size_t(c)));
    const auto [k11, k12, k22, d11, d12, d22] = BeamChain().joint(e);
    const auto matrix = [](double a, double b, double c) -> restrictions::EntryMatrix {
      return {{a, b, -a, -b}, {b, c, -b, -c}, {-a, -b, a, b}, {-b, -c, b, c}};
    };
    restrictions::EntryMatrix stiffness = matrix(k11, k12, k22);
    for (auto& row : stiffness) {
      for (restrictions::Entry& entry : row) {
        const double value = std::get<double>(entry);
        const std::size_t r = std::size_t(&row - stiffness.data()), c = std::size_t(&entry - row.data());
        start[4 * e + r][4 * e + c] = value * (1.0 - (chain.lost[e] > 0.0 ? chain.lost[e] + 0.02 : 0.0));
        std::ostringstream text;
        text.precision(17);
        text << value << "*share";
        if (chain.lost[e] > 0.0) entry = text.str();
      }
    }
    joint.matrices[restrictions::Kind::stiffness] = stiffness;
    joint.matrices[restrictions::Kind::hysteretic_damping] = matrix(d11, d12, d22);
    out.scene.joints.push_back(std::move(joint));
  }
  out.scene.identify.method = Method::likelihood;
  out.scene.identify.equations = {Equation::nn};
  out.scene.identify.variance = VarianceChoice::file;
  out.scene.identify.smooth_variance = false;
  out.scene.identify.start[restrictions::Kind::stiffness] = start;
  return out;
}

TEST(GoldenLoose, TheThreeOfFiftyByLikelihood) {
  if (golden_case("chain50").is_null()) JOINTID_SKIP("the golden values are not there");
  const json& problem = golden_case("chain50_loose3");
  const MemoryScene all = loose3();
  Control control;
  control.judgement = Judgement::none;
  const Solution found = solve(*all.plan(), control);
  ASSERT_EQ(found.unknowns.size(), 3u);
  for (std::size_t u = 0; u < 3; ++u) {
    const double s = problem["refit_s"][u], deviation = problem["refit_sd"][u];
    EXPECT_NEAR(1.0 - found.unknowns[u].value, s, 0.02 * deviation) << u;
    EXPECT_NEAR(*found.unknowns[u].std_error, deviation, 0.02 * deviation) << u;
  }
  EXPECT_NEAR(found.fit.chi_square->value, problem["refit_chi2"].get<double>(), 0.01 * problem["refit_chi2"].get<double>());
}

}  // namespace
}  // namespace jointid::ident
