#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "ident/scene/scene_sections.hpp"
#include "restrictions/restriction.hpp"

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

/// Whether one number could be meant for all unknowns of a matrix: they are springs or stand on the diagonal, so that what each of them
/// makes is semidefinite (no row whose diagonal is smaller than the rest).
bool takes_one_number(const restrictions::Restriction& all, Kind kind) {
  for (const restrictions::MatrixTerms& matrix : all.matrices) {
    if (matrix.kind != kind) continue;
    std::map<std::pair<std::size_t, std::size_t>, double> margins;
    for (const restrictions::Term& term : matrix.terms) {
      margins[{term.unknown, term.row}] += term.row == term.column ? term.coefficient : -std::abs(term.coefficient);
    }
    if (std::ranges::any_of(margins, [](const auto& margin) { return margin.second < 0.0; })) return false;
  }
  return true;
}

bool is_numbers(const scene::Item& item) {
  return item.is_list() && std::ranges::none_of(item.list(), [](const scene::Item& entry) { return entry.is_list(); });
}

/// Names of the unknowns of a matrix, in order, and their places among all.
std::vector<std::pair<std::string, std::size_t>> unknowns_of(const restrictions::Restriction& all, Kind kind) {
  std::vector<std::pair<std::string, std::size_t>> found;
  for (std::size_t i = 0; i < all.unknowns.size(); ++i) {
    if (all.unknowns[i].kind == kind) found.emplace_back(all.unknowns[i].name, i);
  }
  return found;
}

/// The value of one unknown: a number for all, one of a list in their order, or one of a table by the name.
double value_of(const scene::Item& item, const std::string& name, std::size_t place) {
  if (item.is_list()) return item.list()[place].number();
  if (!item.is_table()) return item.number();
  const scene::Table table = item.open_table();
  const std::size_t dot = name.find_last_of('.');
  if (const auto whole = table.find(name)) return whole->number();
  if (const auto last = table.find(dot == std::string::npos ? name : name.substr(dot + 1))) return last->number();
  item.fail("has no value of " + name + (table.members().empty() ? "" : ", but one of " + table.members().front().first),
            "give one for each unknown, by the names of `jointid plan`");
}

/// The matrix of all joints by the values of its unknowns.
Matrix matrix_of_values(const scene::Item& item, const std::vector<JointSpec>& joints, const restrictions::Restriction& all,
                        Kind kind) {
  const auto unknowns = unknowns_of(all, kind);
  std::vector<double> values(all.unknowns.size(), 0.0);
  for (std::size_t i = 0; i < unknowns.size(); ++i) values[unknowns[i].second] = value_of(item, unknowns[i].first, i);
  const std::vector<double> flat = all.matrix(kind, values);
  Matrix matrix(joint_size(joints));
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    const auto row = flat.begin() + static_cast<std::ptrdiff_t>(i * matrix.size());
    matrix[i].assign(row, row + static_cast<std::ptrdiff_t>(matrix.size()));
  }
  return matrix;
}

/// The matrix of all joints of numbers for its unknowns.
Matrix matrix_of_numbers(const scene::Item& item, const std::vector<JointSpec>& joints, Kind kind) {
  const restrictions::Restriction all = item.here([&] { return restrictions::build(joints); });
  if (!item.is_list() && !item.is_table() && !takes_one_number(all, kind)) {
    item.fail("one number is for springs or a diagonal", "give the matrix, [[…], …]");
  }
  const auto unknowns = unknowns_of(all, kind);
  const std::size_t found = item.is_list() ? item.list().size() : item.is_table() ? item.open_table().members().size() : unknowns.size();
  if (found != unknowns.size()) {
    std::string names;
    constexpr std::size_t most = 8;
    for (std::size_t i = 0; i < std::min(most, unknowns.size()); ++i) names += (i > 0 ? ", " : "") + unknowns[i].first;
    item.fail(std::to_string(found) + (found == 1 ? " number for " : " numbers for ") + std::to_string(unknowns.size()) +
                  " unknowns, " + names + (unknowns.size() > most ? ", …" : ""),
              "give one for each, in this order, or the matrix, [[…], …]");
  }
  return matrix_of_values(item, joints, all, kind);
}

