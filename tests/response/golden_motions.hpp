#pragma once

#include <functional>

#include "golden.hpp"
#include "response/time/jointed_structure.hpp"

/// What tests of motions in time need of golden/response.json.
namespace jointid::response {

using golden::complex_vector;
using golden::difference;
using golden::matrix;

inline void for_each_golden(const std::string& kind, const std::function<void(const nlohmann::json&)>& use) {
  for (const auto& one : golden::cases(kind)) use(one);
}

inline Eigen::VectorXd vector(const nlohmann::json& numbers) {
  Eigen::VectorXd out(numbers.size());
  for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = numbers[static_cast<std::size_t>(i)];
  return out;
}

/// Of a case with M, C, K, W and joints.
inline JointedStructure jointed(const nlohmann::json& one) {
  JointedStructure out;
  out.matrices = golden::structure(one);
  out.incidence = matrix(one.at("W"));
  if (one.contains("joints")) {
    for (const auto& joint : one.at("joints")) out.laws.push_back(golden::element(joint));
  }
  return out;
}

/// Of the last trusted digit.
inline double tolerance(const nlohmann::json& one) { return std::pow(10.0, -one.at("trusted_digits").get<double>()); }

}  // namespace jointid::response
