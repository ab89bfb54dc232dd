#include <algorithm>

#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "ident/scene/scene_sections.hpp"
#include "models/model_file.hpp"

namespace jointid::ident {
namespace {

using Names = std::vector<std::string>;

/// `names` collects the files as written, none twice.
DataFile read_file(const scene::Item& item, const Path& folder, Names& names) {
  const std::string name = item.text_not_empty();
  if (std::find(names.begin(), names.end(), name) != names.end()) {
    item.fail("the file '" + name + "' is named twice", "a file holds either a substructure or the assembly, once");
  }
  names.push_back(name);
  return {folder / name, {}};
}

/// Repeats of one measurement: the first run with the others.
DataFile read_repeats(const scene::Item& list, const Path& folder, Names& names) {
  const std::vector<scene::Item> runs = list.list_not_empty();
  if (runs.size() < 2) list.fail("a list of one file: one run has no scatter", "name the file without the list, or more runs");
  DataFile first = read_file(runs.front(), folder, names);
  for (std::size_t i = 1; i < runs.size(); ++i) first.repeats.push_back(read_file(runs[i], folder, names));
  return first;
}

std::vector<DataFile> read_files(const scene::Item& list, const Path& folder, Names& names) {
  std::vector<DataFile> files;
  for (const scene::Item& item : list.list_not_empty()) {
    files.push_back(item.is_list() ? read_repeats(item, folder, names) : read_file(item, folder, names));
  }
  return files;
}

/// Those of a list that can be read.
std::vector<DataFile> readable_files(const scene::Table& table, const std::string& key, const Path& folder, Names& names) {
  std::vector<DataFile> files;
  const auto list = table.find(key);
  if (!list || !list->is_list()) return files;
  for (const scene::Item& item : list->list()) {
    Names also = names;
    if_readable([&] {
      files.push_back(item.is_list() ? read_repeats(item, folder, also) : read_file(item, folder, also));
      names = also;
    });
  }
  return files;
}

/// Names as all_files() orders the files.
std::vector<PlacedFile> placed_files(const DataSection& data, const Names& names) {
  std::vector<PlacedFile> all;
  for (const auto* files : {&data.substructures, &data.assembly}) {
    for (std::size_t i = 0; i < files->size(); ++i) {
      for (std::size_t run = 0; run <= (*files)[i].repeats.size(); ++run) {
        all.push_back({names[all.size()], files == &data.assembly, i});
      }
    }
  }
  return all;
}

scene::Table file_table(const scene::Item& item) {
  std::vector<std::string> keys = correction_keys();
  keys.insert(keys.begin(),
              {"quantity", "unit", "dofs", "reference_dofs", "variable", "frequency_variable", "frequency_unit", "mass", "model",
               "nodes"});
  return item.table(keys);
}

frf::OpenOptions read_options(const scene::Table& table) {
  frf::OpenOptions options;
  if (const auto quantity = table.find("quantity")) {
    const std::string& word = quantity->text();
    options.quantity = quantity->here([&] { return frf::parse_quantity(word); });
  }
  if (const auto unit = table.find("unit")) {
    options.unit = unit->text_not_empty();
    unit->here([&] { frf::require_frf_unit(options.unit); });
  }
  if (const auto dofs = table.find("dofs")) options.response = dofs->dofs();
  if (const auto dofs = table.find("reference_dofs")) {
    options.reference = dofs->dofs();
    if (options.response.empty()) dofs->fail("reference_dofs is given without dofs", "give dofs, too");
  }
  if (const auto variable = table.find("variable")) options.variable = variable->text_not_empty();
  if (const auto variable = table.find("frequency_variable")) options.frequency_variable = variable->text_not_empty();
  if (const auto unit = table.find("frequency_unit")) {
    options.frequency_unit = unit->text_not_empty();
    unit->here([&] { frf::hertz_per(options.frequency_unit); });
  }
  return options;
}

Regeneration read_regeneration(const scene::Item& list) {
  Regeneration chosen;
  for (const scene::Item& item : list.list_not_empty()) {
    const Regeneration one = item.here([&] { return parse_regeneration(item.text()); });
    chosen.substructures |= one.substructures;
    chosen.assembly |= one.assembly;
  }
  return chosen;
}

/// Beside the file that it is a model of.
Path read_model_of(const scene::Item& item, const DataFile& file, const Path& folder) {
  const Path model = folder / item.text_not_empty();
  if (!models::is_model_file(model)) item.fail("it is no description of a model", "name a file *.toml (docs/model-parts.md)");
  if (models::is_model_file(file.path)) item.fail("the part is a model itself", "give the key to a measured file");
  return model;
}

void read_options_of(const scene::Item& item, DataFile& file, const Path& folder) {
  const scene::Table keys = file_table(item);
  file.options = read_options(keys);
  file.corrections = read_corrections(keys);
  if (const auto mass = keys.find("mass")) file.mass = mass->positive();
  if (const auto model = keys.find("model")) file.model = read_model_of(*model, file, folder);
  if (const auto nodes = keys.find("nodes")) file.nodes = folder / nodes->text_not_empty();
}

/// `nodes` of [data], for every file; a file's own comes after it.
void read_nodes_of_all(const scene::Table& table, DataSection& data, const Path& folder) {
  const auto nodes = table.find("nodes");
  if (!nodes) return;
  const Path path = folder / nodes->text_not_empty();
  for (DataFile* file : all_files(data)) file->nodes = path;
}

/// `files` are those of `names`; a name may stand for several.
void read_all_options(const scene::Item& item, const Names& names, const std::vector<DataFile*>& files, const Path& folder) {
  const scene::Table table = item.table(names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto of_file = table.find(names[i]);
    if (of_file) read_options_of(*of_file, *files[i], folder);
  }
}

}  // namespace

std::vector<DataFile*> all_files(DataSection& data) {
  std::vector<DataFile*> all;
  for (auto* files : {&data.substructures, &data.assembly}) {
    for (DataFile& file : *files) {
      all.push_back(&file);
      for (DataFile& run : file.repeats) all.push_back(&run);
    }
  }
  return all;
}

DataSection read_data(const scene::Item& item, const Path& folder) {
  const scene::Table table = item.table({"substructures", "assembly", "nodes", "reciprocity", "regenerate", "files", "gains", "masses"});
  DataSection data;
  Names names;
  data.substructures = read_files(table.require("substructures"), folder, names);
  data.assembly = read_files(table.require("assembly"), folder, names);
  if (const auto regenerate = table.find("regenerate")) data.regenerate = read_regeneration(*regenerate);
  if (const auto reciprocity = table.find("reciprocity")) data.reciprocity = reciprocity->boolean();
  read_nodes_of_all(table, data, folder);
  if (const auto files = table.find("files")) read_all_options(*files, names, all_files(data), folder);
  read_systematic_errors(table, placed_files(data, names), data);
  return data;
}

DataSection readable_data(const scene::Item& item, const Path& folder) {
  const scene::Table table = item.open_table();
  DataSection data;
  Names names;
  for (const char* key : {"substructures", "parts"}) {
    const std::vector<DataFile> files = readable_files(table, key, folder, names);
    data.substructures.insert(data.substructures.end(), files.begin(), files.end());
  }
  data.assembly = readable_files(table, "assembly", folder, names);
  if_readable([&] { read_nodes_of_all(table, data, folder); });
  const auto options = table.find("files");
  if (!options || !options->is_table()) return data;
  const scene::Table by_name = options->open_table();
  const std::vector<DataFile*> files = all_files(data);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (const auto of_file = by_name.find(names[i])) if_readable([&] { read_options_of(*of_file, *files[i], folder); });
  }
  return data;
}

