#include "gui/geometry/structure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "base/control.hpp"
#include "base/error.hpp"
#include "frf/file/file_head.hpp"
#include "frf/file/node_table.hpp"

namespace jointid::gui {
namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{256} << 20;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Within a thousandth of their distance from the first to the last.
bool are_straight(const std::vector<frf::Node>& nodes) {
  const Vector all = minus(nodes.back().position, nodes.front().position);
  return std::ranges::all_of(nodes, [&](const frf::Node& node) {
    return length(cross(all, minus(node.position, nodes.front().position))) <= 1e-3 * length(all) * length(all);
  });
}

/// Of the nodes that carry a DOF of the file.
std::vector<frf::NodeLine> joined(const LoadedFile& file) {
  std::set<std::int64_t> used;
  for (const auto* dofs : {&file.header.response, &file.header.reference}) {
    for (const frf::Dof& dof : *dofs) used.insert(dof.node);
  }
  std::vector<frf::Node> nodes = file.header.nodes;
  std::erase_if(nodes, [&](const frf::Node& node) { return !used.contains(node.id); });
  std::ranges::sort(nodes, {}, &frf::Node::id);
  std::vector<frf::NodeLine> lines;
  if (nodes.size() < 2 || !are_straight(nodes)) return lines;
  for (std::size_t i = 1; i < nodes.size(); ++i) lines.push_back({nodes[i - 1].id, nodes[i].id});
  return lines;
}

bool are_directions_known(const frf::Node& node) {
  const auto is_finite = [](const Vector& axis) { return std::ranges::all_of(axis, [](double x) { return std::isfinite(x); }); };
  return !node.axes || std::ranges::all_of(*node.axes, is_finite);
}

/// The file that shows motion by the reference, and which of its references it is.
std::pair<const LoadedFile*, std::size_t> source_of(const std::vector<LoadedFile>& files, const frf::Dof& reference) {
  for (const LoadedFile& file : files) {
    if (!shows_motion(file, files)) continue;
    const std::size_t place = frf::find_coordinate(file.header.reference, reference);
    if (place != frf::npos) return {&file, place};
  }
  return {nullptr, 0};
}

}  // namespace

Structure structure_of(const std::vector<LoadedFile>& files, const std::vector<frf::NodeLine>& lines) {
  Structure out;
  std::map<std::int64_t, frf::Node> nodes;
  std::map<std::int64_t, frf::Dof> dofs;
  std::vector<frf::NodeLine> all = lines;
  int part = 0;
  for (const LoadedFile& file : files) {
    for (const frf::Node& node : file.header.nodes) nodes.emplace(node.id, node);
    if (!file.error.empty()) continue;
    for (const auto* list : {&file.header.response, &file.header.reference}) {
      for (const frf::Dof& dof : *list) {
        dofs.emplace(frf::coordinate_key(dof), dof);
        if (!file.is_assembly) out.part.emplace(dof.node, part);
      }
    }
    if (!file.is_assembly) ++part;
    if (!lines.empty() || file.is_assembly) continue;
    const std::vector<frf::NodeLine> own = joined(file);
    all.insert(all.end(), own.begin(), own.end());
  }
  for (const auto& [id, node] : nodes) out.nodes.push_back(node);
  for (const frf::NodeLine& line : all) {
    if (nodes.contains(line[0]) && nodes.contains(line[1])) out.lines.push_back(line);
  }
  for (const auto& [key, dof] : dofs) {
    const auto node = nodes.find(dof.node);
    (node != nodes.end() && are_directions_known(node->second) ? out.dofs : out.unplaced).push_back(dof);
  }
  return out;
}

namespace {

/// Of a universal file, or of a table of positions.
void add_lines(const ident::Path& path, bool is_table, std::vector<frf::NodeLine>& out) {
  std::error_code none;
  if (path.empty() || !(is_table || frf::is_universal_file(path)) || std::filesystem::file_size(path, none) > largest_file || none)
    return;
  try {
    const std::vector<frf::NodeLine> own = is_table ? frf::read_node_lines(path) : frf::read_uff_lines(path);
    out.insert(out.end(), own.begin(), own.end());
  } catch (const InputError&) {
    return;  // the data page says what is wrong with the file
  }
}

}  // namespace

std::vector<frf::NodeLine> drawn_lines(const ident::DataSection& data, const std::function<bool()>& interrupted) {
  std::vector<frf::NodeLine> out;
  for (const auto* list : {&data.substructures, &data.assembly}) {
    for (const ident::DataFile& file : *list) {
      stop_if(interrupted);
      add_lines(file.path, false, out);
      add_lines(file.nodes.value_or(ident::Path()), true, out);
    }
  }
  return out;
}

Extent extent_of(const Structure& structure) {
  if (structure.nodes.empty()) return {};
  Vector low = structure.nodes.front().position, high = low;
  for (const frf::Node& node : structure.nodes) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], node.position[i]);
      high[i] = std::max(high[i], node.position[i]);
    }
  }
  const double radius = length(minus(high, low)) / 2.0;
  return {{(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0, (low[2] + high[2]) / 2.0}, radius > 0.0 ? radius : 1.0};
}

Vector direction_of(const frf::Node& node, const frf::Dof& dof) {
  Vector out = node.axes.value_or(frf::global_axes)[(static_cast<std::size_t>(dof.direction) - 1) % 3];
  for (double& x : out) x *= dof.sign;
  return out;
}

Shape in_global_axes(const Shape& shape, const std::vector<frf::Node>& nodes) {
  Shape out;
  for (const frf::Node& node : nodes) {
    const auto found = shape.find(node.id);
    if (found == shape.end() || !are_directions_known(node)) continue;
    const frf::Axes axes = node.axes.value_or(frf::global_axes);
    std::array<std::complex<double>, 3> motion{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) motion[k] += found->second[i] * axes[i][k];
    }
    out.emplace(node.id, motion);
  }
  return out;
}

bool shows_motion(const LoadedFile& file, const std::vector<LoadedFile>& files) {
  return file.error.empty() && (file.is_assembly || std::ranges::none_of(files, &LoadedFile::is_assembly));
}

Deflection deflection_at(const std::vector<LoadedFile>& files, const frf::Dof& reference, double frequency_hz) {
  const auto [file, place] = source_of(files, reference);
  if (file == nullptr) return {};
  Curve axis;
  axis.frequency_hz = file->header.frequency_hz;
  const std::vector<std::size_t> lines = {nearest_line(axis, frequency_hz)}, references = {place};
  std::vector<std::size_t> responses(file->header.response.size());
  std::iota(responses.begin(), responses.end(), 0U);
  const frf::Block block{lines, responses, references};
  std::vector<Complex> values(block.size());
  file->source->read(block, values);
  Deflection out{{}, axis.frequency_hz[lines[0]]};
  for (std::size_t r = 0; r < responses.size(); ++r) {
    const frf::Dof& dof = file->header.response[r];
    if (dof.is_rotation() || !std::isfinite(std::abs(values[r]))) continue;
    out.shape[dof.node][static_cast<std::size_t>(dof.direction) - 1] = static_cast<double>(dof.sign) * values[r];
  }
  return out;
}

}  // namespace jointid::gui
