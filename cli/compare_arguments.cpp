#include "cli/compare_arguments.hpp"

#include <algorithm>
#include <sstream>

#include "cli/of_option.hpp"
#include "base/error.hpp"

namespace jointid::cli {
namespace {

[[noreturn]] void fail(const char* option, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::usage, "", option, std::move(problem), std::move(remedy)});
}

std::vector<ident::Equation> equation_set(const std::string& text) {
  std::vector<ident::Equation> set;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const ident::Equation equation = ident::parse_equation(word);
    if (std::ranges::find(set, equation) != set.end()) fail("--equations", "'" + word + "' stands twice in a set", "name it once");
    set.push_back(equation);
  }
  if (set.empty()) fail("--equations", "a set is empty", "write e.g. \"nn nj;nn nj jj jn\"");
  return set;
}

std::vector<std::vector<ident::Equation>> equation_sets(std::string text) {
  std::ranges::replace(text, ',', ' ');
  std::vector<std::vector<ident::Equation>> sets;
  if (text.empty()) return sets;
  std::istringstream pieces(text);
  for (std::string piece; std::getline(pieces, piece, ';');) sets.push_back(equation_set(piece));
  return sets;
}

void check_delta(double delta) {
  if (delta >= 0.0 && delta < 2.0) return;
  std::ostringstream text;
  text << delta << " is outside 0 <= delta < 2";
  fail("--deltas", text.str(), "0 drops no equation");
}

}  // namespace

ident::Alternatives alternatives(const CompareArguments& arguments) {
  ident::Alternatives out;
  for (const std::string& word : arguments.methods) {
    out.methods.push_back(of_option("--methods", [&] { return ident::parse_method(word); }));
  }
  out.equations = of_option("--equations", [&] { return equation_sets(arguments.equations); });
  for (const std::string& word : arguments.weightings) {
    out.weightings.push_back(of_option("--weightings", [&] { return weighting::parse_weighting(word); }));
  }
  std::ranges::for_each(arguments.deltas, check_delta);
  out.deltas = arguments.deltas;
  out.solvers = arguments.solvers;
  for (const std::string& word : arguments.regenerate) {
    out.regenerations.push_back(of_option("--regenerate", [&] { return ident::parse_regeneration(word); }));
  }
  return out;
}

void check(const CompareArguments& arguments) {
  if (arguments.scene.empty() && arguments.reproduce.empty()) {
    fail("compare", "there is nothing to compare", "name a scene, or a table of the thesis with --reproduce");
  }
  if (arguments.trials == 0) fail("--trials", "it is 0", "give 1 or more");
}

}  // namespace jointid::cli
