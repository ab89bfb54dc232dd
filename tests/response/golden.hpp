#pragma once

<<<<<<< HEAD
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
=======
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/complex.hpp"
#include "friction/law/laws.hpp"
#include "response/joint/joint.hpp"
#include "response/structure/matrix_structure.hpp"

/// Cases of golden/response.json, written by an independent program.
namespace jointid::response::golden {

using nlohmann::json;

inline std::filesystem::path file() {
  return std::filesystem::path(JOINTID_EXTERNAL_DATA).parent_path() / "golden" / "response.json";
}

/// All cases of a kind; none where there is no file.
inline std::vector<json> cases(const std::string& kind) {
  std::ifstream in(file());
  std::vector<json> found;
  if (!in) return found;
  const json all = json::parse(in);
  for (const json& each : all["cases"]) {
    if (each["kind"] == kind) found.push_back(each);
  }
  return found;
}

inline Complex complex(const json& value) {
  return value.is_array() ? Complex(value[0].get<double>(), value[1].get<double>()) : Complex(value.get<double>());
}

inline Eigen::MatrixXd matrix(const json& rows) {
  Eigen::MatrixXd m(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows[0].size()));
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    for (Eigen::Index j = 0; j < m.cols(); ++j)
      m(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].get<double>();
  }
  return m;
}

inline Eigen::VectorXcd complex_vector(const json& values) {
  Eigen::VectorXcd v(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index i = 0; i < v.size(); ++i) v(i) = complex(values[static_cast<std::size_t>(i)]);
  return v;
}

inline Eigen::MatrixXcd complex_matrix(const json& rows) {
  Eigen::MatrixXcd m(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows[0].size()));
  for (Eigen::Index i = 0; i < m.rows(); ++i) m.row(i) = complex_vector(rows[static_cast<std::size_t>(i)]).transpose();
  return m;
}

inline std::vector<int> integers(const json& values) { return values.get<std::vector<int>>(); }

inline std::shared_ptr<const friction::Element> element(const json& of) {
  return friction::make_element(of["law"].get<std::string>(), of["parameters"].get<std::vector<double>>());
}

inline MatrixStructure structure(const json& of) { return {matrix(of["M"]), matrix(of["C"]), matrix(of["K"])}; }

inline std::vector<Joint> joints(const json& of) {
  std::vector<Joint> all;
  for (const json& each : of) all.push_back({.name = each["law"].get<std::string>(), .friction = element(each)});
  return all;
}

/// The force of every harmonic, [harmonic, coordinate].
inline std::pair<std::vector<int>, Eigen::MatrixXcd> force(const json& of) {
  std::vector<int> numbers;
  for (const auto& [number, values] : of.items()) numbers.push_back(std::stoi(number));
  std::sort(numbers.begin(), numbers.end());
  Eigen::MatrixXcd all(static_cast<Eigen::Index>(numbers.size()), static_cast<Eigen::Index>(of.begin().value().size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    all.row(static_cast<Eigen::Index>(i)) = complex_vector(of[std::to_string(numbers[i])]).transpose();
  }
  return {numbers, all};
}

/// Largest difference over the largest element of what is expected.
template <class A, class B>
double difference(const A& found, const B& expected) {
  return (found - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

inline double tolerance(int trusted_digits) { return 3.0 * std::pow(10.0, -trusted_digits); }

}  // namespace jointid::response::golden
>>>>>>> response
