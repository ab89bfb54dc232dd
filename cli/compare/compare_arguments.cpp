#include "cli/compare/compare_arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "base/error.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/of_option.hpp"

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
    if (std::ranges::find(set, equation) != set.end())
      fail("--equations", "'" + word + "' occurs twice in a set", "name it once");
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

void declare(CLI::App& command, CompareArguments& arguments) {
  CLI::Option* scene =
      command.add_option("SCENE", arguments.scene, "Scene file (TOML) with [truth] and [noise], or one of friction laws");
  const auto list = [&command](const char* name, auto& to, const char* what) {
    return command.add_option(name, to, what)->delimiter(',');
  };
  const std::vector<CLI::Option*> alternatives = {
      list("--methods", arguments.methods, "Methods to compare, e.g. one,two; default: the scene's"),
      command.add_option("--equations", arguments.equations, "Sets of equations, e.g. \"nn nj;nn nj jj jn\"; default: the scene's"),
      list("--weightings", arguments.weightings, "Weightings, of none,WA,WB,WBG,WBS; default: the scene's"),
      list("--deltas", arguments.deltas, "Limits Δ below which equations are dropped, e.g. 0,0.05,0.1; default: the scene's"),
      list("--solvers", arguments.solvers, "Solvers, of qr,normal,spqr; default: the scene's"),
      list("--regenerate", arguments.regenerate,
           "FRFs to synthesise from modal models: none,substructures,assembly,substructures+assembly")};
  CLI::Option* reproduce = command.add_option("--reproduce", arguments.reproduce,
                                              "Instead of a scene: a table of Ren's thesis beside ours, e.g. 6.3; or list");
  reproduce->excludes(scene);
  for (CLI::Option* option : alternatives) reproduce->excludes(option);
  add_trial_options(&command, arguments);
  add_outputs(&command, arguments, "the figures", "the figures", "tables and plots");
  command.footer(
      "Examples:\n  jointid problem write B b --clean && jointid compare b/B.toml --weightings WA,WBS --deltas 0,0.05,0.1\n"
      "  jointid compare --reproduce 6.9 --report table.html\n"
      "  jointid problem write sdof-iwan iwan && jointid compare iwan/sdof-iwan.toml --trials 20");
}

study::Alternatives alternatives(const CompareArguments& arguments) {
  study::Alternatives out;
  for (const std::string& word : arguments.methods) {
    out.methods.push_back(of_option("--methods", [&] { return ident::parse_method(word); }));
  }
  out.equations = of_option("--equations", [&] { return equation_sets(arguments.equations); });
  for (const std::string& word : arguments.weightings) {
    out.weightings.push_back(of_option("--weightings", [&] { return weighting::parse_weighting(word); }));
  }
  std::ranges::for_each(arguments.deltas, check_delta);
  out.deltas = arguments.deltas;
  for (const std::string& word : arguments.solvers) {
    out.solvers.push_back(of_option("--solvers", [&] { return ident::parse_solver(word); }));
  }
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

void refuse_alternatives(const CompareArguments& arguments) {
  const std::pair<const char*, bool> given[] = {
      {"--methods", !arguments.methods.empty()},       {"--equations", !arguments.equations.empty()},
      {"--weightings", !arguments.weightings.empty()}, {"--deltas", !arguments.deltas.empty()},
      {"--solvers", !arguments.solvers.empty()},       {"--regenerate", !arguments.regenerate.empty()}};
  const auto wrong = std::ranges::find_if(given, [](const auto& option) { return option.second; });
  if (wrong == std::end(given)) return;
  throw InputError({ErrorKind::usage, arguments.scene.string(), wrong->first,
                    "the scene is one of friction laws: its ways are the likelihood and two steps", "leave it out"});
}

}  // namespace jointid::cli
