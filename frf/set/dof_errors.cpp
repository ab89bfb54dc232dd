#include "frf/set/dof_errors.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::frf {
namespace {

/// Blocks of the counter coordinate_key(dof).
constexpr std::uint64_t sign_block = (std::uint64_t{1} << 33), position_block = sign_block + 1;

const Node* find_node(const FrfHeader& header, std::int64_t id) {
  const auto found = std::find_if(header.nodes.begin(), header.nodes.end(), [&](const Node& node) { return node.id == id; });
  return found == header.nodes.end() ? nullptr : &*found;
}

double distance(const Node& a, const Node& b) {
  return std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1], a.position[2] - b.position[2]);
}

}  // namespace

DofErrors::DofErrors(const FrfHeader& header, double sign, double position) : sign_(sign), position_(position) {
  if (position_ > 0.0) {
    of_responses_ = neighbours(header, header.response);
    of_references_ = neighbours(header, header.reference);
  } else {
    of_responses_.resize(header.response.size());
    of_references_.resize(header.reference.size());
  }
  line_.resize(header.entries());
}

std::vector<DofErrors::Neighbour> DofErrors::neighbours(const FrfHeader& header, const std::vector<Dof>& dofs) {
  std::vector<Neighbour> near(dofs.size());
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    const Node* here = find_node(header, dofs[i].node);
    for (std::size_t j = 0; here != nullptr && j < dofs.size(); ++j) {
      const Node* there = dofs[j].direction == dofs[i].direction ? find_node(header, dofs[j].node) : nullptr;
      const double d = there == nullptr ? 0.0 : distance(*here, *there);
      if (d > 0.0 && (near[i].index == npos || d < near[i].distance)) near[i] = {j, d};
    }
  }
  return near;
}

std::vector<DofErrors::Mix> DofErrors::draw(const std::vector<Dof>& dofs, const std::vector<Neighbour>& near,
                                            const RandomStream& stream) const {
  std::vector<Mix> mix(dofs.size());
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    const auto key = static_cast<std::uint64_t>(coordinate_key(dofs[i]));
    const double sign = uniform_numbers(stream, key, sign_block)[0] < sign_ ? -1.0 : 1.0;
    mix[i].own = sign;
    if (near[i].index == npos) continue;
    const double share = position_ * normal_numbers(stream, key, position_block)[0] / near[i].distance;
    const double same_way = dofs[i].sign * dofs[near[i].index].sign;
    mix[i] = {near[i].index, sign * (1.0 - share), sign * share * same_way};
  }
  return mix;
}

void DofErrors::apply(FrfSet& set, const RandomStream& stream) {
  const std::vector<Mix> rows = draw(set.header.response, of_responses_, stream);
  const std::vector<Mix> columns = draw(set.header.reference, of_references_, stream);
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    Complex* values = set.values.data() + line * line_.size();
    for (std::size_t r = 0; r < rows.size(); ++r) {
      for (std::size_t c = 0; c < columns.size(); ++c) {
        Complex& to = line_[r * columns.size() + c];
        to = rows[r].own * values[r * columns.size() + c];
        if (rows[r].neighbour != npos) to += rows[r].other * values[rows[r].neighbour * columns.size() + c];
      }
    }
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const Complex* from = line_.data() + r * columns.size();
      for (std::size_t c = 0; c < columns.size(); ++c) {
        Complex& to = values[r * columns.size() + c];
        to = columns[c].own * from[c];
        if (columns[c].neighbour != npos) to += columns[c].other * from[columns[c].neighbour];
      }
    }
  }
}

}  // namespace jointid::frf
