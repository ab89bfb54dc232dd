#include <fmt/format.h>

#include <array>

#include "report/export/export_parts.hpp"

namespace jointid::report {
namespace {

/// Cards of large fields: a name of eight characters with an asterisk, four fields of sixteen characters a line.
std::string card(const std::string& name, const std::vector<std::string>& fields) {
  std::string text;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i % 4 == 0) text += (i == 0 ? "" : "\n") + fmt::format("{:<8}", i == 0 ? name + "*" : "*");
    text += fmt::format("{:<16}", fields[i]);
  }
  std::string out;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    line.resize(line.find_last_not_of(' ') + 1);
    out += line + "\n";
    begin = end + 1;
  }
  return out;
}

std::string comment(const std::string& text) { return "$ " + text + "\n"; }

std::string grid(const frf::Dof& dof) { return std::to_string(dof.node); }

/// A matrix of the case control's command `selected`.
struct Dmig {
  std::string name, selected;
  bool symmetric = true;
  std::vector<Kind> real, imaginary;  ///< at most one each
};

/// Real ones are of type 2, complex ones of type 4; symmetric ones have form 6 and their lower triangle, others form 1.
std::string dmig(const ExportedMatrices& of, const Dmig& matrix) {
  const bool complex = !matrix.imaginary.empty();
  const std::size_t n = of.size();
  std::string text = card("DMIG", {matrix.name, "0", matrix.symmetric ? "6" : "1", complex ? "4" : "2", "0", "", "",
                                   matrix.symmetric ? "" : std::to_string(n)});
  for (std::size_t column = 0; column < n; ++column) {
    std::string remarks;
    std::vector<std::string> fields = {matrix.name, grid(of.dofs()[column]), std::to_string(component(of.dofs()[column])), ""};
    for (std::size_t row = matrix.symmetric ? column : 0; row < n; ++row) {
      const auto value = [&](const std::vector<Kind>& kinds) {
        return kinds.empty() ? 0.0 : of.at(kinds.front(), row, column).value;
      };
      const double re = value(matrix.real), im = value(matrix.imaginary);
      if (re == 0.0 && im == 0.0) continue;
      for (const auto* kinds : {&matrix.real, &matrix.imaginary}) {
        for (const Kind kind : *kinds) remarks += comment(of.remark(kind, row, column));
      }
      fields.insert(fields.end(),
                    {grid(of.dofs()[row]), std::to_string(component(of.dofs()[row])), sixteen(re), complex ? sixteen(im) : ""});
    }
    if (fields.size() > 4) text += remarks + card("DMIG", fields);
  }
  return text;
}

/// Symmetric matrices before constraints (GG), others after them (PP).
std::vector<Dmig> dmigs(const ExportedMatrices& of) {
  std::vector<Dmig> out;
  const bool stiffness_only = of.is_symmetric(Kind::stiffness) && of.is_symmetric(Kind::hysteretic_damping);
  if (!stiffness_only) {
    out.push_back({"KJOINT", "K2PP", false, {Kind::stiffness}, {Kind::hysteretic_damping}});
  } else {
    if (of.has(Kind::stiffness)) out.push_back({"KJOINT", "K2GG", true, {Kind::stiffness}, {}});
    if (of.has(Kind::hysteretic_damping)) out.push_back({"DJOINT", "K42GG", true, {Kind::hysteretic_damping}, {}});
  }
  for (const auto& [kind, name, letter] :
       {std::tuple{Kind::mass, "MJOINT", "M2"}, std::tuple{Kind::viscous_damping, "BJOINT", "B2"}}) {
    if (!of.has(kind)) continue;
    const bool symmetric = of.is_symmetric(kind);
    out.push_back({name, std::string(letter) + (symmetric ? "GG" : "PP"), symmetric, {kind}, {}});
  }
  return out;
}

std::string matrix_cards(const ExportedMatrices& of, const std::vector<Dmig>& matrices) {
  std::string text;
  for (const Dmig& matrix : matrices) text += comment("case control: " + matrix.selected + " = " + matrix.name);
  for (const Dmig& matrix : matrices) text += dmig(of, matrix);
  return text;
}