/// "k1" of "K.k1", "K(1,1)" as it is.
std::string short_name(const std::string& name) { return name.substr(name.find_last_of('.') + 1); }

/// `{ "K.k1" = 1e6, "D.k1" = 1e4 }` or, of the stiffness, `{ k1 = 1e6 }`: the unknowns of each kind by name. Empty where no key
/// is an unknown, or one is a kind.
std::map<Kind, Matrix> read_start_by_name(const scene::Item& item, const std::vector<JointSpec>& joints) {
  std::map<Kind, Matrix> start;
  const scene::Table table = item.open_table();
  const restrictions::Restriction all = item.here([&] { return restrictions::build(joints); });
  std::vector<std::string> valid;
  for (const Kind kind : restrictions::all_kinds) {
    if (table.find(restrictions::key(kind))) return {};
    const auto unknowns = unknowns_of(all, kind);
    const auto given = [&](const auto& unknown) {
      valid.push_back(kind == Kind::stiffness && !table.find(unknown.first) ? short_name(unknown.first) : unknown.first);
      return table.find(valid.back()).has_value();
    };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(unknowns, given));
    if (count > 0 && count < unknowns.size())
      item.fail(std::to_string(count) + " values for the " + std::to_string(unknowns.size()) + " unknowns of " +
                    restrictions::key(kind),
                "give one for each");
    if (count > 0) start[kind] = Matrix();
  }
  if (!start.empty()) item.table(valid);
  for (auto& [kind, matrix] : start) matrix = matrix_of_values(item, joints, all, kind);
  return start;
}

Matrix read_start_matrix(const scene::Item& item, const std::vector<JointSpec>& joints, Kind kind) {
  return item.is_list() && !is_numbers(item) ? item.square_matrix(joint_size(joints)) : matrix_of_numbers(item, joints, kind);
}

std::map<Kind, Matrix> read_start(const scene::Item& item, const std::vector<JointSpec>& joints) {
  std::map<Kind, Matrix> start = item.is_table() ? read_start_by_name(item, joints) : std::map<Kind, Matrix>();
  if (!start.empty()) return start;
  if (item.is_table()) {
    const scene::Table table = item.table(kind_keys());
    for (const Kind kind : restrictions::all_kinds) {
      if (const auto matrix = table.find(restrictions::key(kind))) start[kind] = read_start_matrix(*matrix, joints, kind);
    }
  } else if (item.is_list() && !is_numbers(item)) {
    item.fail("expected a table, found an array of " + std::to_string(item.list().size()),
              "write start = { stiffness = [[…], …] }");
  } else {
    start[Kind::stiffness] = read_start_matrix(item, joints, Kind::stiffness);
  }
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
                                       "smooth_variance", "priors", "bounds", "ties", "inequalities", "passive",
                                         "frequencies", "loose", "bootstrap", "bootstrap_seed"});
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
  if (const auto solver = table.find("solver")) identify.solver = parse_solver(solver->word(solver_names()));
  if (const auto word = table.find("variance")) identify.variance = read_enum<VarianceChoice>(*word, variances);
  if (const auto flag = table.find("smooth_variance")) identify.smooth_variance = flag->boolean();
  if (const auto start = table.find("start")) identify.start = read_start(*start, joints);
  if (const auto starts = table.find("starts")) identify.starts = read_starts(*starts);
  if (const auto priors = table.find("priors")) identify.priors = read_priors(*priors);
  if (const auto bounds = table.find("bounds")) identify.bounds = read_bounds(*bounds);
  if (const auto ties = table.find("ties")) identify.ties = read_ties(*ties);
  if (const auto list = table.find("inequalities")) identify.inequalities = read_ties(*list);
  if (const auto band = table.find("passive")) identify.passive_hz = band->interval();
  if (const auto list = table.find("frequencies")) identify.frequencies_hz = read_frequencies(*list);
  if (const auto flag = table.find("loose")) identify.loose = flag->boolean();
  read_bootstrap(table, identify);
  return identify;
}

}  // namespace jointid::ident
