#include "coupling/options.hpp"

#include <array>

#include "base/error.hpp"

namespace jointid::coupling {
namespace {

[[noreturn]] void fail(const std::string& where, const char* place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = where,
                    .place = place,
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

}  // namespace

std::string name(Threshold threshold) {
  constexpr std::array<const char*, 5> names = {"none", "fixed", "noise", "picard", "alpha"};
  return names[static_cast<std::size_t>(threshold)];
}

void validate(const Options& options, const std::string& where) {
  if (!(options.epsilon > 0.0 && options.epsilon < 1.0)) {
    fail(where, "epsilon", std::to_string(options.epsilon) + " is outside 0 < epsilon < 1", "0.01 is usual");
  }
  if (!(options.alpha > 0.0 && options.alpha < 2.0)) {
    fail(where, "alpha", std::to_string(options.alpha) + " is outside 0 < alpha < 2", "0.3 is usual");
  }
  if (options.threshold == Threshold::none) return;
  const bool mtc = options.method == Method::mtc;
  const bool one_step = options.method == Method::grc || options.method == Method::pcc;
  if (options.threshold == Threshold::alpha ? mtc : one_step) return;
  fail(where, "threshold", "method " + name(options.method) + " has no threshold \"" + name(options.threshold) + "\"",
       options.threshold == Threshold::alpha ? "use method \"mtc\"" : "use method \"grc\" or \"pcc\"");
}

}  // namespace jointid::coupling
