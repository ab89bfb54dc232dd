#include "frf/hdf5_module/hdf5_attributes.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <optional>

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
  return fmt::format("{:g}", other != values.end() ? *other : 1.0);
}

/// The names of the axes, "frequency,response,reference".
std::optional<std::string> labels_of_axes(const Object& object, const char* name) {
  constexpr hssize_t most = 8;
  const Handle id(H5Aopen(object.id.get(), name, H5P_DEFAULT));
  if (!id.is_open()) return std::nullopt;
  const Handle type(H5Aget_type(id.get())), space(H5Aget_space(id.get()));
  const hssize_t count = H5Sget_simple_extent_npoints(space.get());
  if (H5Tis_variable_str(type.get()) <= 0 || count < 1 || count > most) return std::nullopt;
  std::vector<char*> labels(static_cast<std::size_t>(count), nullptr);
  if (H5Aread(id.get(), type.get(), labels.data()) < 0) return std::nullopt;
  std::string joined;
  for (const char* label : labels) joined += (joined.empty() ? "" : ",") + std::string(label != nullptr ? label : "");
  H5Dvlen_reclaim(type.get(), space.get(), H5P_DEFAULT, labels.data());
  return joined;
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
    if (name == "DIMENSION_LABELS") {
      if (auto labels = labels_of_axes(object, own)) all.emplace_back(std::move(name), std::move(*labels));
      continue;
    }
    const auto text = has_text_attribute(object, own) ? text_attribute(object, own) : numbers_as_text(object, own);
    if (text) all.emplace_back(std::move(name), *text);
  }
  return all;
}

}  // namespace jointid::frf::hdf5
