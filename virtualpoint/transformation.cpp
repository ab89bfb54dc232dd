#include "virtualpoint/transformation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "dense/minimum_norm.hpp"
#include "dense/svd.hpp"

namespace jointid::virtualpoint {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of the columns of R, scaled to length 1.
constexpr double smallest_singular_value = 1e-6;

const char* word(Side side) { return side == Side::sensors ? "sensors" : "impacts"; }

const frf::Node* node_of(const Channel& channel, const frf::FrfHeader& header) {
  const auto node = std::ranges::find_if(header.nodes, [&](const frf::Node& n) { return n.id == channel.dof.node; });
  return node == header.nodes.end() ? nullptr : &*node;
}

/// Unit vector of a channel as the scene names its DOF, along the axes that its file has for the node.
Vector direction_of(const VirtualPoint& point, const Channel& channel, const frf::FrfHeader& header) {
  if (channel.direction) return *channel.direction;
  const std::size_t axis = (static_cast<std::size_t>(channel.dof.direction) - 1) % 3;
  Vector unit{};
  unit[axis] = 1.0;
  const frf::Node* node = node_of(channel, header);
  if (node != nullptr && node->axes) unit = (*node->axes)[axis];
  if (std::isnan(unit[0])) {
    fail(header, name(point),
         "node " + std::to_string(channel.dof.node) + " measures in a coordinate system that the file does not define",
         "add its dataset 2420, or give directions = { \"" + channel.dof.name() + "\" = [x, y, z] }");
  }
  for (double& component : unit) component *= channel.dof.sign;
  return unit;
}

Vector position_of(const VirtualPoint& point, const Channel& channel, const frf::FrfHeader& header) {
  const auto given = point.positions.find(channel.dof.node);
  if (given != point.positions.end()) return given->second;
  if (const frf::Node* node = node_of(channel, header)) return node->position;
  const std::string number = std::to_string(channel.dof.node);
  fail(header, name(point), "node " + number + " of " + channel.dof.name() + " has no position",
       "give it in the scene, [nodes] \"" + number + "\" = [x, y, z], or use a file with nodes");
}

VectorXd lengths(const MatrixXd& modes) {
  VectorXd out = modes.colwise().norm();
  for (double& length : out) length = length > 0.0 ? length : 1.0;
  return out;
}

/// Throws where some motion of the modes moves no channel: those DOFs that it is made of.
void require_rank(const VirtualPoint& point, Side side, const frf::FrfHeader& header, const Transformation& out) {
  const MatrixXd scaled = out.modes * lengths(out.modes).cwiseInverse().asDiagonal();
  const dense::RealSvd svd = dense::jacobi_svd(scaled, dense::Vectors::none, dense::Vectors::full);
  const Eigen::Index modes = scaled.cols();
  Eigen::Index rank = 0;
  while (rank < svd.sigma.size() && svd.sigma[rank] > smallest_singular_value * svd.sigma[0]) ++rank;
  if (rank == modes) return;
  constexpr double counts = 0.1;
  const VectorXd share = svd.v.rightCols(modes - rank).rowwise().norm();
  std::string unseen;
  const std::vector<frf::Dof> names = dofs(point);
  for (Eigen::Index i = 0; i < modes; ++i) {
    if (share[i] > counts) unseen += (unseen.empty() ? "" : ", ") + names[static_cast<std::size_t>(i)].name();
  }
  fail(header, name(point),
       fmt::format("its {} {} in the file determine {} of its {} motions: {} cannot be separated, or are not seen", out.channels.size(),
                   word(side), rank, modes, unseen),
       std::string("add ") + word(side) + " elsewhere or in other directions, or give it fewer modes (plane, flexible)");
}

}  // namespace

Eigen::RowVectorXd mode_row(const std::vector<InterfaceMode>& modes, const Vector& r, const Vector& direction, bool rotational) {
  Eigen::RowVectorXd row(at(modes.size()));
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const Vector motion = rotational ? rotation(modes[i]) : displacement(modes[i], r);
    row[at(i)] = Eigen::Vector3d(motion.data()).dot(Eigen::Vector3d(direction.data()));
  }
  return row;
}

MatrixXd weighted_inverse(const MatrixXd& modes, const VectorXd& weights) {
  const VectorXd root = weights.cwiseSqrt(), scale = lengths(modes).cwiseInverse();
  const MatrixXd scaled = root.asDiagonal() * modes * scale.asDiagonal();
  return scale.asDiagonal() * dense::RealMinimumNorm(scaled).pseudo_inverse() * root.asDiagonal();
}

Transformation transformation(const VirtualPoint& point, Side side, const frf::FrfHeader& header) {
  const bool responses = side == Side::sensors;
  const std::vector<frf::Dof>& of_file = responses ? header.response : header.reference;
  Transformation out;
  std::vector<double> weights;
  std::vector<const Channel*> channels;
  for (const Channel& channel : responses ? point.sensors : point.impacts) {
    const std::size_t index = frf::find_coordinate(of_file, channel.dof);
    if (index == frf::npos) continue;
    out.channels.push_back(index);
    out.dofs.push_back(channel.dof);
    weights.push_back(channel.weight);
    channels.push_back(&channel);
  }
  if (!out.any()) return out;
  const Eigen::Index count = at(channels.size());
  out.modes.resize(count, at(point.modes.size()));
  out.positions.resize(count, 3);
  out.directions.resize(count, 3);
  out.signs.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Channel& channel = *channels[static_cast<std::size_t>(i)];
    const Vector direction = direction_of(point, channel, header);
    Vector r = position_of(point, channel, header);
    for (std::size_t k = 0; k < 3; ++k) r[k] -= point.position[k];
    out.signs[i] = channel.dof.sign * of_file[out.channels[static_cast<std::size_t>(i)]].sign;
    out.positions.row(i) = Eigen::RowVector3d(r.data());
    out.directions.row(i) = Eigen::RowVector3d(direction.data());
    out.modes.row(i) = out.signs[i] * mode_row(point.modes, r, direction, channel.dof.is_rotation());
  }
  require_rank(point, side, header, out);
  out.to_virtual = weighted_inverse(out.modes, Eigen::Map<const VectorXd>(weights.data(), count));
  return out;
}

}  // namespace jointid::virtualpoint
