#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "frf/set/frf_set.hpp"
#include "impedance/identify_lines.hpp"
#include "impedance/scene/read_line_scene.hpp"
#include "tests/golden_json.hpp"
#include "tests/require.hpp"

/// Cases of golden/impedance.json, written by an independent program.
namespace jointid::impedance::golden {

using nlohmann::json;

inline json golden_case(const std::string& id) { return jointid::golden_case("impedance.json", "id", id); }

#define IMPEDANCE_CASE(variable, id)                       \
  const nlohmann::json variable = golden::golden_case(id); \
  if (variable.is_null()) JOINTID_SKIP("golden/impedance.json is missing")

inline Complex complex(const json& value) { return {value[0].get<double>(), value[1].get<double>()}; }

inline frf::Dof dof(std::size_t coordinate) { return frf::Dof::parse(std::to_string(coordinate + 1) + ":+Y"); }

/// FRFs of some coordinates: of each line the pairs listed, both ways, with σ² split between real and imaginary part.
inline frf::FrfSet set_of(const std::string& file, const json& frequency, const std::vector<std::size_t>& coordinates,
                          const std::vector<std::pair<std::size_t, std::size_t>>& pairs, const json& values, const json& sigma) {
  frf::FrfSet set;
  set.header.file = file;
  set.header.frequency_hz = frequency.get<std::vector<double>>();
  for (const std::size_t c : coordinates) set.header.response.push_back(dof(c));
  set.header.reference = set.header.response;
  set.header.noise = frf::NoiseRecord::variance;
  const std::size_t lines = set.header.frequency_hz.size(), n = coordinates.size();
  set.values.assign(lines * n * n, {std::nan(""), std::nan("")});
  set.variance = set.values;
  const auto place = [&](std::size_t c) {
    return static_cast<std::size_t>(std::ranges::find(coordinates, c) - coordinates.begin());
  };
  for (std::size_t line = 0; line < lines; ++line) {
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      const std::size_t r = place(pairs[p].first), c = place(pairs[p].second);
      if (r == n || c == n) continue;
      const double variance = 0.5 * std::pow(sigma[line][p].get<double>(), 2);
      set.values[set.index(line, r, c)] = set.values[set.index(line, c, r)] = complex(values[line][p]);
      set.variance[set.index(line, r, c)] = set.variance[set.index(line, c, r)] = {variance, variance};
    }
  }
  return set;
}

inline std::vector<std::pair<std::size_t, std::size_t>> triangle(const std::vector<std::size_t>& coordinates) {
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (std::size_t r = 0; r < coordinates.size(); ++r) {
    for (std::size_t c = r; c < coordinates.size(); ++c) out.emplace_back(coordinates[r], coordinates[c]);
  }
  return out;
}

/// A case of kind "lines" with both its parts.
struct LinesCase {
  std::vector<frf::FrfSet> substructures, assembly;
  std::string dofs;  ///< TOML list
};

inline LinesCase lines_case(const json& given) {
  const auto parts = given["parts"].get<std::vector<std::size_t>>();
  std::vector<std::size_t> all, part[2];
  for (std::size_t c = 0; c < parts.size(); ++c) {
    all.push_back(c);
    part[parts[c]].push_back(c);
  }
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const json& pair : given["pairs_sub"]) pairs.emplace_back(pair[0].get<std::size_t>(), pair[1].get<std::size_t>());
  LinesCase out;
  for (const std::size_t p : {0U, 1U}) {
    out.substructures.push_back(
        set_of(p == 0 ? "A.h5" : "B.h5", given["frequency_Hz"], part[p], pairs, given["H_sub"], given["sigma_sub"]));
  }
  out.assembly.push_back(set_of("AB.h5", given["frequency_Hz"], all, triangle(all), given["H_asm"], given["sigma_asm"]));
  for (const json& j : given["joint"]) out.dofs += (out.dofs.empty() ? "\"" : ", \"") + dof(j.get<std::size_t>()).name() + "\"";
  return out;
}

inline LineScene scene_of(const std::string& dofs, const std::string& rest,
                          const std::string& substructures = "\"A.h5\", \"B.h5\"") {
  return parse_line_scene(
      "[data]\nsubstructures = [" + substructures + "]\nassembly = [\"AB.h5\"]\n[joint]\ndofs = [" + dofs + "]\n" + rest,
      "scene.toml");
}

/// Values of a way against those expected, to `digits` of the largest of their list.
inline void expect_values(const WayResult& way, const json& z, double tolerance) {
  ASSERT_EQ(way.lines.size(), z.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    ASSERT_TRUE(way.lines[i]) << i;
    ASSERT_EQ(static_cast<std::size_t>(way.lines[i]->z.size()), z[i].size());
    double largest = 0.0;
    for (const json& one : z[i]) largest = std::max(largest, std::abs(complex(one)));
    for (std::size_t t = 0; t < z[i].size(); ++t) {
      EXPECT_LT(std::abs(way.lines[i]->z(static_cast<Eigen::Index>(t)) - complex(z[i][t])), tolerance * largest)
          << name(way.way) << ", line " << i << ", element " << t;
    }
  }
}

inline void expect_variances(const WayResult& way, const json& variance, double tolerance) {
  for (std::size_t i = 0; i < variance.size(); ++i) {
    for (std::size_t t = 0; t < variance[i].size(); ++t) {
      EXPECT_NEAR(way.lines[i]->variance(static_cast<Eigen::Index>(t)) / variance[i][t].get<double>(), 1.0, tolerance)
          << name(way.way) << ", line " << i << ", element " << t;
    }
  }
}

/// A likelihood against the reference: z to 1e-6 standard deviations.
inline void expect_likelihood(const WayResult& way, const json& expected, double degrees) {
  ASSERT_EQ(way.lines.size(), expected["z"].size());
  for (std::size_t i = 0; i < way.lines.size(); ++i) {
    ASSERT_TRUE(way.lines[i]) << i;
    for (std::size_t t = 0; t < expected["z"][i].size(); ++t) {
      const auto k = static_cast<Eigen::Index>(t);
      const double deviation = std::sqrt(expected["variance"][i][t].get<double>());
      EXPECT_LT(std::abs(way.lines[i]->z(k) - complex(expected["z"][i][t])), 1e-6 * deviation)
          << "line " << i << ", element " << t;
      EXPECT_NEAR(way.lines[i]->variance(k) / (deviation * deviation), 1.0, 1e-6) << "line " << i << ", element " << t;
    }
    EXPECT_NEAR(way.lines[i]->chi_square, expected["chi2"][i].get<double>(), 1e-8 * expected["chi2"][i].get<double>()) << i;
    EXPECT_EQ(way.lines[i]->freedom, degrees);
  }
}

}  // namespace jointid::impedance::golden
