#include "frf/set/dof.hpp"

#include <array>
#include <charconv>

#include "base/error.hpp"

namespace jointid::frf {
namespace {

constexpr std::array<std::string_view, 6> direction_names = {"X", "Y", "Z", "RX", "RY", "RZ"};

[[noreturn]] void fail(std::string_view text) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = {},
                    .problem = "'" + std::string(text) + "' is not a DOF",
                    .remedy = "write node:direction, e.g. 4:+Y, with one of ±X ±Y ±Z ±RX ±RY ±RZ"});
}

}  // namespace

Dof Dof::parse(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || colon == 0) fail(text);
  Dof dof;
  const char* end = text.data() + colon;
  const auto [last, error] = std::from_chars(text.data(), end, dof.node);
  // Nodes are positive numbers of at most ten digits, as in UFF; the bound also keeps coordinate_key exact.
  if (error != std::errc() || last != end || dof.node < 0 || dof.node > 9'999'999'999) fail(text);
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
  return std::to_string(node) + (sign < 0 ? ":-" : ":+") +
         std::string(direction_names[static_cast<std::size_t>(direction) - 1]);
}

std::vector<std::string> names(const std::vector<Dof>& dofs) {
  std::vector<std::string> out;
  for (const Dof& dof : dofs) out.push_back(dof.name());
  return out;
}

}  // namespace jointid::frf
