#include <hdf5.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

#include "frf/hdf5_module/files.hpp"
#include "frf/hdf5_module/hdf5_object.hpp"

namespace jointid::frf {
namespace {

using hdf5::Dataset;
using hdf5::Handle;

constexpr int deepest_group = 8;
constexpr std::size_t most_groups = 10'000;              ///< links may lead round in circles
constexpr std::size_t most_kept = std::size_t{1} << 25;  ///< numbers of a chunk that is held in memory

/// Paths of the datasets of a group and of the groups in it (structs of MATLAB), "S/field"; not of what MATLAB keeps to itself, "#refs#".
struct Paths {
  std::vector<std::string> found;
  std::string group;
  int depth = 0;
  std::size_t groups = 0;
};

void add_paths(hid_t group, Paths& paths) {
  const auto keep = [](hid_t group, const char* name, const H5L_info_t* link, void* kept) -> herr_t {
    auto& out = *static_cast<Paths*>(kept);
    H5O_info_t object;
    if (link->type != H5L_TYPE_HARD || H5Oget_info_by_name(group, name, &object, H5P_DEFAULT) < 0) return 0;
    if (object.type == H5O_TYPE_DATASET) out.found.push_back(out.group + name);
    if (object.type == H5O_TYPE_GROUP && name[0] != '#' && out.depth < deepest_group && out.groups < most_groups) {
      const Handle inner(H5Gopen2(group, name, H5P_DEFAULT));
      const std::string outer = out.group;
      out.group += std::string(name) + "/";
      ++out.depth;
      ++out.groups;
      if (inner.is_open()) add_paths(inner.get(), out);
      --out.depth;
      out.group = outer;
    }
    return 0;
  };
  H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, keep, &paths);
}

std::string dotted(std::string path) {
  std::ranges::replace(path, '/', '.');
  return path;
}

std::string matlab_class(const Dataset& dataset) {
  return hdf5::text_attribute(dataset, "MATLAB_class").value_or("");
}

H5T_class_t type_class(const Dataset& dataset) {
  const Handle type(H5Dget_type(dataset.id.get()));
  return H5Tget_class(type.get());
}

MatKind kind_of(const Dataset& dataset) {
  const std::string name = matlab_class(dataset);
  if (hdf5::number_attribute(dataset, "MATLAB_empty").value_or(0.0) != 0.0) return MatKind::other;
  if (name == "char" || name == "cell" || type_class(dataset) == H5T_STRING) return MatKind::text;
  if (hdf5::is_complex(dataset, "real", "imag")) return MatKind::complex;
  return hdf5::is_real(dataset) ? MatKind::real : MatKind::other;
}

/// The attribute unit or units, in any case, of one text.
std::string unit_of(const Dataset& dataset) {
  for (const char* name : {"unit", "units", "Unit", "Units", "UNIT", "UNITS"}) {
    if (hdf5::has_text_attribute(dataset, name)) return hdf5::text_attribute(dataset, name).value_or("");
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
  const Handle type = hdf5::complex_type("real", "imag");
  if (H5Dread(dataset.id.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    fail(dataset, "cannot be read: " + hdf5::last_failure());
  }
  return values;
}

/// Rows of a MATLAB character array [rows, columns], which HDF5 sees as [columns, rows]; codes beyond ASCII
/// become '?'.
std::vector<std::string> read_characters(const Dataset& dataset) {
  const std::vector<double> codes = hdf5::read_doubles(dataset);
  const std::size_t rows = dataset.dims.size() == 2 ? dataset.dims[1] : 1;
  std::vector<std::string> texts(rows);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    texts[i % rows] += codes[i] > 0.0 && codes[i] < 128.0 ? static_cast<char>(codes[i]) : '?';
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
    const Dataset cell =
        to_dataset(file, std::move(id), dataset.place + ", cell " + std::to_string(texts.size() + 1));
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

class MatV73 final : public MatFile {
 public:
  explicit MatV73(const std::filesystem::path& path) : MatFile(path.string()) {
    const hdf5::Silence silence;
    hdf5_ = hdf5::open_file(path);
    hdf5::limit_metadata(hdf5_.id, std::size_t{2} << 20);  // enough for reading fast, however long the record
    Paths paths;
    add_paths(hdf5_.id.get(), paths);
    for (const std::string& path_inside : paths.found) {
      const Dataset dataset = open_dataset(hdf5_, path_inside);
      path_of_.emplace(dotted(path_inside), path_inside);
      variables_.push_back(
          {dotted(path_inside), kind_of(dataset), {dataset.dims.rbegin(), dataset.dims.rend()}, unit_of(dataset)});
    }
  }

  MatVariable read(const MatInfo& info) override {
    const hdf5::Silence silence;
    const Dataset dataset = open_dataset(hdf5_, path_of_.at(info.name));
    MatVariable variable{.info = info, .values = {}, .texts = {}};
    if (info.kind == MatKind::text) {
      variable.texts = read_texts(hdf5_, dataset);
    } else {
      variable.values = read_values(dataset, info.kind);
    }
    return variable;
  }

  bool reads_samples() const override { return true; }

  std::vector<double> read_samples(const MatInfo& info, std::size_t first, std::size_t count) override {
    const hdf5::Silence silence;
    const auto kept = kept_.find(info.name);
    if (kept != kept_.end() && kept->second.holds(first, count)) return kept->second.part(first, count);
    const Dataset dataset = open_dataset(hdf5_, path_of_.at(info.name));
    const std::size_t chunk = hdf5::samples_in_chunk(dataset);
    if (chunk <= count) return hdf5::read_samples(dataset, first, count);
    return keep(info, dataset, first, count, chunk).part(first, count);
  }

 private:
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
  std::map<std::string, std::string> path_of_;  ///< S/field of S.field
  std::map<std::string, Kept> kept_;            ///< by variable
};

}  // namespace

std::unique_ptr<MatFile> hdf5::open_mat_v73(const std::filesystem::path& path) {
  return std::make_unique<MatV73>(path);
}

}  // namespace jointid::frf
