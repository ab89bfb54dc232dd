#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "frf/hdf5_module/files.hpp"
#include "frf/hdf5_module/hdf5_attributes.hpp"
#include "frf/hdf5_module/hdf5_object.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/number_text.hpp"

namespace jointid::frf {
namespace {

using hdf5::Dataset;
using hdf5::Handle;

constexpr int deepest_group = 8;
constexpr std::size_t most_groups = 10'000;                 ///< links may lead round in circles
constexpr std::size_t most_kept = std::size_t{1} << 25;  ///< numbers of a chunk that is held in memory

/// A dataset, by its path in the file, or from the group or dataset that an element of an array of structs refers to (none: that
/// itself).
struct Place {
  std::string path;
  std::optional<hobj_ref_t> from{};
};

/// Datasets of a group and of the groups in it (structs of MATLAB), "S.field" and "S(2).field"; not of what MATLAB keeps to
/// itself, "#refs#".
struct Paths {
  std::vector<std::pair<std::string, Place>> found;  ///< by their dotted names
  std::string name;                                  ///< of the group, "S."
  Place group;                                       ///< with a / at the end of its path, but at the root
  int depth = 0;
  std::size_t groups = 0;
  bool octave = false;  ///< a group is one that GNU Octave wrote
};

void add_paths(hid_t group, Paths& paths);

/// The object that a place of an array of structs holds.
void add_referred(hid_t group, const hobj_ref_t& reference, const std::string& name, Paths& paths) {
  const Handle object(H5Rdereference2(group, H5P_DEFAULT, H5R_OBJECT, &reference));
  if (!object.is_open() || paths.depth >= deepest_group || paths.groups >= most_groups) return;
  ++paths.groups;
  if (H5Iget_type(object.get()) == H5I_DATASET) paths.found.emplace_back(name, Place{{}, reference});
  if (H5Iget_type(object.get()) != H5I_GROUP) return;
  Paths inner{.found = {}, .name = name + ".", .group = {{}, reference}, .depth = paths.depth + 1, .groups = paths.groups};
  add_paths(object.get(), inner);
  paths.groups = inner.groups;
  paths.found.insert(paths.found.end(), inner.found.begin(), inner.found.end());
}

/// What a dataset of references refers to; empty for any other dataset, and of too many.
std::vector<hobj_ref_t> references_of(hid_t id) {
  const Handle type(H5Dget_type(id)), space(H5Dget_space(id));
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (H5Tequal(type.get(), H5T_STD_REF_OBJ) <= 0 || count < 1 || static_cast<std::size_t>(count) > most_groups) return {};
  if (H5Dget_storage_size(id) < static_cast<std::size_t>(count) * sizeof(hobj_ref_t)) return {};
  std::vector<hobj_ref_t> references(static_cast<std::size_t>(count));
  if (H5Dread(id, H5T_STD_REF_OBJ, H5S_ALL, H5S_ALL, H5P_DEFAULT, references.data()) < 0) return {};
  return references;
}

/// A struct, or an array of complex numbers.
bool may_hold_frfs(hid_t group, const hobj_ref_t& reference) {
  const Handle object(H5Rdereference2(group, H5P_DEFAULT, H5R_OBJECT, &reference));
  if (!object.is_open() || H5Iget_type(object.get()) != H5I_DATASET) return object.is_open() && H5Iget_type(object.get()) == H5I_GROUP;
  const Handle type(H5Dget_type(object.get()));
  return H5Tget_class(type.get()) == H5T_COMPOUND;
}

/// Cells that hold structs or complex arrays, beside the cell array itself: "S(2).field", "H(2)".
void add_cells(hid_t group, const char* name, Paths& paths) {
  const Handle id(H5Dopen2(group, name, H5P_DEFAULT));
  if (!id.is_open() || H5Aexists(id.get(), "MATLAB_class") <= 0) return;
  const std::vector<hobj_ref_t> references = references_of(id.get());
  if (!std::ranges::all_of(references, [&](const hobj_ref_t& each) { return may_hold_frfs(group, each); })) return;
  for (std::size_t i = 0; i < references.size(); ++i)
    add_referred(group, references[i], paths.name + name + "(" + std::to_string(i + 1) + ")", paths);
}

/// A field of an array of structs is a dataset of references; false for any other dataset.
bool add_elements(hid_t group, const char* name, Paths& paths) {
  if (paths.name.empty()) return false;
  const Handle id(H5Dopen2(group, name, H5P_DEFAULT));
  if (!id.is_open() || H5Aexists(id.get(), "MATLAB_class") > 0) return false;  // a cell array says that it is one
  const std::vector<hobj_ref_t> references = references_of(id.get());
  const std::string structure = paths.name.substr(0, paths.name.size() - 1);
  for (std::size_t i = 0; i < references.size(); ++i)
    add_referred(group, references[i], structure + "(" + std::to_string(i + 1) + ")." + name, paths);
  return !references.empty();
}

void add_paths(hid_t group, Paths& paths) {
  const auto keep = [](hid_t group, const char* name, const H5L_info_t* link, void* kept) -> herr_t {
    auto& out = *static_cast<Paths*>(kept);
    H5O_info_t object;
    if (link->type != H5L_TYPE_HARD || H5Oget_info_by_name(group, name, &object, H5P_DEFAULT) < 0) return 0;
    if (object.type == H5O_TYPE_DATASET && !add_elements(group, name, out)) {
      out.found.emplace_back(out.name + name, Place{out.group.path + name, out.group.from});
      add_cells(group, name, out);
    }
    if (object.type == H5O_TYPE_GROUP && name[0] != '#' && out.depth < deepest_group && out.groups < most_groups) {
      const Handle inner(H5Gopen2(group, name, H5P_DEFAULT));
      const std::string outer_name = out.name, outer_path = out.group.path;
      out.name += std::string(name) + ".";
      out.group.path += std::string(name) + "/";
      ++out.depth;
      ++out.groups;
      if (inner.is_open()) {
        out.octave = out.octave || H5Aexists(inner.get(), "OCTAVE_NEW_FORMAT") > 0;
        add_paths(inner.get(), out);
      }
      --out.depth;
      out.name = outer_name;
      out.group.path = outer_path;
    }
    return 0;
  };
  H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, keep, &paths);
}

/// MATLAB writes its name into the first bytes of its files.
bool begins_as_matlab(const std::filesystem::path& path) {
  std::string head(6, '\0');
  std::ifstream(path, std::ios::binary).read(head.data(), static_cast<std::streamsize>(head.size()));
  return head == "MATLAB";
}

std::string matlab_class(const Dataset& dataset) { return hdf5::text_attribute(dataset, "MATLAB_class").value_or(""); }

H5T_class_t type_class(const Dataset& dataset) {
  const Handle type(H5Dget_type(dataset.id.get()));
  return H5Tget_class(type.get());
}

MatKind kind_of(const Dataset& dataset) {
  const std::string name = matlab_class(dataset);
  if (hdf5::number_attribute(dataset, "MATLAB_empty").value_or(0.0) != 0.0) return MatKind::other;
  if (name == "char" || name == "cell" || type_class(dataset) == H5T_STRING) return MatKind::text;
  if (hdf5::complex_members(dataset)) return MatKind::complex;
  return hdf5::is_real(dataset) ? MatKind::real : MatKind::other;
}

/// The attribute unit or units, in any case: one text, or texts with commas between them, of which equal ones are one.
std::string unit_of(const Dataset& dataset) {
  for (const char* name : {"unit", "units", "Unit", "Units", "UNIT", "UNITS"}) {
    if (hdf5::has_text_attribute(dataset, name)) return hdf5::text_attribute(dataset, name).value_or("");
    const auto joined = hdf5::joined_texts(dataset, name);
    if (!joined) continue;
    const std::vector<std::string_view> texts = split(*joined, ',');
    const bool equal = std::ranges::all_of(texts, [&](std::string_view text) { return text == texts.front(); });
    return equal ? std::string(texts.front()) : *joined;
  }
  return {};
}

std::size_t size(const Dataset& dataset) {
  return std::accumulate(dataset.dims.begin(), dataset.dims.end(), std::size_t{1}, std::multiplies<>());
}

std::vector<Complex> read_values(const Dataset& dataset, MatKind kind) {
  if (kind == MatKind::real) {
    const std::vector<double> reals = hdf5::read_doubles(dataset);
    return {reals.begin(), reals.end()};
  }
  std::vector<Complex> values(size(dataset));
  const auto members = hdf5::complex_members(dataset);
  if (!members) fail(dataset, "does not hold complex numbers");
  const Handle type = hdf5::complex_type(members->at(0).c_str(), members->at(1).c_str());
  if (H5Dread(dataset.id.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    fail(dataset, "cannot be read: " + hdf5::last_failure());
  }
  return values;
}

/// Rows of a MATLAB character array [rows, columns], which HDF5 sees as [columns, rows], in UTF-8; without NULs, which fill some.
std::vector<std::string> read_characters(const Dataset& dataset) {
  const std::vector<double> codes = hdf5::read_doubles(dataset);
  const std::size_t rows = dataset.dims.size() == 2 ? dataset.dims[1] : 1;
  std::vector<std::string> texts(rows);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (codes[i] > 0.0 && codes[i] < 65536.0) append_utf8(texts[i % rows], static_cast<std::uint32_t>(codes[i]));
  }
  return texts;
}

std::vector<std::string> read_cells(const hdf5::Object& file, const Dataset& dataset) {
  if (type_class(dataset) != H5T_REFERENCE) fail(dataset, "is a cell array that holds no references");
  std::vector<hobj_ref_t> references(size(dataset));
  if (H5Dread(dataset.id.get(), H5T_STD_REF_OBJ, H5S_ALL, H5S_ALL, H5P_DEFAULT, references.data()) < 0) {
    fail(dataset, "cannot be read: " + hdf5::last_failure());
  }
  std::vector<std::string> texts;
  for (const hobj_ref_t& reference : references) {
    Handle id(H5Rdereference2(dataset.id.get(), H5P_DEFAULT, H5R_OBJECT, &reference));
    const Dataset cell = to_dataset(file, std::move(id), dataset.place + ", cell " + std::to_string(texts.size() + 1));
    if (matlab_class(cell) != "char") fail(cell, "is not text");
    std::vector<std::string> rows = read_characters(cell);
    texts.push_back(rows.size() == 1 ? std::move(rows.front()) : std::string());
  }
  return texts;
}

std::vector<std::string> read_texts(const hdf5::Object& file, const Dataset& dataset) {
  if (type_class(dataset) == H5T_STRING) return hdf5::read_texts(dataset);
  return matlab_class(dataset) == "cell" ? read_cells(file, dataset) : read_characters(dataset);
}

/// GNU Octave stores S.field in S/value/field/value, and in .../type what it is.
std::string octave_name(std::string name) {
  constexpr std::string_view value = ".value";
  for (std::size_t found = name.find(value); found != std::string::npos; found = name.find(value, found)) {
    const std::size_t end = found + value.size();
    if (end == name.size() || name[end] == '.' || name[end] == '(') {
      name.erase(found, value.size());
    } else {
      found = end;
    }
  }
  return name;
}

class MatV73 final : public MatFile {
 public:
  explicit MatV73(const std::filesystem::path& path) : MatFile(path.string()) {
    const hdf5::Silence silence;
    hdf5_ = hdf5::open_file(path);
    hdf5::limit_metadata(hdf5_.id, std::size_t{2} << 20);  // enough for reading fast, however long the record
    Paths paths;
    add_paths(hdf5_.id.get(), paths);
    by_rows_ = !paths.octave && !begins_as_matlab(path);
    const std::map<std::string, std::string> types = paths.octave ? octave_types(paths) : std::map<std::string, std::string>();
    for (auto& [path_name, place] : paths.found) {
      if (paths.octave && path_name.ends_with(octave_type)) continue;
      const Dataset dataset = open(path_name, place);
      by_rows_ = by_rows_ && matlab_class(dataset).empty();
      const std::string name = paths.octave ? octave_name(path_name) : path_name;
      const auto type = types.find(name);
      const bool is_text = type != types.end() && type->second.ends_with("string");
      variables_.push_back({.name = name,
                            .kind = is_text ? MatKind::text : kind_of(dataset),
                            .dims = {dataset.dims.rbegin(), dataset.dims.rend()},
                            .unit = unit_of(dataset),
                            .integers = type_class(dataset) == H5T_INTEGER});
      place_of_.emplace(name, std::move(place));
    }
    require_distinct_names();
  }

