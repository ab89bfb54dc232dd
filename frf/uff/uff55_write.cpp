#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>

#include "base/error.hpp"
#include "base/temporary_file.hpp"
#include "frf/uff/uff55.hpp"
#include "frf/uff/uff_write_text.hpp"

namespace jointid::frf {
namespace {

using uff::integer_field;

std::string short_real(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%13.5E", value);
  return text.data();
}

std::string long_real(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%25.16E", value);
  return text.data();
}

void write_reals(std::ostream& out, const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    out << short_real(values[i]) << ((i + 1) % 6 == 0 || i + 1 == values.size() ? "\n" : "");
  }
}

void write_preamble(std::ostream& out, const std::vector<Node>& nodes) {
  out << "    -1\n   151\nMode shapes\nNONE\njointid\nNONE\nNONE\njointid\nNONE\n    -1\n"
      << "    -1\n   164\n         1" << uff::text_field("SI: Meter (newton)", 20) << "         2\n"
      << "  1.00000000000000000D+00  1.00000000000000000D+00  1.00000000000000000D+00\n"
      << "  2.73149999999999977D+02\n    -1\n";
  if (nodes.empty()) return;
  out << "    -1\n  2411\n";
  for (const Node& node : nodes) {
    out << integer_field(node.id, 10) << "         0         0        11\n";
    for (const double coordinate : node.position) out << long_real(coordinate);
    out << '\n';
  }
  out << "    -1\n";
}

std::vector<double> constants(const Uff55Mode& mode) {
  if (!mode.is_complex) return {mode.frequency_hz, mode.modal_mass, mode.viscous_damping, mode.hysteretic_damping};
  return {mode.eigenvalue.real(), mode.eigenvalue.imag(), mode.modal_a.real(),
          mode.modal_a.imag(),    mode.modal_b.real(),    mode.modal_b.imag()};
}

/// Components node by node, with the + sign of every DOF.
std::map<std::int64_t, std::vector<Complex>> by_node(const Uff55Mode& mode, std::size_t components) {
  std::map<std::int64_t, std::vector<Complex>> nodes;
  for (std::size_t i = 0; i < mode.dofs.size(); ++i) {
    auto& node = nodes.try_emplace(mode.dofs[i].node, components).first->second;
    node[static_cast<std::size_t>(mode.dofs[i].direction) - 1] = mode.shape[i] * static_cast<double>(mode.dofs[i].sign);
  }
  return nodes;
}

void write_mode(std::ostream& out, const Uff55Mode& mode) {
  const bool rotations = std::ranges::any_of(mode.dofs, [](const Dof& dof) { return dof.is_rotation(); });
  const std::size_t components = rotations ? 6 : 3;
  out << "    -1\n    55\n";
  for (const std::string& id : mode.id) out << (id.empty() ? "NONE" : id.substr(0, 80)) << '\n';
  const std::vector<double> reals = constants(mode);
  for (const std::int64_t value : {std::int64_t{1}, std::int64_t{mode.is_complex ? 3 : 2}, std::int64_t{rotations ? 3 : 2}, std::int64_t{8},
                                   std::int64_t{mode.is_complex ? 5 : 2}, static_cast<std::int64_t>(components)}) {
    out << integer_field(value, 10);
  }
  out << '\n'
      << integer_field(2, 10) << integer_field(static_cast<std::int64_t>(reals.size()), 10) << integer_field(1, 10)
      << integer_field(mode.number, 10) << '\n';
  write_reals(out, reals);
  for (const auto& [node, values] : by_node(mode, components)) {
    out << integer_field(node, 10) << '\n';
    std::vector<double> parts;
    for (const Complex& value : values) {
      parts.push_back(value.real());
      if (mode.is_complex) parts.push_back(value.imag());
    }
    write_reals(out, parts);
  }
  out << "    -1\n";
}

}  // namespace

void write_uff55(const std::vector<Uff55Mode>& modes, const std::vector<Node>& nodes, const std::filesystem::path& path) {
  std::ostringstream out;
  write_preamble(out, nodes);
  for (const Uff55Mode& mode : modes) write_mode(out, mode);
  write_text(path, out.str());
}

}  // namespace jointid::frf
