#pragma once

#include <Eigen/Core>
#include <complex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/golden_json.hpp"
#include "tests/require.hpp"

/// Cases `expansion` and `criteria` of golden/impedance.json, written by an independent program.
namespace jointid::correlation::golden {

using nlohmann::json;

inline json case_named(const std::string& id) { return golden_case("impedance.json", "id", id); }

#define CORRELATION_CASE(variable, id)                    \
  const nlohmann::json variable = golden::case_named(id); \
  if (variable.is_null()) JOINTID_SKIP("golden/impedance.json is missing")

inline std::complex<double> complex(const json& value) { return {value[0].get<double>(), value[1].get<double>()}; }

/// A symmetric matrix from its upper triangle row by row.
inline Eigen::MatrixXcd symmetric(const json& triangle, Eigen::Index n) {
  Eigen::MatrixXcd out(n, n);
  std::size_t k = 0;
  for (Eigen::Index r = 0; r < n; ++r) {
    for (Eigen::Index c = r; c < n; ++c) out(r, c) = out(c, r) = complex(triangle[k++]);
  }
  return out;
}

inline Eigen::MatrixXd real_matrix(const json& rows) {
  Eigen::MatrixXd out(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows[0].size()));
  for (Eigen::Index r = 0; r < out.rows(); ++r) {
    for (Eigen::Index c = 0; c < out.cols(); ++c)
      out(r, c) = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)].get<double>();
  }
  return out;
}

/// Lines of a list of triangles.
inline std::vector<Eigen::MatrixXcd> lines(const json& of, Eigen::Index n) {
  std::vector<Eigen::MatrixXcd> out;
  for (const json& each : of) out.push_back(symmetric(each, n));
  return out;
}

inline std::vector<Eigen::Index> places(const json& of) {
  std::vector<Eigen::Index> out;
  for (const json& each : of) out.push_back(each.get<Eigen::Index>());
  return out;
}

}  // namespace jointid::correlation::golden