  MatVariable read_variable(const MatInfo& info) override {
    const hdf5::Silence silence;
    const Dataset dataset = open(info.name, place_of_.at(info.name));
    MatVariable variable{.info = info, .values = {}, .texts = {}};
    if (info.kind == MatKind::text) {
      variable.texts = read_texts(hdf5_, dataset);
    } else {
      variable.values = read_values(dataset, info.kind);
    }
    return variable;
  }

  bool last_index_fastest() const override { return by_rows_; }

  std::string note(const MatInfo* info, std::string_view name) override {
    const hdf5::Silence silence;
    if (info == nullptr) return hdf5::any_text_attribute(hdf5_, name).value_or("");
    return hdf5::any_text_attribute(open(info->name, place_of_.at(info->name)), name).value_or("");
  }

  std::vector<std::pair<std::string, std::string>> notes(const MatInfo& info) override {
    const hdf5::Silence silence;
    std::vector<std::pair<std::string, std::string>> all;
    const auto add = [&](const hdf5::Object& object, const std::string& place) {
      for (auto& [name, text] : hdf5::attributes_as_texts(object)) all.emplace_back(place + "@" + name, std::move(text));
    };
    const Place& place = place_of_.at(info.name);
    const Dataset dataset = open(info.name, place);
    add(dataset, info.name);
    for (std::size_t end = place.from ? std::string::npos : place.path.rfind('/'); end != std::string::npos && end > 0;
         end = place.path.rfind('/', end - 1)) {
      hdf5::Object group;
      group.file = hdf5_.file;
      group.place = place.path.substr(0, end);
      group.id = Handle(H5Gopen2(hdf5_.id.get(), group.place.c_str(), H5P_DEFAULT));
      if (group.id.is_open()) add(group, group.place);
    }
    add(hdf5_, "");
    return all;
  }

