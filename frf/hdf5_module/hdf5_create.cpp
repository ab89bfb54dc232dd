#include "frf/hdf5_module/hdf5_create.hpp"

#include <hdf5.h>

#include <utility>

namespace jointid::frf::hdf5 {
namespace {

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.get(), H5T_VARIABLE);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  return type;
}

bool write_attribute(const Handle& object, const char* name, const Handle& type, const void* value) {
  const Handle scalar(H5Screate(H5S_SCALAR));
  const Handle attribute(H5Acreate2(object.get(), name, type.get(), scalar.get(), H5P_DEFAULT, H5P_DEFAULT));
  return attribute.is_open() && H5Awrite(attribute.get(), type.get(), value) >= 0;
}

/// Writes a small dataset whole and returns it open.
Handle write_dataset(const Handle& file, const char* name, const Handle& type, std::vector<hsize_t> dims,
                     const void* data) {
  const Handle space(H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr));
  Handle dataset(
      H5Dcreate2(file.get(), name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  const bool ok =
      dataset.is_open() && H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0;
  return ok ? std::move(dataset) : Handle();
}

}  // namespace

bool write_text_attribute(const Handle& object, const char* name, const std::string& text) {
  const char* value = text.c_str();
  return write_attribute(object, name, text_type(), &value);
}

bool write_number_attribute(const Handle& object, const char* name, double value) {
  return write_attribute(object, name, Handle(H5Tcopy(H5T_NATIVE_DOUBLE)), &value);
}

bool write_integer_attribute(const Handle& object, const char* name, std::int64_t value) {
  return write_attribute(object, name, Handle(H5Tcopy(H5T_NATIVE_INT64)), &value);
}

bool write_axis(const Handle& file, const std::vector<double>& frequency_hz) {
  const Handle real(H5Tcopy(H5T_NATIVE_DOUBLE));
  const Handle axis = write_dataset(file, "frequency", real, {frequency_hz.size()}, frequency_hz.data());
  return axis.is_open() && write_text_attribute(axis, "unit", "Hz");
}

bool write_dofs(const Handle& file, const char* name, const std::vector<Dof>& dofs) {
  const std::vector<std::string> texts = names(dofs);
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  return write_dataset(file, name, text_type(), {dofs.size()}, pointers.data()).is_open();
}

bool write_nodes(const Handle& file, const std::vector<Node>& nodes) {
  if (nodes.empty()) return true;
  std::vector<std::int64_t> ids;
  std::vector<double> positions, axes;
  for (const Node& node : nodes) {
    ids.push_back(node.id);
    positions.insert(positions.end(), node.position.begin(), node.position.end());
    for (const auto& axis : node.axes.value_or(global_axes)) axes.insert(axes.end(), axis.begin(), axis.end());
  }
  const Handle integer(H5Tcopy(H5T_NATIVE_INT64));
  const Handle real(H5Tcopy(H5T_NATIVE_DOUBLE));
  return write_dataset(file, "node_id", integer, {ids.size()}, ids.data()).is_open() &&
         write_dataset(file, "node_position", real, {ids.size(), 3}, positions.data()).is_open() &&
         (!any_own_axes(nodes) || write_dataset(file, "node_axes", real, {ids.size(), 3, 3}, axes.data()).is_open());
}

Handle create_lines(const Handle& file, const char* name, const Handle& type,
                    const std::array<std::size_t, 3>& dims, std::size_t lines_per_chunk, int compression) {
  const std::array<hsize_t, 3> extent = {dims[0], dims[1], dims[2]};
  const std::array<hsize_t, 3> chunk = {lines_per_chunk, dims[1], dims[2]};
  const Handle create(H5Pcreate(H5P_DATASET_CREATE));
  const Handle access(H5Pcreate(H5P_DATASET_ACCESS));
  const Handle space(H5Screate_simple(3, extent.data(), nullptr));
  H5Pset_chunk(create.get(), 3, chunk.data());
  H5Pset_fill_time(create.get(), H5D_FILL_TIME_NEVER);
  // A chunk begun by one call and completed by the next must stay in memory, or it is compressed twice.
  H5Pset_chunk_cache(access.get(), 101, 2 * chunk[0] * chunk[1] * chunk[2] * sizeof(Complex), 1.0);
  if (compression > 0) {
    H5Pset_shuffle(create.get());
    H5Pset_deflate(create.get(), static_cast<unsigned>(compression));
  }
  return Handle(
      H5Dcreate2(file.get(), name, type.get(), space.get(), H5P_DEFAULT, create.get(), access.get()));
}

}  // namespace jointid::frf::hdf5