DataSection read_parts_section(const scene::Item& item, const Path& folder, std::vector<std::string>& names,
                               const std::vector<FurtherFile>& further, const std::vector<std::string>& beside) {
  std::vector<std::string> keys = {"parts", "substructures", "nodes", "reciprocity", "files"};
  keys.insert(keys.end(), beside.begin(), beside.end());
  const scene::Table table = item.table(keys);
  DataSection data;
  Names all;
  const auto as_elsewhere = table.find("substructures");  // the word of scenes that identify
  if (as_elsewhere && table.find("parts")) as_elsewhere->fail("there are parts, too", "give one of them: both are the same");
  data.substructures = read_files(as_elsewhere ? *as_elsewhere : table.require("parts"), folder, all);
  if (const auto reciprocity = table.find("reciprocity")) data.reciprocity = reciprocity->boolean();
  read_nodes_of_all(table, data, folder);
  if (const auto files = table.find("files")) {
    Names named = all;
    std::vector<DataFile*> of_name = all_files(data);
    for (const FurtherFile& other : further) {
      named.push_back(other.name);
      of_name.push_back(other.file);
    }
    read_all_options(*files, named, of_name, folder);
    for (const DataFile* file : of_name) {
      if (!file->model) continue;
      files->fail("a model is given beside a file, which only `jointid check` of a scene that identifies compares", "remove it");
    }
  }
  // A part of several runs is named by the first.
  std::size_t file = 0;
  for (const DataFile& part : data.substructures) {
    names.push_back(all[file]);
    file += 1 + part.repeats.size();
  }
  return data;
}

}  // namespace jointid::ident
