#include "ident/scene/scene_matrix.hpp"

#include <algorithm>

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
  std::vector<scene::Item> ends = item.list();
  if (ends.size() != 2) {
    item.fail("a spring has two ends, found " + std::to_string(ends.size()),
              "write [\"4:+Y\", \"ground\"] for one end");
  }
  if (ends[0].text() == "ground") std::swap(ends[0], ends[1]);
  Spring spring{ends[0].dof(), std::nullopt};
  if (ends[1].text() != "ground") spring.second = ends[1].dof();
  return spring;
}

std::vector<Spring> read_springs(const scene::Item& item) {
  std::vector<Spring> springs;
  for (const scene::Item& spring : item.list_not_empty()) springs.push_back(read_spring(spring));
  return springs;
}

MatrixSpec read_form(const scene::Item& form, const std::string& key) {
  if (key == "pattern") return read_pattern(form);
  if (key == "matrix") return read_entries(form);
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
  MatrixSpec spec = read_form(form, key);
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
