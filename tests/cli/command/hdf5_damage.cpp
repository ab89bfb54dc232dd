#include "hdf5_damage.hpp"

#include <hdf5.h>

#include <stdexcept>

namespace jointid::cli {
namespace {

/// Lets `change` have an HDF5 file of the folder, open for writing.
Spoil in_file(std::string name, std::function<void(hid_t)> change) {
  return [=](const InputFolder& folder) {
    const hid_t file = H5Fopen(folder.path(name).c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    if (file < 0) throw std::runtime_error("cannot open " + name);
    change(file);
    if (H5Fclose(file) < 0) throw std::runtime_error("cannot close " + name);
  };
}

hid_t text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  return type;
}

void set_attribute(hid_t file, const char* object, const std::string& name, hid_t type, const void* value) {
  if (H5Aexists_by_name(file, object, name.c_str(), H5P_DEFAULT) > 0) {
    H5Adelete_by_name(file, object, name.c_str(), H5P_DEFAULT);
  }
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t attribute =
      H5Acreate_by_name(file, object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  if (H5Awrite(attribute, type, value) < 0) throw std::runtime_error("cannot write " + name);
  H5Aclose(attribute);
}

void set_text_attribute(hid_t file, const char* object, const std::string& name, const char* text) {
  set_attribute(file, object, name, text_type(), &text);
}

void set_dataset(hid_t file, const std::string& name, hid_t type, const std::vector<hsize_t>& dims, const void* data) {
  if (H5Lexists(file, name.c_str(), H5P_DEFAULT) > 0) H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  const hid_t space = H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr);
  const hid_t dataset = H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  if (H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0) {
    throw std::runtime_error("cannot write " + name);
  }
  H5Dclose(dataset);
}

}  // namespace

Spoil hdf5_text_attribute(std::string file, std::string name, std::string text) {
  return in_file(file, [=](hid_t id) { set_text_attribute(id, "/", name, text.c_str()); });
}

Spoil hdf5_number_attribute(std::string file, std::string name, double value) {
  return in_file(file, [=](hid_t id) { set_attribute(id, "/", name, H5T_NATIVE_DOUBLE, &value); });
}

Spoil hdf5_without(std::string file, std::string dataset) {
  return in_file(file, [=](hid_t id) { H5Ldelete(id, dataset.c_str(), H5P_DEFAULT); });
}

Spoil hdf5_frequency(std::string file, std::vector<double> hz) {
  return in_file(file, [=](hid_t id) {
    set_dataset(id, "frequency", H5T_NATIVE_DOUBLE, {hz.size()}, hz.data());
    set_text_attribute(id, "frequency", "unit", "Hz");
  });
}

Spoil hdf5_texts(std::string file, std::string dataset, std::vector<std::string> texts) {
  return in_file(file, [=](hid_t id) {
    std::vector<const char*> pointers;
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    set_dataset(id, dataset, text_type(), {texts.size()}, pointers.data());
  });
}

Spoil hdf5_coherence(std::string file, std::vector<double> values) {
  return in_file(file, [=](hid_t id) {
    set_dataset(id, "coherence", H5T_NATIVE_DOUBLE, {3, 2, 1}, values.data());
    const double averages = 10.0;
    set_attribute(id, "coherence", "averages", H5T_NATIVE_DOUBLE, &averages);
  });
}

namespace {

hid_t complex_type() {
  const hid_t type = H5Tcreate(H5T_COMPOUND, 16);
  H5Tinsert(type, "r", 0, H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "i", 8, H5T_NATIVE_DOUBLE);
  return type;
}

void zero_frf(hid_t file, hid_t type, const std::vector<hsize_t>& dims) {
  std::size_t count = 2;
  for (const hsize_t extent : dims) count *= extent;
  set_dataset(file, "frf", type, dims, std::vector<double>(count).data());
}

/// frf anew, with nothing in it.
void create_frf(hid_t file, hid_t type, const std::vector<hsize_t>& dims, hid_t create) {
  H5Ldelete(file, "frf", H5P_DEFAULT);
  const hid_t space = H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr);
  const hid_t dataset = H5Dcreate2(file, "frf", type, space, H5P_DEFAULT, create, H5P_DEFAULT);
  if (dataset < 0) throw std::runtime_error("cannot make frf");
  H5Dclose(dataset);
  set_text_attribute(file, "frf", "quantity", "receptance");
  set_text_attribute(file, "frf", "unit", "m/N");
}

}  // namespace

Spoil hdf5_real_frf(std::string file, std::vector<unsigned long long> dims) {
  return in_file(file, [=](hid_t id) { zero_frf(id, H5T_NATIVE_DOUBLE, {dims.begin(), dims.end()}); });
}

Spoil hdf5_complex_frf(std::string file, std::vector<unsigned long long> dims) {
  return in_file(file, [=](hid_t id) { zero_frf(id, complex_type(), {dims.begin(), dims.end()}); });
}

Spoil hdf5_filtered_frf(std::string file, int filter) {
  return in_file(file, [=](hid_t id) {
    const hid_t create = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk[] = {1, 2, 1};
    H5Pset_chunk(create, 3, chunk);
    H5Pset_filter(create, filter, H5Z_FLAG_OPTIONAL, 0, nullptr);
    create_frf(id, complex_type(), {3, 2, 1}, create);
    const hid_t frf = H5Dopen2(id, "frf", H5P_DEFAULT);
    const std::vector<double> line(4);
    for (hsize_t i = 0; i < 3; ++i) {
      const hsize_t at[] = {i, 0, 0};
      H5Dwrite_chunk(frf, H5P_DEFAULT, 0, at, line.size() * sizeof(double), line.data());
    }
    H5Dclose(frf);
  });
}

Spoil hdf5_empty_frf(std::string file, std::vector<unsigned long long> dims) {
  return in_file(file, [=](hid_t id) { create_frf(id, complex_type(), {dims.begin(), dims.end()}, H5P_DEFAULT); });
}

Spoil hdf5_external_link(std::string file, std::string dataset) {
  return in_file(file, [=](hid_t id) {
    H5Ldelete(id, dataset.c_str(), H5P_DEFAULT);
    H5Lcreate_external("b.h5", dataset.c_str(), id, dataset.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  });
}

}  // namespace jointid::cli
