#include "models/model_dofs.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>

#include "frf/file/variables.hpp"
#include "frf/set/frf_set.hpp"
#include "frf/text/number_text.hpp"
#include "models/files/failure.hpp"
#include "models/matrix_value.hpp"

namespace jointid::models {
namespace {

using Path = std::filesystem::path;

const std::string no_name = "-";

/// A DOF and its row from 1; no row: the next one.
struct Name {
  std::string dof;
  std::optional<double> row;
};

std::vector<Name> names_in_text(const Path& file) {
  std::vector<Name> names;
  std::istringstream in(frf::read_text(file));
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    const std::vector<std::string> parts{std::istream_iterator<std::string>(words), {}};
    if (parts.empty()) continue;
    double row = 0.0;
    const bool has_row = parts.size() == 2;
    if (parts.size() > 2 || (has_row && !frf::parse_cell(parts[0], false, row))) {
      refuse_file(file, "line " + std::to_string(number), "'" + line + "' is neither a DOF nor a row and a DOF",
                  "write \"4:+Y\" or \"7 4:+Y\"");
    }
    names.push_back({parts.back(), has_row ? std::optional(row) : std::nullopt});
  }
  return names;
}

std::vector<Name> names_in_variable(frf::MatFile& file, const std::string& variable) {
  const auto found = std::ranges::find(file.variables(), variable, &frf::MatInfo::name);
  if (found == file.variables().end() || found->kind != frf::MatKind::text) {
    refuse_file(file.file(), "variable " + variable,
                found == file.variables().end() ? "there is no such variable" : "it is not text",
                "store a cell array or a dataset of texts such as '4:+Y', and name it: \"FILE:VARIABLE\"");
  }
  std::vector<Name> names;
  for (std::string text : file.read(*found).texts) {
    text.resize(text.find_last_not_of(' ') + 1);
    names.push_back({text, std::nullopt});
  }
  return names;
}

std::vector<Name> names_in_file(const FileVariable& named) {
  const auto file = frf::open_variables(named.file);
  if (!file) return names_in_text(named.file);
  return names_in_variable(*file, named.variable.empty() ? "dofs" : named.variable);
}

std::vector<Name> names_in_scene(const scene::Item& item) {
  std::vector<Name> names;
  if (item.is_table()) {
    const scene::Table table = item.open_table();
    for (const auto& [dof, row] : table.members()) names.push_back({dof, row.number()});
    return names;
  }
  for (const scene::Item& name : item.list_not_empty()) names.push_back({name.text_not_empty(), std::nullopt});
  return names;
}

std::size_t row_of(const Name& name, std::size_t next, std::size_t size) {
  const double row = name.row.value_or(static_cast<double>(next + 1));
  if (row >= 1.0 && row <= static_cast<double>(size) && row == std::floor(row)) return static_cast<std::size_t>(row) - 1;
  refuse_file({}, {}, "'" + name.dof + "' is row " + scene::number_text(row) + ", the model has " + std::to_string(size),
              "rows are counted from 1");
}

NamedCoordinates coordinates_of(const std::vector<Name>& names, std::size_t size) {
  const bool in_order = std::ranges::none_of(names, [](const Name& name) { return name.row.has_value(); });
  if (in_order && names.size() != size) {
    refuse_file({}, {}, std::to_string(names.size()) + " names of " + std::to_string(size) + " coordinates",
                "name every row, \"-\" where it needs no name, or give rows: { \"4:+Y\" = 7 }");
  }
  NamedCoordinates out;
  std::set<std::size_t> rows;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].dof == no_name || names[i].dof.empty()) continue;
    const std::size_t row = row_of(names[i], i, size);
    const frf::Dof dof = frf::Dof::parse(names[i].dof);
    if (frf::has(out.dofs, dof)) refuse_file({}, {}, "'" + names[i].dof + "' is named twice", "a coordinate has one name");
    if (!rows.insert(row).second) refuse_file({}, {}, "row " + std::to_string(row + 1) + " has two names", "give one");
    out.dofs.push_back(dof);
    out.coordinates.push_back(row);
  }
  if (out.dofs.empty()) refuse_file({}, {}, "no coordinate has a name", "name those that the joint and the assembly have");
  return out;
}

}  // namespace

NamedCoordinates read_model_dofs(const scene::Item& item, const Path& folder, std::size_t size) {
  const std::vector<Name> names = item.is_text() ? names_in_file(read_file_variable(item, folder)) : names_in_scene(item);
  return item.here([&] { return coordinates_of(names, size); });
}

NamedCoordinates select(const scene::Item& item, const NamedCoordinates& all, const std::vector<frf::Dof>& kept) {
  NamedCoordinates out;
  for (const frf::Dof& dof : kept) {
    const std::size_t found = frf::find_coordinate(all.dofs, dof);
    if (found == frf::npos) {
      item.fail("the model has no '" + dof.name() + "'", "the nearest is " + nearest_word(dof.name(), frf::names(all.dofs)));
    }
    out.dofs.push_back(all.dofs[found]);
    out.coordinates.push_back(all.coordinates[found]);
  }
  return out;
}

}  // namespace jointid::models
