#include "report/export/export_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "restrictions/unit.hpp"

namespace jointid::report {
namespace {

constexpr double rounding = 1e-14;     ///< of the sum of the sizes that a difference is made of
constexpr double symmetric_to = 1e-9;  ///< of the largest element
constexpr double metre = 1000.0;       ///< mm

/// What a value in SI units is in N, mm, s and tonnes: force and translation of row and column.
double length_factor(const frf::Dof& row, const frf::Dof& column) {
  return (row.is_rotation() ? metre : 1.0) / (column.is_rotation() ? 1.0 : metre);
}

}  // namespace

ExportedMatrices::ExportedMatrices(const tasks::ExportedJoint& joint, const ExportOptions& options)
    : joint_(joint), options_(options) {
  std::erase_if(joint_.matrices, [](const auto& each) {
    return std::ranges::all_of(
        each.second, [](const auto& row) { return std::ranges::all_of(row, [](double value) { return value == 0.0; }); });
  });
  if (joint_.matrices.empty()) refuse("all matrices are zero", "there is no joint to write");
}

CardValue ExportedMatrices::at(Kind kind, std::size_t row, std::size_t column) const {
  if (!has(kind)) return {};
  const double factor = options_.millimetres ? length_factor(joint_.dofs[row], joint_.dofs[column]) : 1.0;
  const auto errors = joint_.errors.find(kind);
  return {factor * joint_.matrices.at(kind)[row][column],
          errors == joint_.errors.end() ? std::numeric_limits<double>::quiet_NaN() : factor * errors->second[row][column]};
}

bool ExportedMatrices::is_symmetric(Kind kind) const {
  double largest = 0.0, off = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t j = 0; j < size(); ++j) {
      largest = std::max(largest, std::abs(at(kind, i, j).value));
      off = std::max(off, std::abs(at(kind, i, j).value - at(kind, j, i).value));
    }
  }
  return off <= symmetric_to * largest;
}

bool ExportedMatrices::is_symmetric() const {
  return std::ranges::all_of(restrictions::all_kinds, [this](Kind kind) { return is_symmetric(kind); });
}

std::vector<Link> ExportedMatrices::links() const {
  std::map<std::pair<std::size_t, std::size_t>, Link> found;  // second = size(): the ground
  for (const Kind kind : restrictions::all_kinds) {
    for (std::size_t i = 0; i < size(); ++i) {
      double rest = 0.0, sum = 0.0;
      std::size_t others = 0;
      for (std::size_t j = 0; j < size(); ++j) {
        const CardValue value = at(kind, i, j);
        rest += value.value;
        sum += std::abs(value.value);
        if (i == j || value.value == 0.0) continue;
        ++others;
        if (i < j) found[{i, j}].by_kind[kind] = {-value.value, value.error};
      }
      if (std::abs(rest) > rounding * sum)
        found[{i, size()}].by_kind[kind] = {rest, others == 0 ? at(kind, i, i).error : std::numeric_limits<double>::quiet_NaN()};
    }
  }
  std::vector<Link> out;
  for (auto& [place, link] : found) {
    link.first = place.first;
    if (place.second < size()) link.second = place.second;
    out.push_back(std::move(link));
  }
  return out;
}

std::string ExportedMatrices::unit(Kind kind, std::size_t row, std::size_t column) const {
  std::string unit = restrictions::unit(kind, joint_.dofs[row], joint_.dofs[column]);
  if (!options_.millimetres) return unit;
  std::string out;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const bool metres = unit[i] == 'm' && (i == 0 || !std::isalpha(static_cast<unsigned char>(unit[i - 1]))) &&
                        (i + 1 == unit.size() || !std::isalpha(static_cast<unsigned char>(unit[i + 1])));
    out += metres ? "mm" : std::string(1, unit[i]);
  }
  if (out.starts_with("kg")) out = "t" + out.substr(2);
  return out;
}

