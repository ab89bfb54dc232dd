#pragma once

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

/// Rows of numbers; a number is a matrix of one.
inline Eigen::MatrixXd matrix(const json& rows) {
  if (rows.is_number()) return Eigen::MatrixXd::Constant(1, 1, rows.get<double>());
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
