#include "frf/hdf5_module/hdf5_object.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <complex>
#include <functional>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "frf/hdf5_module/hdf5_checked_disk.hpp"
#include "frf/hdf5_module/hdf5_first_look.hpp"

namespace jointid::frf::hdf5 {
namespace {

/// Deflate, the strongest of the usual filters, packs at best 1032 bytes into one.
constexpr double best_compression = 1100.0;

/// Reads `count` strings of the type `type` with `read(memory_type, buffer)`; false on failure.
using RawRead = std::function<herr_t(hid_t, void*)>;

bool read_variable_strings(hid_t type, hid_t space, std::size_t count, const RawRead& read,
                           std::vector<std::string>& out, std::string& why) {
  std::vector<char*> pointers(count, nullptr);
  const bool ok = read(type, pointers.data()) >= 0;
  if (!ok) why = last_failure();  // which the next call forgets
  for (std::size_t i = 0; ok && i < count; ++i) out.emplace_back(pointers[i] == nullptr ? "" : pointers[i]);
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data());
  return ok;
}

bool read_fixed_strings(hid_t type, std::size_t count, const RawRead& read, std::vector<std::string>& out, std::string& why) {
  const std::size_t width = H5Tget_size(type);
  const bool blanks = H5Tget_strpad(type) == H5T_STR_SPACEPAD;
  std::string bytes(count * width, '\0');
  if (read(type, bytes.data()) < 0) {
    why = last_failure();
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    std::string text = bytes.substr(i * width, width);
    text.resize(std::min(text.size(), text.find('\0')));
    if (blanks) text.resize(text.find_last_not_of(' ') + 1);
    out.push_back(std::move(text));
  }
  return true;
}

/// Throws InputError about `object` where HDF5 cannot.
std::vector<std::string> read_strings(const Object& object, hid_t type, hid_t space, std::size_t count, const RawRead& read) {
  std::vector<std::string> out;
  std::string why;
  const bool ok = H5Tis_variable_str(type) > 0 ? read_variable_strings(type, space, count, read, out, why)
                                               : read_fixed_strings(type, count, read, out, why);
  if (!ok) fail(object, "cannot be read: " + why);
  return out;
}

std::size_t product(const std::vector<std::size_t>& dims) {
  return std::accumulate(dims.begin(), dims.end(), std::size_t{1}, std::multiplies<>());
}

double size_of_file(const Handle& id) {
  const Handle file(H5Iget_file_id(id.get()));
  hsize_t bytes = 0;
  return H5Fget_filesize(file.get(), &bytes) < 0 ? 0.0 : static_cast<double>(bytes);
}

/// A header that declares more than is stored must not make us allocate for it; what it says of the storage is held against the file.
void require_stored(const Dataset& dataset) {
  const Handle type(H5Dget_type(dataset.id.get()));
  double bytes = static_cast<double>(H5Tget_size(type.get()));
  for (const std::size_t extent : dataset.dims) bytes *= static_cast<double>(extent);
  const double stored = std::min(static_cast<double>(H5Dget_storage_size(dataset.id.get())), size_of_file(dataset.id));
  if (bytes <= stored * (is_filtered(dataset) ? best_compression : 1.0)) return;
  fail(dataset,
       "declares " + std::to_string(bytes / 1e6) + " MB and stores " + std::to_string(stored / 1e6) + " MB",
       "the file was not written to its end");
}

void require_own_storage(const Dataset& dataset) {
  const Handle plist(H5Dget_create_plist(dataset.id.get()));
  if (H5Pget_layout(plist.get()) == H5D_VIRTUAL || H5Pget_external_count(plist.get()) > 0) {
    fail(dataset, "its data lie in other files", "copy them into one file, e.g. with h5repack");
  }
}

void require_known_filters(const Dataset& dataset) {
  const Handle plist(H5Dget_create_plist(dataset.id.get()));
  const int count = H5Pget_nfilters(plist.get());
  for (int i = 0; i < count; ++i) {
    unsigned flags = 0, config = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(plist.get(), static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, &config);
    if (filter >= 0 && H5Zfilter_avail(filter) > 0) continue;
    fail(dataset, "is packed by filter " + std::to_string(filter) + ", which the HDF5 library here does not have",
         "repack it where it was written: h5repack -f GZIP=6");
  }
}

std::vector<std::size_t> extents(const Object& object) {
  const Handle space(H5Dget_space(object.id.get()));
  const int rank = H5Sget_simple_extent_ndims(space.get());
  if (rank < 0) fail(object, "has no dimensions that HDF5 can read");
  std::vector<hsize_t> dims(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space.get(), dims.data(), nullptr);
  if (H5Sget_simple_extent_type(space.get()) == H5S_NULL) return {0};
  return {dims.begin(), dims.end()};
}

/// The axis that counts the samples: the longer one, the last of equal ones.
std::size_t along_samples(const Dataset& dataset) {
  return dataset.dims.size() == 2 && dataset.dims[0] > dataset.dims[1] ? 0 : dataset.dims.size() - 1;
}

/// Opens an attribute of one element whose type has one of the classes in `accept`.
struct Attribute {
  Handle id;
  Handle type;
  Handle space;
  Object named;  ///< for messages
};

std::optional<Attribute> open_attribute(const Object& object, const char* name) {
  if (H5Aexists(object.id.get(), name) <= 0) return std::nullopt;
  Attribute attribute;
  attribute.named.file = object.file;
  attribute.named.place = (object.place.empty() ? "root" : object.place) + " attribute " + name;
  attribute.id = Handle(H5Aopen(object.id.get(), name, H5P_DEFAULT));
  if (!attribute.id.is_open()) fail(attribute.named, "cannot be read: " + last_failure());
  attribute.type = Handle(H5Aget_type(attribute.id.get()));
  attribute.space = Handle(H5Aget_space(attribute.id.get()));
  if (H5Sget_simple_extent_npoints(attribute.space.get()) != 1)
    fail(attribute.named, "is not a single value");
  if (static_cast<double>(H5Aget_storage_size(attribute.id.get())) > size_of_file(attribute.id))
    fail(attribute.named, "is larger than the file");
  return attribute;
}

std::string text_of(Finding finding) {
  if (finding == Finding::crash) return "its contents crash the HDF5 library";
  return finding == Finding::no_end ? "the HDF5 library comes to no end with it" : "to read it takes more memory than its size explains";
}

bool is_number(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_FLOAT || kind == H5T_INTEGER;
}

}  // namespace

