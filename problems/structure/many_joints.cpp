#include "problems/structure/many_joints.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/structure/beam.hpp"

namespace jointid::problems {
namespace {

/// Both in the plane: along the beam and across it.
struct Plane {
  double x = 0.0, y = 0.0;
};

double length_of(const BeamOfMany& beam, std::size_t part) {
  return beam.length * (1.0 + beam.variation * std::sin(1.7 * static_cast<double>(part) + beam.phase));
}

BeamSection section_of(const BeamOfMany& beam) {
  return {.width = beam.width, .thickness = beam.height, .youngs_modulus = beam.youngs_modulus, .density = beam.density};
}

/// What varies from joint to joint.
double varied(std::size_t joint, double place) { return 1.0 + 0.3 * std::sin(1.7 * (static_cast<double>(joint) + place) + 0.3); }

Structure bending_beam(const BeamOfMany& beam, std::size_t elements, double length, const BeamLine& from) {
  BeamLine line = from;
  const double start = from.x.front();
  for (std::size_t i = 1; i <= elements; ++i) line.x.push_back(start + length * static_cast<double>(i) / static_cast<double>(elements));
  Structure structure = problems::beam(section_of(beam), line);
  structure.add_proportional_damping(beam.loss_factor);
  return structure;
}

std::int64_t next_node(const std::vector<Structure>& parts) { return parts.empty() ? 1 : parts.back().nodes().back().id + 1; }

std::vector<frf::Dof> joined(std::vector<frf::Dof> a, const std::vector<frf::Dof>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

BeamJoint chain_joint(const ChainOfBeams& chain, std::size_t e, std::vector<frf::Dof> dofs, std::vector<std::size_t> parts) {
  const double cross = chain.cross * varied(e, 3.0);
  const Matrix k = {{chain.translation * varied(e, 0.0), cross}, {cross, chain.rotation * varied(e, 7.0)}};
  const Matrix d = {{chain.loss * k[0][0], 0.5 * chain.loss * cross}, {0.5 * chain.loss * cross, 1.3 * chain.loss * k[1][1]}};
  return {std::move(dofs), std::move(parts), k, d};
}

std::vector<double> spread(double first, double last, std::size_t lines) {
  std::vector<double> hz;
  for (std::size_t i = 0; i < lines; ++i) hz.push_back(first + static_cast<double>(i) * (last - first) / static_cast<double>(lines - 1));
  return hz;
}

std::vector<frf::Dof> plane_dofs(std::int64_t node) {
  return {{.node = node, .direction = frf::Direction::x},
          {.node = node, .direction = frf::Direction::y},
          {.node = node, .direction = frf::Direction::rz}};
}

/// A matrix over {u₁, v₁, θ₁, u₂, v₂, θ₂} of a beam along (c, s) from the bar's over {u₁, u₂} and the beam's over {v₁, θ₁, v₂, θ₂}, in
/// x and y.
Matrix turned(const Matrix& bar, const Matrix& bending, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix local(6, std::vector<double>(6)), out = local;
  const std::size_t along[] = {0, 3}, across[] = {1, 2, 4, 5};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) local[along[i]][along[j]] = bar[i][j];
  }
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) local[across[i]][across[j]] = bending[i][j];
  }
  Matrix turn(6, std::vector<double>(6));
  for (const std::size_t k : {std::size_t{0}, std::size_t{3}}) {
    turn[k][k] = turn[k + 1][k + 1] = c;
    turn[k][k + 1] = s;
    turn[k + 1][k] = -s;
    turn[k + 2][k + 2] = 1.0;
  }
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      for (std::size_t k = 0; k < 36; ++k) out[i][j] += turn[k / 6][i] * local[k / 6][k % 6] * turn[k % 6][j];
    }
  }
  return out;
}

Structure plane_beam(const BeamOfMany& beam, std::size_t part, std::int64_t first_node, const Plane& start, double angle) {
  const double l = length_of(beam, part) / static_cast<double>(beam.elements), area = beam.width * beam.height;
  std::vector<frf::Node> nodes;
  std::vector<frf::Dof> dofs;
  for (std::size_t i = 0; i <= beam.elements; ++i) {
    const double from = l * static_cast<double>(i);
    nodes.push_back({first_node + static_cast<std::int64_t>(i), {start.x + from * std::cos(angle), start.y + from * std::sin(angle), 0.0}});
    dofs = joined(dofs, plane_dofs(nodes.back().id));
  }
  Structure structure(nodes, dofs);
  const Matrix along = scaled({{1.0, -1.0}, {-1.0, 1.0}}, beam.youngs_modulus * area / l);
  const Matrix k = turned(along, element_stiffness(section_of(beam), l), angle);
  const Matrix m = turned(scaled({{2.0, 1.0}, {1.0, 2.0}}, beam.density * area * l / 6.0), element_mass(section_of(beam), l), angle);
  for (std::size_t i = 0; i < beam.elements; ++i) {
    const std::vector<frf::Dof> ends = joined(plane_dofs(nodes[i].id), plane_dofs(nodes[i + 1].id));
    structure.add(Kind::stiffness, ends, k);
    structure.add(Kind::mass, ends, m);
  }
  structure.add_proportional_damping(beam.loss_factor);
  return structure;
}

/// The plane grid while it is built: beams, and which of their ends meet where.
class Grid {
 public:
  explicit Grid(const FrameOfBeams& frame) : frame_(frame) {
    for (std::size_t j = 0; j < frame.rows; ++j) {
      for (std::size_t i = 0; i < frame.columns; ++i) {
        if (i + 1 < frame.columns) add(place(i, j), place(i + 1, j), at(i, j), 0.0);
        if (j + 1 < frame.rows) add(place(i, j), place(i, j + 1), at(i, j), 0.5 * std::numbers::pi);
      }
    }
    for (std::size_t i = 0; i < frame.legs; ++i) {
      feet_.push_back(frame.rows * frame.columns + i);
      add(place(i, 0), feet_.back(), at(i, 0), -0.5 * std::numbers::pi);
    }
  }

