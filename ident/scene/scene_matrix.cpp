#include "ident/scene/scene_matrix.hpp"

#include <algorithm>
#include <cctype>

#include "frf/set/frf_set.hpp"
#include "restrictions/linear_expression.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {
namespace {

using restrictions::EntryMatrix;
using restrictions::JointSpec;
using restrictions::MatrixSpec;
using restrictions::Pattern;
using restrictions::Spring;

Pattern read_pattern(const scene::Item& item) {
  static const std::vector<std::string> words = {"full", "symmetric", "diagonal", "free"};
  const std::string word = item.word(words);
  return static_cast<Pattern>(std::find(words.begin(), words.end(), word) - words.begin());
}

restrictions::Entry read_entry(const scene::Item& item) {
  if (!item.is_text()) return item.number();
  const std::string& text = item.text();
  item.here([&] { return restrictions::parse_linear(text); });
  return text;
}

EntryMatrix read_entries(const scene::Item& item) {
  EntryMatrix matrix;
  for (const scene::Item& row : item.list_not_empty()) {
    matrix.emplace_back();
    for (const scene::Item& entry : row.list()) matrix.back().push_back(read_entry(entry));
  }
  return matrix;
}

Spring read_spring(const scene::Item& item) {
  if (!item.is_list())
    item.fail("is no spring, which is a list of its two ends",
              "write [[\"4:+Y\", \"5:+Y\"], …], or with names { k1 = [\"4:+Y\", \"5:+Y\"], … }");
  std::vector<scene::Item> ends = item.list();
  if (ends.size() != 2) {
    item.fail("a spring has two ends, found " + std::to_string(ends.size()),
              "write [\"4:+Y\", \"ground\"] for one end; a name goes before it, { k1 = [\"4:+Y\", \"5:+Y\"], … }");
  }
  if (ends[0].text() == "ground") std::swap(ends[0], ends[1]);
  Spring spring{ends[0].dof(), std::nullopt};
  if (ends[1].text() != "ground") spring.second = ends[1].dof();
  return spring;
}

/// A letter, then letters, digits and underscores, as in expressions.
void require_word(const std::string& name, const scene::Item& item) {
  const auto letter = [](char c) { return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const bool fits = !name.empty() && letter(name[0]) &&
                    std::ranges::all_of(name, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
  if (!fits) item.fail("'" + name + "' is no name of a spring", "begin with a letter, go on with letters, digits and _: k1");
}

/// What an end of a spring is to the joint: its place among the DOFs and its sign. Throws InputError (usage) for other DOFs.
std::pair<std::size_t, double> end_of(const scene::Item& item, const frf::Dof& dof, const JointSpec& joint) {
  const std::size_t place = frf::find_coordinate(joint.dofs, dof);
  if (place == frf::npos) item.fail(dof.name() + " is not a DOF of the joint", "add it to dofs");
  return {place, static_cast<double>(dof.sign * joint.dofs[place].sign)};
}

/// Adds the springs of one name, k b bᵀ with b = e_first − e_second, to the sums of a matrix of expressions.
void add_spring(const scene::Item& item, const std::string& name, const JointSpec& joint, std::vector<std::vector<std::string>>& sums) {
  const Spring spring = read_spring(item);
  std::vector<std::pair<std::size_t, double>> ends = {end_of(item, spring.first, joint)};
  if (spring.second) {
    const auto [place, sign] = end_of(item, *spring.second, joint);
    if (place == ends[0].first) item.fail("the spring has both ends on one DOF", "write \"ground\" for one of them");
    if (spring.first.is_rotation() != spring.second->is_rotation())
      item.fail("the spring joins a translation and a rotation", "write the coupling as a matrix of expressions");
    ends.emplace_back(place, -sign);
  }
  for (const auto& [row, sign] : ends) {
    for (const auto& [column, other] : ends) sums[row][column] += (sign * other > 0.0 ? "+" : "-") + name;
  }
}

/// `{ k1 = ["21:+X", "121:+X"], k2 = [["22:+X", "122:+X"], ["23:+X", "123:+X"]] }`, as the matrix of expressions that it is.
EntryMatrix read_named_springs(const scene::Item& item, const JointSpec& joint) {
  const scene::Table table = item.open_table();
  if (table.members().empty()) item.fail("the list of springs is empty", "leave the matrix out if it is zero");
  std::vector<std::vector<std::string>> sums(joint.dofs.size(), std::vector<std::string>(joint.dofs.size()));
  for (const auto& [name, value] : table.members()) {
    require_word(name, value);
    const std::vector<scene::Item> parts = value.list_not_empty();
    for (const scene::Item& spring : parts.front().is_list() ? parts : std::vector{value}) add_spring(spring, name, joint, sums);
  }
  EntryMatrix matrix;
  for (const std::vector<std::string>& row : sums) {
    matrix.emplace_back();
    for (const std::string& sum : row) matrix.back().push_back(sum.empty() ? restrictions::Entry(0.0) : restrictions::Entry(sum));
  }
  return matrix;
}

std::vector<Spring> read_springs(const scene::Item& item) {
  std::vector<Spring> springs;
  for (const scene::Item& spring : item.list_not_empty()) springs.push_back(read_spring(spring));
  return springs;
}

MatrixSpec read_form(const scene::Item& form, const std::string& key, const JointSpec& joint) {
  if (key == "pattern") return read_pattern(form);
  if (key == "matrix") return read_entries(form);
  if (form.is_table()) return read_named_springs(form, joint);
  return read_springs(form);
}

/// The one key of the matrix that declares its form.
std::pair<std::string, scene::Item> find_form(const scene::Table& table) {
  std::optional<std::pair<std::string, scene::Item>> form;
  for (const auto& member : table.members()) {
    if (member.first == "definite") continue;
    if (form) table.itself().fail("the matrix has more than one form", "give one of pattern, matrix or springs");
    form = member;
  }
  if (!form) table.itself().fail("the matrix has no form", "give one of pattern, matrix or springs");
  return *form;
}

bool lacks_positions(const MatrixSpec& spec, const JointSpec& joint) {
  const Pattern* pattern = std::get_if<Pattern>(&spec);
  return pattern != nullptr && *pattern == Pattern::free &&
         std::any_of(joint.dofs.begin(), joint.dofs.end(),
                     [&](const frf::Dof& dof) { return !joint.node_positions.contains(dof.node); });
}

}  // namespace

MatrixSpec read_matrix_spec(const scene::Item& item, restrictions::Kind kind, const JointSpec& joint) {
  const auto [key, form] = find_form(item.table({"pattern", "matrix", "springs", "definite"}));
  MatrixSpec spec = read_form(form, key, joint);
  if (lacks_positions(spec, joint)) return spec;
  JointSpec alone = joint;
  alone.matrices = {{kind, spec}};
  form.here([&] { return restrictions::build({alone}); });
  return spec;
}

bool read_definite(const scene::Item& item) {
  const auto definite = item.open_table().find("definite");
  return definite && definite->boolean();
}

}  // namespace jointid::ident
