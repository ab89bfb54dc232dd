#include "restrictions/joint_spec.hpp"

namespace jointid::restrictions {
namespace {

struct Names {
  const char* key;
  const char* symbol;
};

constexpr std::array<Names, 4> names = {
    {{"stiffness", "K"}, {"mass", "M"}, {"viscous_damping", "C"}, {"hysteretic_damping", "D"}}};

}  // namespace

std::string key(Kind kind) { return names[static_cast<std::size_t>(kind)].key; }

std::string symbol(Kind kind) { return names[static_cast<std::size_t>(kind)].symbol; }

}  // namespace jointid::restrictions
