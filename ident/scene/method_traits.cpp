#include "ident/scene/method_traits.hpp"

#include <algorithm>
#include <array>

#include "base/error.hpp"

namespace jointid::ident {
namespace {

/// In the order of Solver.
constexpr std::array solver_words = {"auto",  "qr",    "normal", "spqr",  "cholmod", "ldlt",          "levenberg-marquardt", "newton",
                                     "ceres", "ipopt", "pattern", "gauss-helmert", "iqml", "by-parts"};

}  // namespace

const MethodTraits& traits(Method method) { return all_methods()[static_cast<std::size_t>(method)]; }

bool takes_frfs_as_measured(Method method) {
  const MethodTraits& of = traits(method);
  return !of.iterates && of.joint_on_assembly && !of.inverts_substructures;
}

std::string name(Method method) { return traits(method).name; }

std::string name(Solver solver) { return solver_words[static_cast<std::size_t>(solver)]; }

Solver parse_solver(const std::string& text) {
  return static_cast<Solver>(find_word(text, {solver_words.begin(), solver_words.end()}, "solver"));
}

Method parse_method(const std::string& text) { return all_methods()[find_word(text, method_names(), "method")].method; }

bool weighs_equations(Method method) { return !traits(method).iterates; }

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const MethodTraits& each : all_methods()) names.push_back(each.name);
  return names;
}

std::vector<std::string> method_words() {
  std::vector<std::string> words = method_names();
  words.emplace_back("auto");
  return words;
}

std::vector<std::string> solver_names() {
  std::vector<std::string> names = {"auto"};
  for (const MethodTraits& each : all_methods()) {
    for (const std::string& solver : ident::names(each.solvers)) {
      if (std::ranges::find(names, solver) == names.end()) names.push_back(solver);
    }
  }
  return names;
}

std::vector<std::string> names(const std::vector<Solver>& solvers) {
  std::vector<std::string> out;
  for (const Solver solver : solvers) out.push_back(name(solver));
  return out;
}

}  // namespace jointid::ident