  std::vector<std::string> scales(const MatInfo& info) override {
    const hdf5::Silence silence;
    return by_rows_ ? hdf5::names_of_scales(open(info.name, place_of_.at(info.name))) : std::vector<std::string>();
  }

  bool reads_samples() const override { return true; }

  std::vector<double> read_samples(const MatInfo& info, std::size_t first, std::size_t count) override {
    const hdf5::Silence silence;
    const auto kept = kept_.find(info.name);
    if (kept != kept_.end() && kept->second.holds(first, count)) return kept->second.part(first, count);
    const Dataset dataset = open(info.name, place_of_.at(info.name));
    const std::size_t chunk = hdf5::samples_in_chunk(dataset);
    if (chunk <= count) return hdf5::read_samples(dataset, first, count);
    return keep(info, dataset, first, count, chunk).part(first, count);
  }

 private:
  static constexpr std::string_view octave_type = ".type";

  /// Of variables of GNU Octave, "matrix", "string".
  std::map<std::string, std::string> octave_types(const Paths& paths) const {
    std::map<std::string, std::string> types;
    for (const auto& [name, place] : paths.found) {
      if (!name.ends_with(octave_type)) continue;
      const Dataset dataset = open(name, place);
      if (type_class(dataset) != H5T_STRING) continue;
      const std::vector<std::string> texts = hdf5::read_texts(dataset);
      if (!texts.empty()) types.emplace(octave_name(name.substr(0, name.size() - octave_type.size())), texts.front());
    }
    return types;
  }

