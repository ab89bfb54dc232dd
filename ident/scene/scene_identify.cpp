#include <algorithm>

#include "base/error.hpp"
#include "ident/scene/scene_sections.hpp"

namespace jointid::ident {
namespace {

using restrictions::JointSpec;
using restrictions::Kind;

const std::vector<std::string> equations = {"nn", "nj", "jj", "jn"};
const std::vector<std::string> weightings = {"none", "WA", "WB", "WBG", "WBS"};
const std::vector<std::string> variances = {"auto", "file", "noise", "local"};

/// The enumerator whose name stands at its place in `words`.
template <class Enum>
Enum read_enum(const scene::Item& item, const std::vector<std::string>& words) {
  const std::string word = item.word(words);
  return static_cast<Enum>(std::find(words.begin(), words.end(), word) - words.begin());
}

std::vector<Equation> read_equations(const scene::Item& item) {
  std::vector<Equation> result;
  for (const scene::Item& word : item.list_not_empty()) {
    const auto equation = read_enum<Equation>(word, equations);
    if (std::find(result.begin(), result.end(), equation) != result.end()) {
      word.fail("the equation '" + word.text() + "' is named twice");
    }
    result.push_back(equation);
  }
  return result;
}

double read_delta(const scene::Item& item) {
  const double delta = item.number();
  if (!(delta >= 0.0 && delta < 2.0)) {
    item.fail("delta = " + scene::number_text(delta) + " is outside 0 <= delta < 2", "0 drops no equation");
  }
  return delta;
}

std::map<Kind, Matrix> read_start(const scene::Item& item, const std::vector<JointSpec>& joints) {
  std::map<Kind, Matrix> start = read_matrices(item, joint_size(joints));
  for (const auto& [kind, matrix] : start) {
    const bool identified = std::any_of(joints.begin(), joints.end(),
                                        [k = kind](const JointSpec& joint) { return joint.matrices.contains(k); });
    if (!identified) {
      item.fail("start has " + key(kind) + ", but no joint has that matrix", "add it to the joint or leave it out");
    }
  }
  return start;
}

}  // namespace

Equation parse_equation(const std::string& text) { return static_cast<Equation>(find_word(text, equations, "equation")); }

std::string name(Equation equation) { return equations[static_cast<std::size_t>(equation)]; }

std::vector<std::string> kind_keys() {
  std::vector<std::string> keys;
  for (const Kind kind : restrictions::all_kinds) keys.push_back(restrictions::key(kind));
  return keys;
}

std::size_t joint_size(const std::vector<JointSpec>& joints) {
  std::size_t size = 0;
  for (const JointSpec& joint : joints) size += joint.dofs.size();
  return size;
}

std::map<Kind, Matrix> read_matrices(const scene::Item& item, std::size_t size) {
  const scene::Table table = item.table(kind_keys());
  std::map<Kind, Matrix> matrices;
  for (const Kind kind : restrictions::all_kinds) {
    if (const auto matrix = table.find(restrictions::key(kind))) matrices[kind] = matrix->square_matrix(size);
  }
  return matrices;
}

IdentifySection read_identify(const scene::Item& item, const std::vector<JointSpec>& joints) {
  const scene::Table table = item.table({"method", "equations", "weighting", "delta", "solver", "start", "starts", "variance",
                                       "smooth_variance", "priors", "bounds", "ties", "bootstrap", "bootstrap_seed"});
  IdentifySection identify;
  identify.automatic = true;
  if (const auto method = table.find("method")) {
    const std::string word = method->word(method_words());
    identify.automatic = word == "auto";
    if (!identify.automatic) identify.method = parse_method(word);
  }
  identify.any_weighting = !table.find("weighting") && !table.find("delta");
  if (const auto list = table.find("equations")) identify.equations = read_equations(*list);
  if (const auto word = table.find("weighting")) identify.weighting = read_enum<weighting::Weighting>(*word, weightings);
  if (const auto delta = table.find("delta")) identify.delta = read_delta(*delta);
  if (const auto solver = table.find("solver")) identify.solver = solver->word(solver_names());
  if (const auto word = table.find("variance")) identify.variance = read_enum<VarianceChoice>(*word, variances);
  if (const auto flag = table.find("smooth_variance")) identify.smooth_variance = flag->boolean();
  if (const auto start = table.find("start")) identify.start = read_start(*start, joints);
  if (const auto starts = table.find("starts")) identify.starts = read_starts(*starts);
  if (const auto priors = table.find("priors")) identify.priors = read_priors(*priors);
  if (const auto bounds = table.find("bounds")) identify.bounds = read_bounds(*bounds);
  if (const auto ties = table.find("ties")) identify.ties = read_ties(*ties);
  read_bootstrap(table, identify);
  return identify;
}

}  // namespace jointid::ident
