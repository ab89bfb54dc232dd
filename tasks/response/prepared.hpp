#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "ident/result/control.hpp"
#include "response/stability/matrix_assembly.hpp"
#include "tasks/response/response_scene.hpp"

namespace jointid::tasks {

/// The structure of a scene and the frequencies to be computed.
struct Prepared {
  std::shared_ptr<const response::Receptance> structure;
  bool everywhere = false;                             ///< known at every frequency: matrices
  std::optional<response::MatrixAssembly> assembly{};  ///< of full matrices
  std::optional<response::MatrixAssembly> marched{};   ///< what time marching takes: the same, or condensed to [structure] modes
  Eigen::MatrixXd basis{};                             ///< T of x = T y where it is condensed
  Eigen::MatrixXd responses{};                         ///< coordinates of `marched` × responses, of matrices
  std::vector<double> frequency_hz{};
  std::vector<double> lines_hz{};     ///< all of the files
  std::vector<std::string> doubts{};  ///< one phrase each

  /// A force of 1 N at a coordinate of the matrices, on the coordinates of `marched`.
  Eigen::VectorXd unit_force(Eigen::Index coordinate) const;

  /// ω (rad/s) below and above this one at which the structure is known; none at the ends of the files' lines.
  std::optional<std::array<double, 2>> beside(double omega) const;
};

/// Reads what the scene needs. Throws InputError (data).
Prepared prepare(const ResponseScene& scene, const ident::Control& control);

/// The same with these FRFs in place of the scene's files.
Prepared prepare(const ResponseScene& scene, std::vector<frf::FrfSet> parts, const ident::Control& control);

std::vector<response::Joint> joints_of(const ResponseScene& scene);

}  // namespace jointid::tasks
