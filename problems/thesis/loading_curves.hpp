#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "friction/curve/curve.hpp"
#include "problems/case/write_options.hpp"

namespace jointid::problems {

/// Radii of the rings of thesis §2.15.2, m.
struct Ring {
  double inner = 0.0255, outer = 0.038;
};

/// A loading curve made of a row of Tables 2.1–2.7: the element that the thesis identified, in SI units, loaded from rest.
struct LoadingCurve {
  std::string name;             ///< "table2.1-1"
  std::string description;      ///< one line
  std::string law;              ///< as friction::make_element knows it
  std::vector<double> values;   ///< of a translational joint (N, m), or per area of a rotary one (N/m², m)
  std::optional<Ring> ring;     ///< of a rotary joint
  double normal_load = 0.0;     ///< N, or N/m² of a rotary joint
  double printed_limit = 0.0;   ///< T_max of the table, N or N/m²
};

/// All rows of the tables that can be made, in their order.
const std::vector<LoadingCurve>& loading_curves();

/// The one of that name, or null.
const LoadingCurve* find_loading_curve(const std::string& name);

std::unique_ptr<friction::Element> element_of(const LoadingCurve& problem);

/// `points` even steps from rest to 1.2 times macroslip, or to 4 times the displacement limit/stiffness of laws without an end;
/// force or torque with normal errors of `noise` times the largest one, stream (seed, 0).
friction::Curve make_curve(const LoadingCurve& problem, std::size_t points, double noise, std::uint64_t seed);

/// Writes NAME.csv (100 points, 1 % noise unless clean) and truth.json into `directory`; the path of the CSV.
std::filesystem::path write(const LoadingCurve& problem, const std::filesystem::path& directory, const WriteOptions& options);

/// What `jointid loading-curve` has to be told to find the element again: "--law ren", with rings "--law ren --ring 0.0255,0.038".
std::string fit_options(const LoadingCurve& problem);

}  // namespace jointid::problems
