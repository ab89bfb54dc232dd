#pragma once

#include <complex>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "friction/law/laws.hpp"
#include "response/time/jointed_structure.hpp"

namespace jointid::response {

/// Values of an independent program (shared/golden/README-response.md).
inline const nlohmann::json& golden() {
  static const nlohmann::json cases = [] {
    std::ifstream file(std::filesystem::path(JOINTID_EXTERNAL_DATA).parent_path() / "golden" / "response.json");
    return nlohmann::json::parse(file).at("cases");
  }();
  return cases;
}

inline void for_each_golden(const std::string& kind, const std::function<void(const nlohmann::json&)>& use) {
  for (const auto& one : golden()) {
    if (one.at("kind") == kind) use(one);
  }
}

inline Eigen::MatrixXd matrix(const nlohmann::json& rows) {
  if (rows.is_number()) return Eigen::MatrixXd::Constant(1, 1, rows.get<double>());
  Eigen::MatrixXd out(rows.size(), rows.at(0).size());
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    for (Eigen::Index k = 0; k < out.cols(); ++k) out(i, k) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  }
  return out;
}

inline Eigen::VectorXd vector(const nlohmann::json& numbers) {
  Eigen::VectorXd out(numbers.size());
  for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = numbers[static_cast<std::size_t>(i)];
  return out;
}

/// A number, or [re, im].
inline std::complex<double> complex_number(const nlohmann::json& value) {
  return value.is_array() ? std::complex<double>(value[0], value[1]) : std::complex<double>(value.get<double>());
}

inline Eigen::VectorXcd complex_vector(const nlohmann::json& values) {
  Eigen::VectorXcd out(values.size());
  for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = complex_number(values[static_cast<std::size_t>(i)]);
  return out;
}

inline std::shared_ptr<const friction::Element> law(const nlohmann::json& joint) {
  return friction::make_element(joint.at("law").get<std::string>(), joint.at("parameters").get<std::vector<double>>());
}

/// Of a case with M, C, K, W and joints.
inline JointedStructure jointed(const nlohmann::json& one) {
  JointedStructure out;
  out.matrices = {matrix(one.at("M")), matrix(one.at("C")), matrix(one.at("K"))};
  out.incidence = matrix(one.at("W"));
  if (one.contains("joints")) {
    for (const auto& joint : one.at("joints")) out.laws.push_back(law(joint));
  }
  return out;
}

/// Largest difference, in parts of the largest expected element.
template <class A, class B>
double difference(const A& values, const B& expected) {
  return (values - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

/// Half a unit of the last trusted digit, and rounding of the ones printed.
inline double tolerance(const nlohmann::json& one) { return std::pow(10.0, -one.at("trusted_digits").get<double>()); }

}  // namespace jointid::response
