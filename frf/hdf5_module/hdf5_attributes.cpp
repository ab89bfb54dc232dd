#include "frf/hdf5_module/hdf5_attributes.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <numeric>

namespace jointid::frf::hdf5 {
namespace {

std::vector<std::string> attribute_names(const Object& object) {
  constexpr std::size_t most = 100;
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5A_info_t*, void* kept) -> herr_t {
    auto& all = *static_cast<std::vector<std::string>*>(kept);
    all.emplace_back(name);
    return all.size() < most ? 0 : 1;
  };
  hsize_t place = 0;
  H5Aiterate2(object.id.get(), H5_INDEX_NAME, H5_ITER_NATIVE, &place, add, &names);
  return names;
}

std::optional<std::string> numbers_as_text(const Object& object, const char* name) {
  constexpr hssize_t most = 64;
  const Handle id(H5Aopen(object.id.get(), name, H5P_DEFAULT));
  if (!id.is_open()) return std::nullopt;
  const Handle type(H5Aget_type(id.get())), space(H5Aget_space(id.get()));
  const H5T_class_t kind = H5Tget_class(type.get());
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || count < 1 || count > most) return std::nullopt;
  std::vector<double> values(static_cast<std::size_t>(count));
  if (H5Aread(id.get(), H5T_NATIVE_DOUBLE, values.data()) < 0) return std::nullopt;
  const auto other = std::ranges::find_if(values, [](double value) { return value != 1.0; });
  return fmt::format("{}", other != values.end() ? *other : 1.0);
}

/// Texts of variable length, or of one length.
std::vector<std::string> texts_of(const Handle& id, const Handle& type, const Handle& space, std::size_t count) {
  std::vector<std::string> out;
  if (H5Tis_variable_str(type.get()) > 0) {
    std::vector<char*> labels(count, nullptr);
    if (H5Aread(id.get(), type.get(), labels.data()) < 0) return {};
    for (const char* label : labels) out.emplace_back(label != nullptr ? label : "");
    H5Dvlen_reclaim(type.get(), space.get(), H5P_DEFAULT, labels.data());
    return out;
  }
  constexpr std::size_t longest = 256;
  const std::size_t size = H5Tget_size(type.get());
  if (size == 0 || size > longest) return {};
  std::vector<char> bytes(count * size);
  if (H5Aread(id.get(), type.get(), bytes.data()) < 0) return {};
  for (std::size_t i = 0; i < count; ++i) {
    const std::string text(bytes.data() + i * size, size);
    out.push_back(text.substr(0, text.find('\0')));
  }
  return out;
}

/// "group.frequency" of what a reference leads to; empty where it leads nowhere.
std::string name_of(const Object& object, const hobj_ref_t& reference) {
  constexpr std::size_t longest = 1024;
  const Handle id(H5Rdereference2(object.id.get(), H5P_DEFAULT, H5R_OBJECT, &reference));
  if (!id.is_open() || H5Iget_type(id.get()) != H5I_DATASET) return {};
  std::string path(longest, '\0');
  const ssize_t size = H5Iget_name(id.get(), path.data(), path.size());
  if (size < 2 || static_cast<std::size_t>(size) >= longest) return {};
  path = path.substr(1, static_cast<std::size_t>(size) - 1);
  std::ranges::replace(path, '/', '.');
  return path;
}

}  // namespace

std::optional<std::string> joined_texts(const Object& object, const char* name) {
  constexpr hssize_t most = 1024;
  if (H5Aexists(object.id.get(), name) <= 0) return std::nullopt;
  const Handle id(H5Aopen(object.id.get(), name, H5P_DEFAULT));
  if (!id.is_open()) return std::nullopt;
  const Handle type(H5Aget_type(id.get())), space(H5Aget_space(id.get()));
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (H5Tget_class(type.get()) != H5T_STRING || count < 1 || count > most) return std::nullopt;
  const std::vector<std::string> texts = texts_of(id, type, space, static_cast<std::size_t>(count));
  if (texts.empty()) return std::nullopt;
  return std::accumulate(texts.begin() + 1, texts.end(), texts.front(),
                         [](std::string all, const std::string& next) { return all + "," + next; });
}

std::vector<std::string> names_of_scales(const Object& object) {
  constexpr hssize_t most = 8;
  if (H5Aexists(object.id.get(), "DIMENSION_LIST") <= 0) return {};
  const Handle id(H5Aopen(object.id.get(), "DIMENSION_LIST", H5P_DEFAULT));
  if (!id.is_open()) return {};
  const Handle type(H5Aget_type(id.get())), space(H5Aget_space(id.get())), memory(H5Tvlen_create(H5T_STD_REF_OBJ));
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (H5Tequal(type.get(), memory.get()) <= 0 || count < 1 || count > most) return {};
  std::vector<hvl_t> scales(static_cast<std::size_t>(count));
  if (H5Aread(id.get(), memory.get(), scales.data()) < 0) return {};
  std::vector<std::string> names;
  for (const hvl_t& of_axis : scales)
    names.push_back(of_axis.len > 0 ? name_of(object, *static_cast<const hobj_ref_t*>(of_axis.p)) : std::string());
  H5Dvlen_reclaim(memory.get(), space.get(), H5P_DEFAULT, scales.data());
  const bool any = std::ranges::any_of(names, [](const std::string& name) { return !name.empty(); });
  return any ? names : std::vector<std::string>();
}

std::vector<std::pair<std::string, std::string>> attributes_as_texts(const Object& object) {
  std::vector<std::pair<std::string, std::string>> all;
  for (std::string& name : attribute_names(object)) {
    const char* own = name.c_str();
    auto text = has_text_attribute(object, own) ? text_attribute(object, own) : joined_texts(object, own);
    if (!text) text = numbers_as_text(object, own);
    if (text) all.emplace_back(std::move(name), *text);
  }
  return all;
}

}  // namespace jointid::frf::hdf5
