#include "frf/set/dof.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string>

#include "base/error.hpp"
#include "frf/set/virtual_node.hpp"
#include "frf/text/direction_names.hpp"
#include "frf/text/proposed_dof.hpp"

namespace jointid::frf {
namespace {

constexpr std::array<std::string_view, 3> virtual_endings = {"", "E", "S"};

/// "21" of "PART-1-1.21", a node of a finite-element program without a direction; empty for anything else.
std::string_view node_of_label(std::string_view text) {
  const std::size_t dot = text.rfind('.');
  if (dot == std::string_view::npos || dot == 0 || std::isalpha(static_cast<unsigned char>(text.front())) == 0) return {};
  const std::string_view number = text.substr(dot + 1);
  const bool whole = !number.empty() && number.size() <= 10 && number.find_first_not_of("0123456789") == std::string_view::npos;
  return whole ? number : std::string_view();
}

[[noreturn]] void fail(std::string_view text) {
  std::string near = proposed_dof(text);
  if (const std::string_view node = node_of_label(text); near.empty() && !node.empty())
    near = std::string(node) + ":+X, or another direction of node " + std::string(node);
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = {},
                    .problem = "'" + std::string(text) + "' is not a DOF",
                    .remedy = (near.empty() ? "" : "did you mean " + near + "? ") +
                              std::string(near.empty() ? "write" : "Write") +
                              " node:direction, e.g. 4:+Y, with one of ±X ±Y ±Z ±RX ±RY ±RZ"});
}

/// A whole number that is all of the text; -1 where it is none.
std::int64_t whole_number(std::string_view text) {
  std::int64_t number = -1;
  const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && last == text.data() + text.size() ? number : -1;
}

/// The node of "VP1", "VP1E", "VP1S"; 0 where the text is none of them.
std::int64_t parse_virtual_node(std::string_view text) {
  if (!text.starts_with("VP")) return 0;
  text.remove_prefix(2);
  const std::size_t digits = text.find_first_not_of("0123456789");
  const std::string_view ending = digits == std::string_view::npos ? std::string_view() : text.substr(digits);
  const auto kind = std::find(virtual_endings.begin(), virtual_endings.end(), ending);
  const std::int64_t point = whole_number(text.substr(0, digits));
  if (kind == virtual_endings.end() || point < 1 || point > largest_virtual_point) return 0;
  return virtual_node(point, static_cast<VirtualNode>(kind - virtual_endings.begin()));
}

std::string node_name(std::int64_t node) {
  if (!is_virtual(node)) return std::to_string(node);
  return "VP" + std::to_string(point_of(node)) + std::string(virtual_endings[static_cast<std::size_t>(kind_of(node))]);
}

}  // namespace

Dof Dof::parse(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || colon == 0) fail(text);
  Dof dof;
  dof.node = parse_virtual_node(text.substr(0, colon));
  if (dof.node == 0) {
    // Measured nodes are positive numbers of at most ten digits, as in UFF; the bound also keeps coordinate_key exact.
    dof.node = whole_number(text.substr(0, colon));
    if (dof.node < 0 || dof.node > 9'999'999'999) fail(text);
  }
  std::string_view direction = text.substr(colon + 1);
  if (!direction.empty() && (direction[0] == '+' || direction[0] == '-')) {
    dof.sign = direction[0] == '-' ? -1 : +1;
    direction.remove_prefix(1);
  }
  for (std::size_t i = 0; i < direction_names.size(); ++i) {
    if (direction == direction_names[i]) {
      dof.direction = static_cast<Direction>(i + 1);
      return dof;
    }
  }
  fail(text);
}

std::string Dof::name() const {
  return node_name(node) + (sign < 0 ? ":-" : ":+") + std::string(direction_names[static_cast<std::size_t>(direction) - 1]);
}

std::vector<std::string> names(const std::vector<Dof>& dofs) {
  std::vector<std::string> out;
  for (const Dof& dof : dofs) out.push_back(dof.name());
  return out;
}

}  // namespace jointid::frf
