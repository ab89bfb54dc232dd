#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "virtualpoint/virtual_point.hpp"

namespace jointid::virtualpoint {

enum class Side { sensors, impacts };

/// The sensors or the impacts of a virtual point that a file has, and what they are of its coordinates q, its loads m.
/// Sensors: u = R q + residual, q = T u, T = (RᵀWR)⁻¹RᵀW. Impacts: m = Rᵀf of forces f, f = Tᵀm. So that FRFs Y of the file
/// become T_u Y T_fᵀ (van der Seijs et al. 2013; pyFBS, VPT, where the W of impacts is the inverse of this one).
struct Transformation {
  std::vector<std::size_t> channels;  ///< [n] indices into the header's responses or references
  std::vector<frf::Dof> dofs;         ///< [n] of the channels, as the virtual point names them
  Eigen::MatrixXd modes;              ///< R [n,m], of the FRFs as the file has them
  Eigen::MatrixXd to_virtual;         ///< T [m,n]
  Eigen::MatrixXd positions;          ///< [n,3] from the virtual point, m
  Eigen::MatrixXd directions;         ///< [n,3] unit vectors of `dofs`
  Eigen::VectorXd signs;              ///< [n] of the FRFs as the file has them beside `dofs`, 1 or −1

  bool any() const { return !channels.empty(); }
  /// R T, which leaves alone what the modes can explain.
  Eigen::MatrixXd filter() const { return modes * to_virtual; }
};

/// Of what the file has of the channels; without channels where it has none of them. Throws InputError (data) where a node has no
/// position, and where the channels do not see all modes, naming those that are not seen.
Transformation transformation(const VirtualPoint& point, Side side, const frf::FrfHeader& header);

/// T of rows R with weights W: (RᵀWR)⁻¹RᵀW; the columns of R are scaled to length 1 on the way.
Eigen::MatrixXd weighted_inverse(const Eigen::MatrixXd& modes, const Eigen::VectorXd& weights);

/// One row of R: what a channel at r (m, from the virtual point) with this direction sees of each mode; a rotational one turns by
/// the rotation of the modes.
Eigen::RowVectorXd mode_row(const std::vector<InterfaceMode>& modes, const Vector& r, const Vector& direction, bool rotational);

}  // namespace jointid::virtualpoint
