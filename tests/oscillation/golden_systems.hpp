#pragma once

#include "oscillation/system/thesis_systems.hpp"
#include "tests/oscillation/golden_series.hpp"
#include "tests/require.hpp"

namespace jointid::oscillation {

using nlohmann::json;

inline Eigen::VectorXd vector_of(const json& values) {
  const auto numbers = values.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), at(numbers.size()));
}

inline BeltChain chain_of(const json& input) {
  BeltChain chain;
  chain.masses = input.value("masses", std::size_t{1});
  chain.mass = input["m"], chain.stiffness = input["k"], chain.velocity = input["V"];
  chain.damping = input["c"].get<double>() / (chain.masses == 1 ? chain.stiffness : 1.0);  // one mass: C itself
  chain.friction = {input["muK"], input["muS"], std::nullopt, input["N"], 0.0, std::nullopt};
  if (input.contains("alpha")) chain.friction.decay = input["alpha"].get<double>();
  return chain;
}

inline Eigen::VectorXd start_of(const ContactSystem& system, const json& input) {
  const auto part = [&](const char* key) -> Eigen::VectorXd {
    return input[key].is_array() ? vector_of(input[key]) : Eigen::VectorXd::Constant(system.degrees(), input[key].get<double>());
  };
  return system.state(part("x0"), part("v0"));
}

inline Cantilever beam_of(const json& input) {
  Cantilever beam;
  beam.length = input["L"], beam.width = input["b"], beam.thickness = input["h"], beam.youngs_modulus = input["E"],
  beam.density = input["rho"];
  beam.extension = input["l"], beam.extension_free = input["l_free"], beam.extension_width = input["bl"];
  beam.extension_thickness = input["hl"], beam.extension_density = input["rhol"], beam.fixture_mass = input["m_fix"];
  beam.modes = input["modes"];
  beam.friction = {input["muK"], input["muS"], std::nullopt, input["N0"], input["Nm"], input["Kc"].get<double>()};
  if (input.value("contact", "compliant") == "rigid") beam.friction.contact_stiffness.reset();
  if (input.contains("amplitude")) {
    beam.amplitude = input["amplitude"], beam.frequency_hz = input["frequency_hz"], beam.damping = input["damping_c"];
  }
  return beam;
}

inline Eigen::VectorXd at_rest(const ContactSystem& system) {
  return system.state(Eigen::VectorXd::Zero(system.degrees()), Eigen::VectorXd::Zero(system.degrees()));
}

}  // namespace jointid::oscillation