void fail(const Object& object, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = object.file,
                    .place = object.place,
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

Object open_file(const std::filesystem::path& path) {
  Object file{.id = {}, .file = path.string(), .place = {}};
  Finding finding = Finding::nothing;
  file.id = open_checked(path, [&](const std::filesystem::path& name) {
    finding = first_look(name);
    return finding == Finding::nothing;
  });
  if (finding != Finding::nothing) fail(file, "is damaged: " + text_of(finding), "write it again where it came from, or copy it again");
  if (!file.id.is_open()) {
    fail(file, "cannot be opened as HDF5: " + last_failure(),
         "the file is damaged, truncated or being written");
  }
  return file;
}

bool has(const Object& file, const std::string& name) {
  return H5Lexists(file.id.get(), name.c_str(), H5P_DEFAULT) > 0;
}

Dataset open_dataset(const Object& file, const std::string& name) {
  const Object dataset{.id = {}, .file = file.file, .place = "dataset " + name};
  H5L_info_t link;
  if (!has(file, name) || H5Lget_info(file.id.get(), name.c_str(), &link, H5P_DEFAULT) < 0) {
    fail(dataset, "is missing", "write the file again; `jointid convert` makes whole ones");
  }
  if (link.type != H5L_TYPE_HARD)
    fail(dataset, "is a link to somewhere else", "copy the data into this file");
  return to_dataset(file, Handle(H5Oopen(file.id.get(), name.c_str(), H5P_DEFAULT)), dataset.place);
}

Dataset to_dataset(const Object& file, Handle id, std::string place) {
  Dataset dataset;
  dataset.file = file.file;
  dataset.place = std::move(place);
  dataset.id = std::move(id);
  if (!dataset.id.is_open()) fail(dataset, "cannot be opened: " + last_failure());
  if (H5Iget_type(dataset.id.get()) != H5I_DATASET) fail(dataset, "is not a dataset");
  dataset.dims = extents(dataset);
  require_own_storage(dataset);
  require_known_filters(dataset);
  require_stored(dataset);
  return dataset;
}

bool is_filtered(const Dataset& dataset) {
  const Handle plist(H5Dget_create_plist(dataset.id.get()));
  return H5Pget_nfilters(plist.get()) != 0;
}

std::optional<std::string> text_attribute(const Object& object, const char* name) {
  const auto attribute = open_attribute(object, name);
  if (!attribute) return std::nullopt;
  if (H5Tget_class(attribute->type.get()) != H5T_STRING) fail(attribute->named, "is not text");
  const auto read = [&](hid_t type, void* to) { return H5Aread(attribute->id.get(), type, to); };
  return read_strings(attribute->named, attribute->type.get(), attribute->space.get(), 1, read).front();
}

std::optional<double> number_attribute(const Object& object, const char* name) {
  const auto attribute = open_attribute(object, name);
  if (!attribute) return std::nullopt;
  if (!is_number(attribute->type.get())) fail(attribute->named, "is not a number");
  double value = std::numeric_limits<double>::quiet_NaN();
  if (H5Aread(attribute->id.get(), H5T_NATIVE_DOUBLE, &value) < 0) {
    fail(attribute->named, "cannot be read: " + last_failure());
  }
  return value;
}

bool has_text_attribute(const Object& object, const char* name) {
  if (H5Aexists(object.id.get(), name) <= 0) return false;
  const Handle id(H5Aopen(object.id.get(), name, H5P_DEFAULT));
  if (!id.is_open()) return false;
  const Handle type(H5Aget_type(id.get())), space(H5Aget_space(id.get()));
  return H5Tget_class(type.get()) == H5T_STRING && H5Sget_simple_extent_npoints(space.get()) == 1;
}

std::vector<double> read_doubles(const Dataset& dataset) {
  if (!is_real(dataset)) fail(dataset, "does not hold real numbers");
  std::vector<double> values(product(dataset.dims));
  if (H5Dread(dataset.id.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    fail(dataset, "cannot be read: " + last_failure());
  }
  return values;
}

std::size_t samples_in_chunk(const Dataset& dataset) {
  const Handle plist(H5Dget_create_plist(dataset.id.get()));
  const std::size_t rank = dataset.dims.size();
  if (rank == 0 || rank > 2 || H5Pget_layout(plist.get()) != H5D_CHUNKED) return 1;
  std::array<hsize_t, 2> extent{};
  if (H5Pget_chunk(plist.get(), static_cast<int>(rank), extent.data()) < 0) return 1;
  return std::min<std::size_t>(extent[along_samples(dataset)], dataset.dims[along_samples(dataset)]);
}

std::vector<double> read_samples(const Dataset& dataset, std::size_t first, std::size_t count) {
  if (!is_real(dataset)) fail(dataset, "does not hold real numbers");
  if (dataset.dims.empty() || dataset.dims.size() > 2) fail(dataset, "is no vector or matrix");
  const std::size_t along = along_samples(dataset);
  std::vector<hsize_t> from(dataset.dims.size(), 0), extent(dataset.dims.begin(), dataset.dims.end());
  if (first + count > dataset.dims[along]) fail(dataset, "has " + std::to_string(dataset.dims[along]) + " samples only");
  from[along] = first, extent[along] = count;
  const int rank = static_cast<int>(extent.size());
  const Handle stored(H5Dget_space(dataset.id.get())), memory(H5Screate_simple(rank, extent.data(), nullptr));
  H5Sselect_hyperslab(stored.get(), H5S_SELECT_SET, from.data(), nullptr, extent.data(), nullptr);
  const std::size_t others = dataset.dims.size() == 2 ? dataset.dims[1 - along] : 1;
  std::vector<double> values(count * others);
  if (H5Dread(dataset.id.get(), H5T_NATIVE_DOUBLE, memory.get(), stored.get(), H5P_DEFAULT, values.data()) < 0) {
    fail(dataset, "cannot be read: " + last_failure());
  }
  if (along == 0 || others == 1) return values;
  std::vector<double> turned(values.size());
  for (std::size_t k = 0; k < others; ++k) {
    for (std::size_t i = 0; i < count; ++i) turned[i * others + k] = values[k * count + i];
  }
  return turned;
}

std::vector<std::string> read_texts(const Dataset& dataset) {
  const Handle type(H5Dget_type(dataset.id.get()));
  const Handle space(H5Dget_space(dataset.id.get()));
  if (H5Tget_class(type.get()) != H5T_STRING) fail(dataset, "does not hold text");
  const auto read = [&](hid_t memory, void* to) {
    return H5Dread(dataset.id.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, to);
  };
  return read_strings(dataset, type.get(), space.get(), product(dataset.dims), read);
}

Handle complex_type(const char* real, const char* imaginary) {
  Handle type(H5Tcreate(H5T_COMPOUND, sizeof(std::complex<double>)));
  H5Tinsert(type.get(), real, 0, H5T_NATIVE_DOUBLE);
  H5Tinsert(type.get(), imaginary, sizeof(double), H5T_NATIVE_DOUBLE);
  return type;
}

bool is_complex(const Dataset& dataset, const char* real, const char* imaginary) {
  const Handle type(H5Dget_type(dataset.id.get()));
  if (H5Tget_class(type.get()) != H5T_COMPOUND || H5Tget_nmembers(type.get()) != 2) return false;
  return std::ranges::all_of(std::array{real, imaginary}, [&](const char* name) {
    const int member = H5Tget_member_index(type.get(), name);
    return member >= 0 && H5Tget_member_class(type.get(), static_cast<unsigned>(member)) == H5T_FLOAT;
  });
}

std::optional<std::array<std::string, 2>> complex_members(const Dataset& dataset) {
  constexpr std::array<std::array<std::string_view, 2>, 4> known = {{{"real", "imag"}, {"r", "i"}, {"re", "im"}, {"real", "imaginary"}}};
  const Handle type(H5Dget_type(dataset.id.get()));
  if (H5Tget_class(type.get()) != H5T_COMPOUND || H5Tget_nmembers(type.get()) != 2) return std::nullopt;
  std::array<std::string, 2> names;
  for (const unsigned member : {0U, 1U}) {
    char* name = H5Tget_member_name(type.get(), member);
    if (name == nullptr) return std::nullopt;
    names[member] = name;
    H5free_memory(name);
  }
  std::array<std::string, 2> plain = names;
  for (std::string& name : plain) {
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  }
  for (const auto& [real, imaginary] : known) {
    const bool turned = plain[0] == imaginary && plain[1] == real;
    if (!turned && (plain[0] != real || plain[1] != imaginary)) continue;
    if (turned) std::swap(names[0], names[1]);
    if (is_complex(dataset, names[0].c_str(), names[1].c_str())) return names;
  }
  return std::nullopt;
}

std::optional<std::string> any_text_attribute(const Object& object, std::string_view name) {
  struct Search {
    std::string_view wanted;
    std::string found;
  } search{name, {}};
  const auto compare = [](hid_t, const char* own, const H5A_info_t*, void* kept) -> herr_t {
    auto& of = *static_cast<Search*>(kept);
    const std::string_view text(own);
    const auto lower = [](unsigned char c) { return std::tolower(c); };
    if (!std::ranges::equal(text, of.wanted, {}, lower, lower)) return 0;
    of.found = own;
    return 1;
  };
  hsize_t place = 0;
  H5Aiterate2(object.id.get(), H5_INDEX_NAME, H5_ITER_NATIVE, &place, compare, &search);
  return search.found.empty() ? std::nullopt : text_attribute(object, search.found.c_str());
}

bool is_real(const Dataset& dataset) {
  const Handle type(H5Dget_type(dataset.id.get()));
  return is_number(type.get());
}

}  // namespace jointid::frf::hdf5
