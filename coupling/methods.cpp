#include "coupling/methods.hpp"

#include <array>
#include <vector>

#include "base/error.hpp"

namespace jointid::coupling {
namespace {

constexpr std::array<const char*, 5> names = {"gic", "rc", "grc", "pcc", "mtc"};

}  // namespace

std::string name(Method method) { return names[static_cast<std::size_t>(method)]; }

Method parse_method(std::string_view text) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (text == names[i]) return static_cast<Method>(i);
  }
  const std::string near = nearest_word(std::string(text), names);
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = {},
                    .problem = "'" + std::string(text) + "' is no method of coupling",
                    .remedy = near.empty() ? "use gic, rc, grc, pcc or mtc" : "did you mean " + near + "?"});
}

}  // namespace jointid::coupling