/// Losses of links without stiffness, as a matrix: GE multiplies a stiffness.
bool has_losses_alone(const std::vector<Link>& links) {
  return std::ranges::any_of(links,
                             [](const Link& link) { return link.has(Kind::hysteretic_damping) && !link.has(Kind::stiffness); });
}

std::string spring_cards(const ExportedMatrices& of) {
  const std::vector<Link> links = of.links();
  const bool losses_alone = has_losses_alone(links);
  std::string text;
  std::size_t id = of.options().first_id;
  constexpr std::array kinds = {std::pair{Kind::stiffness, "CELAS2"}, std::pair{Kind::viscous_damping, "CDAMP2"},
                                std::pair{Kind::mass, "CMASS2"}};
  for (const auto& [kind, name] : kinds) {
    for (const Link& link : links) {
      if (!link.has(kind)) continue;
      const frf::Dof& first = of.dofs()[link.first];
      text += comment(of.remark(kind, link));
      std::vector<std::string> fields = {
          std::to_string(id++), sixteen(link.of(kind).value), grid(first), std::to_string(component(first)), "", ""};
      if (link.second) {
        fields[4] = grid(of.dofs()[*link.second]);
        fields[5] = std::to_string(component(of.dofs()[*link.second]));
      }
      if (kind == Kind::stiffness && link.has(Kind::hysteretic_damping) && !losses_alone) {
        text += comment("GE: " + of.remark(Kind::hysteretic_damping, link));
        fields.push_back(sixteen(link.of(Kind::hysteretic_damping).value / link.of(Kind::stiffness).value));
      }
      text += card(name, fields);
    }
  }
  if (losses_alone) text += matrix_cards(of, {{"DJOINT", "K42GG", true, {Kind::hysteretic_damping}, {}}});
  return text;
}

/// A row "K", "B" or "GE" of six values.
std::vector<std::string> bush_row(const Bush& bush, const char* word, Kind kind) {
  std::vector<std::string> fields = {word};
  bool any = false;
  for (int direction = 1; direction <= 6; ++direction) {
    const auto link = bush.by_direction.find(direction);
    const double value = link == bush.by_direction.end() ? 0.0 : link->second.of(kind).value;
    const double over = kind == Kind::hysteretic_damping && value != 0.0 ? link->second.of(Kind::stiffness).value : 1.0;
    any = any || value != 0.0;
    fields.push_back(value == 0.0 ? "0.0" : sixteen(value / over));
  }
  return any ? fields : std::vector<std::string>();
}

std::string bush_cards(const ExportedMatrices& of) {
  std::string text =
      comment("CBUSH between grid points at one place, in the basic system. Apart, its forces make moments: use springs there.");
  std::size_t id = of.options().first_id;
  if (has_losses_alone(of.links()))
    of.refuse("hysteretic damping without stiffness, which GE of a PBUSH multiplies", "write --as matrix");
  for (const Bush& bush : bushes(of)) {
    for (const auto& [direction, link] : bush.by_direction) {
      for (const auto& [kind, value] : link.by_kind) text += comment(of.remark(kind, link));
    }
    text += card("CBUSH", {std::to_string(id), std::to_string(id), std::to_string(bush.first),
                           bush.second ? std::to_string(*bush.second) : "", "", "", "", "0"});
    std::vector<std::string> fields = {std::to_string(id)};
    for (const auto& [word, kind] :
         {std::pair{"K", Kind::stiffness}, std::pair{"B", Kind::viscous_damping}, std::pair{"GE", Kind::hysteretic_damping}}) {
      const std::vector<std::string> row = bush_row(bush, word, kind);
      if (row.empty()) continue;
      if (fields.size() > 1) fields.push_back("");  // the first field of a continuation
      fields.insert(fields.end(), row.begin(), row.end());
    }
    text += card("PBUSH", fields);
    ++id;
  }
  return text;
}

}  // namespace

std::vector<ExportFile> nastran_files(const ExportedMatrices& of, ExportWay way) {
  std::string text;
  for (const std::string& line : of.head()) text += comment(line);
  if (way == ExportWay::springs) text += spring_cards(of);
  if (way == ExportWay::bush) text += bush_cards(of);
  if (way == ExportWay::matrix) text += matrix_cards(of, dmigs(of));
  return {{".bdf", text}};
}

}  // namespace jointid::report