  ManyJoints joined_up() {
    for (const std::vector<End>& ends : ends_) {
      for (std::size_t k = 1; k < ends.size(); ++k)
        add_joint(joined(ends[k - 1].dofs, ends[k].dofs), {ends[k - 1].part, ends[k].part});
      if (ends.size() == 1 && std::ranges::find(feet_, ends.front().place) != feet_.end())
        add_joint(ends.front().dofs, {ends.front().part});
    }
    for (std::size_t s = 0; s < out_.parts.size(); s += frame_.spacing) out_.references.push_back(out_.parts[s].dofs()[4]);
    out_.frequency_hz = spread(30.0, 900.0, 14);
    return std::move(out_);
  }

 private:
  struct End {
    std::size_t part, place;
    std::vector<frf::Dof> dofs;
  };

  std::size_t place(std::size_t i, std::size_t j) const { return j * frame_.columns + i; }
  Plane at(std::size_t i, std::size_t j) const {
    return {frame_.beam.length * static_cast<double>(i), frame_.beam.length * static_cast<double>(j)};
  }

  void add(std::size_t from, std::size_t to, const Plane& start, double angle) {
    const std::size_t part = out_.parts.size();
    out_.parts.push_back(plane_beam(frame_.beam, part, next_node(out_.parts), start, angle));
    const std::vector<frf::Node>& nodes = out_.parts.back().nodes();
    add_end({part, from, plane_dofs(nodes.front().id)});
    add_end({part, to, plane_dofs(nodes.back().id)});
  }

  void add_end(End end) {
    const auto met = std::ranges::find_if(ends_, [&](const std::vector<End>& ends) { return ends.front().place == end.place; });
    if (met == ends_.end()) {
      ends_.push_back({std::move(end)});
    } else {
      met->push_back(std::move(end));
    }
  }

  void add_joint(std::vector<frf::Dof> dofs, std::vector<std::size_t> parts) {
    const std::size_t e = out_.joints.size();
    const double values[] = {frame_.x * varied(e, 0.0), frame_.y * varied(e, 5.0), frame_.rotation * varied(e, 2.0)};
    const double losses[] = {1.0, 1.2, 1.4};
    Matrix k(3, std::vector<double>(3)), d = k;
    for (std::size_t q = 0; q < 3; ++q) {
      k[q][q] = values[q];
      d[q][q] = frame_.loss * losses[q] * values[q];
    }
    out_.joints.push_back({std::move(dofs), std::move(parts), k, d});
  }

  const FrameOfBeams& frame_;
  std::vector<std::vector<End>> ends_;  ///< of every place, in the order of the first beam there
  std::vector<std::size_t> feet_;       ///< places on the ground
  ManyJoints out_;
};

}  // namespace

Matrix BeamJoint::over_dofs(const Matrix& relative) const {
  const std::size_t n = relative.size();
  Matrix out(dofs.size(), std::vector<double>(dofs.size()));
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    for (std::size_t j = 0; j < dofs.size(); ++j) out[i][j] = (i / n == j / n ? 1.0 : -1.0) * relative[i % n][j % n];
  }
  return out;
}

ManyJoints chain_of_beams(const ChainOfBeams& chain) {
  ManyJoints out;
  double x = 0.0;
  for (std::size_t s = 0; s <= chain.joints; ++s) {
    const double length = length_of(chain.beam, s);
    out.parts.push_back(bending_beam(chain.beam, chain.beam.elements, length, {.first_node = next_node(out.parts), .x = {x}}));
    x += length;
    if (s % chain.spacing == 0) out.references.push_back(out.parts.back().dofs()[2]);
  }
  for (std::size_t e = 0; e < chain.joints; ++e) {
    const std::int64_t last = out.parts[e].nodes().back().id, first = out.parts[e + 1].nodes().front().id;
    out.joints.push_back(chain_joint(chain, e, joined(beam_dofs(last), beam_dofs(first)), {e, e + 1}));
  }
  out.frequency_hz = spread(30.0, 330.0, 16);
  return out;
}

ManyJoints frame_of_beams(const FrameOfBeams& frame) { return Grid(frame).joined_up(); }

ManyJoints star_of_beams(const ChainOfBeams& leaves) {
  ManyJoints out;
  const std::size_t elements = leaves.joints + 1;
  out.parts.push_back(bending_beam(leaves.beam, elements, 0.25 * leaves.beam.length * static_cast<double>(elements),
                                   {.first_node = 1, .x = {0.0}}));
  out.references.push_back(out.parts[0].dofs()[2]);
  const std::vector<frf::Node> hub = out.parts[0].nodes();
  for (std::size_t e = 0; e < leaves.joints; ++e) {
    const frf::Node& node = hub[e + 1];
    out.parts.push_back(bending_beam(leaves.beam, leaves.beam.elements, length_of(leaves.beam, e + 1),
                                     {.first_node = next_node(out.parts), .x = {node.position[0]}, .y = 0.1}));
    const std::int64_t first = out.parts.back().nodes().front().id;
    out.joints.push_back(chain_joint(leaves, e, joined(beam_dofs(node.id), beam_dofs(first)), {0, e + 1}));
    if (e % leaves.spacing == 0) out.references.push_back(out.parts.back().dofs()[2]);
  }
  out.frequency_hz = spread(30.0, 330.0, 16);
  return out;
}

}  // namespace jointid::problems
