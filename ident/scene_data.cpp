#include <algorithm>

#include "ident/scene_sections.hpp"

namespace jointid::ident {
namespace {

using Names = std::vector<std::string>;

/// Reads a list of files; `names` collects them as written, none twice.
std::vector<DataFile> read_files(const SceneItem& list, const Path& folder, Names& names) {
  std::vector<DataFile> files;
  for (const SceneItem& item : list.list_not_empty()) {
    const std::string name = item.text_not_empty();
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      item.fail("the file '" + name + "' is named twice", "a file holds either a substructure or the assembly, once");
    }
    names.push_back(name);
    files.push_back({folder / name, {}});
  }
  return files;
}

frf::OpenOptions read_options(const SceneItem& item) {
  const SceneTable table = item.table({"quantity", "dofs", "reference_dofs", "variable"});
  frf::OpenOptions options;
  if (const auto quantity = table.find("quantity")) {
    const std::string& word = quantity->text();
    options.quantity = quantity->here([&] { return frf::parse_quantity(word); });
  }
  if (const auto dofs = table.find("dofs")) options.response = dofs->dofs();
  if (const auto dofs = table.find("reference_dofs")) {
    options.reference = dofs->dofs();
    if (options.response.empty()) dofs->fail("reference_dofs is given without dofs", "give dofs, too");
  }
  if (const auto variable = table.find("variable")) options.variable = variable->text_not_empty();
  return options;
}

void read_all_options(const SceneItem& item, const Names& names, DataSection& data) {
  const SceneTable table = item.table(names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto options = table.find(names[i]);
    if (!options) continue;
    const bool is_substructure = i < data.substructures.size();
    DataFile& file = is_substructure ? data.substructures[i] : data.assembly[i - data.substructures.size()];
    file.options = read_options(*options);
  }
}

}  // namespace

DataSection read_data(const SceneItem& item, const Path& folder) {
  const SceneTable table = item.table({"substructures", "assembly", "reciprocity", "files"});
  DataSection data;
  Names names;
  data.substructures = read_files(table.require("substructures"), folder, names);
  data.assembly = read_files(table.require("assembly"), folder, names);
  if (const auto reciprocity = table.find("reciprocity")) data.reciprocity = reciprocity->boolean();
  if (const auto files = table.find("files")) read_all_options(*files, names, data);
  return data;
}

}  // namespace jointid::ident