  Dataset open(const std::string& name, const Place& place) const {
    if (!place.from) return open_dataset(hdf5_, place.path);
    Handle id(H5Rdereference2(hdf5_.id.get(), H5P_DEFAULT, H5R_OBJECT, &*place.from));
    if (place.path.empty()) return to_dataset(hdf5_, std::move(id), "dataset " + name);
    hdf5::Object group;
    group.file = hdf5_.file;
    group.id = std::move(id);
    return open_dataset(group, place.path);
  }

  /// Samples of a variable that were unpacked with those that were asked for.
  struct Kept {
    std::size_t first = 0, count = 0, others = 1;
    std::vector<double> values{};

    bool holds(std::size_t from, std::size_t wanted) const { return from >= first && from + wanted <= first + count; }
    std::vector<double> part(std::size_t from, std::size_t wanted) const {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>((from - first) * others);
      return {begin, begin + static_cast<std::ptrdiff_t>(wanted * others)};
    }
  };

  /// Reads whole chunks: one that is read in pieces would be unpacked anew for each of them.
  const Kept& keep(const MatInfo& info, const Dataset& dataset, std::size_t first, std::size_t count, std::size_t chunk) {
    const std::size_t samples = *std::ranges::max_element(dataset.dims), others = size(dataset) / samples;
    const std::size_t from = first / chunk * chunk, to = std::min(samples, (first + count + chunk - 1) / chunk * chunk);
    if ((to - from) * others > most_kept) {
      hdf5::fail(dataset, "is stored in chunks of " + std::to_string((to - from) * others * sizeof(double) >> 20) + " MB",
           "store it in smaller ones, e.g. h5repack -l CHUNK=4096, or without chunks");
    }
    Kept& kept = kept_[info.name];
    kept = {from, to - from, others, {}};
    kept.values = hdf5::read_samples(dataset, from, to - from);
    return kept;
  }

  hdf5::Object hdf5_;
  bool by_rows_ = false;
  std::map<std::string, Place> place_of_;
  std::map<std::string, Kept> kept_;            ///< by variable
};

}  // namespace

std::unique_ptr<MatFile> hdf5::open_mat_v73(const std::filesystem::path& path) { return std::make_unique<MatV73>(path); }

}  // namespace jointid::frf