std::string ExportedMatrices::value_text(Kind kind, const CardValue& value, std::size_t row, std::size_t column) const {
  std::string text = fmt::format(" = {:.6g} {}, standard error ", value.value, unit(kind, row, column));
  if (std::isnan(value.error)) return text + "not stated";
  return value.error == 0.0 ? text + "0 (known)" : text + fmt::format("{:.3g}", value.error);
}

std::string ExportedMatrices::remark(Kind kind, std::size_t row, std::size_t column) const {
  return fmt::format("{}({},{})", restrictions::symbol(kind), joint_.dofs[row].name(), joint_.dofs[column].name()) +
         value_text(kind, at(kind, row, column), row, column);
}

std::string ExportedMatrices::remark(Kind kind, const Link& link) const {
  return fmt::format("{} between {} and {}", restrictions::symbol(kind), joint_.dofs[link.first].name(),
                     link.second ? joint_.dofs[*link.second].name() : "ground") +
         value_text(kind, link.of(kind), link.first, link.second.value_or(link.first));
}

std::vector<std::string> ExportedMatrices::head() const {
  return {"jointid: joint of " + joint_.source + ", status " + joint_.status,
          "Z(omega) = K - omega^2 M + i (omega C + D), D hysteretic; units: " +
              std::string(options_.millimetres ? "N, mm, s, t, rad" : "N, m, s, kg, rad"),
          "DOFs are node:direction in the axes of the measurement. The nodes of the mesh need these numbers and",
          "displacement systems along these axes."};
}

void ExportedMatrices::refuse(const std::string& problem, const std::string& remedy) const {
  throw InputError({.kind = ErrorKind::usage, .file = joint_.source, .place = "export", .problem = problem, .remedy = remedy});
}

bool consists_of_springs(const ExportedMatrices& of) {
  if (!of.is_symmetric() || of.has(Kind::mass)) return false;
  return std::ranges::all_of(of.links(), [&](const Link& link) {
    const bool straight = !link.second || of.dofs()[link.first].direction == of.dofs()[*link.second].direction;
    const bool lossy_only = link.has(Kind::hysteretic_damping) && !link.has(Kind::stiffness);
    return straight && !lossy_only && std::ranges::all_of(link.by_kind, [](const auto& each) { return each.second.value > 0.0; });
  });
}

std::vector<Bush> bushes(const ExportedMatrices& of) {
  std::map<std::pair<std::int64_t, std::int64_t>, Bush> found;
  for (const Link& link : of.links()) {
    const frf::Dof& first = of.dofs()[link.first];
    if (link.second && (of.dofs()[*link.second].direction != first.direction || of.dofs()[*link.second].node == first.node)) {
      of.refuse(of.remark(link.by_kind.begin()->first, link) + ": a bush has one direction each, between two nodes",
                "write whole matrices: --as matrix");
    }
    if (link.has(Kind::mass)) of.refuse("a bush has no mass, and the joint has", "write whole matrices: --as matrix");
    const std::int64_t second = link.second ? of.dofs()[*link.second].node : 0;
    Bush& bush = found[{first.node, second}];
    bush.first = first.node;
    if (link.second) bush.second = second;
    bush.by_direction[component(first)] = link;
  }
  std::vector<Bush> out;
  for (auto& [nodes, bush] : found) out.push_back(std::move(bush));
  return out;
}

int component(const frf::Dof& dof) { return static_cast<int>(dof.direction); }

std::string sixteen(double value) {
  for (int decimals = 14; decimals > 0; --decimals) {
    const std::string text = fmt::format("{:.{}E}", value, decimals);
    const std::size_t e = text.find('E');
    const std::string exponent = text.substr(e + 2);
    const std::string shown =
        text.substr(0, e) + text[e + 1] + exponent.substr(std::min(exponent.find_first_not_of('0'), exponent.size() - 1));
    if (shown.size() <= 16) return shown;
  }
  return fmt::format("{:.1E}", value);
}

}  // namespace jointid::report
