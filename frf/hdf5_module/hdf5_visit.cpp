#include "frf/hdf5_module/hdf5_visit.hpp"

#include <hdf5.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <new>
#include <set>
#include <string>
#include <vector>


namespace jointid::frf::hdf5 {
namespace {

constexpr double most_data = 4e6;  ///< bytes
constexpr std::size_t deepest = 32;  ///< groups in groups

/// Datasets that readers open by name.
constexpr std::array known = {"frequency", "response_dof", "reference_dof", "frf", "variance", "coherence", "covariance",
                              "covariance_factor", "covariance_diagonal", "reference_correlation", "node_id", "node_position",
                              "node_axes", "column", "unit", "truth", "rows", "column_checksum"};

using Read = std::function<herr_t(hid_t type, void* to)>;

/// Whether the last failure was that there was no memory.
bool lacks_memory() {
  bool lacks = false;
  const auto look = [](unsigned, const H5E_error2_t* error, void* to) -> herr_t {
    if (error->min_num == H5E_NOSPACE) *static_cast<bool*>(to) = true;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, look, &lacks);
  return lacks;
}

/// Two numbers of these names.
Handle pair_of(const char* first, const char* second) {
  Handle type(H5Tcreate(H5T_COMPOUND, 2 * sizeof(double)));
  H5Tinsert(type.get(), first, 0, H5T_NATIVE_DOUBLE);
  H5Tinsert(type.get(), second, sizeof(double), H5T_NATIVE_DOUBLE);
  return type;
}

class Visit {
 public:
  bool enough() const { return enough_; }

  void note(herr_t result) { enough_ = enough_ && (result >= 0 || !lacks_memory()); }

  void object(hid_t parent, const char* name) {
    const Handle opened(H5Oopen(parent, name, H5P_DEFAULT));
    note(opened.is_open() ? 0 : -1);
    H5O_info_t info{};
    if (!opened.is_open() || (H5Oget_info2(opened.get(), &info, H5O_INFO_BASIC) >= 0 && !seen_.insert(info.addr).second)) return;
    for (const H5_iter_order_t order : {H5_ITER_NATIVE, H5_ITER_INC}) {
      note(H5Aiterate2(opened.get(), H5_INDEX_NAME, order, nullptr, visit_attribute, this));
    }
    if (H5Iget_type(opened.get()) == H5I_DATASET) dataset(opened.get());
    if (H5Iget_type(opened.get()) == H5I_GROUP) members(opened.get());
  }

 private:
  /// One by one, so that one which cannot be opened does not hide the others.
  void members(hid_t group) {
    if (depth_ > deepest) return;
    std::vector<std::string> names;
    const auto keep = [](hid_t, const char* name, const H5L_info_t* link, void* to) -> herr_t {
      if (link->type == H5L_TYPE_HARD) static_cast<std::vector<std::string>*>(to)->emplace_back(name);
      return 0;
    };
    note(H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, keep, &names));
    ++depth_;
    for (const std::string& name : names) object(group, name.c_str());
    --depth_;
  }

  static herr_t visit_attribute(hid_t object, const char* name, const H5A_info_t*, void* visit) {
    static_cast<Visit*>(visit)->attribute(object, name);
    return 0;
  }

  void attribute(hid_t object, const char* name) {
    const Handle opened(H5Aopen(object, name, H5P_DEFAULT));
    note(opened.is_open() ? 0 : -1);
    if (!opened.is_open()) return;
    const Handle type(H5Aget_type(opened.get())), space(H5Aget_space(opened.get()));
    elements(type, space, [&](hid_t memory, void* to) { return H5Aread(opened.get(), memory, to); });
  }

  void dataset(hid_t id) {
    const Handle type(H5Dget_type(id)), space(H5Dget_space(id)), create(H5Dget_create_plist(id));
    H5Dget_storage_size(id);
    hsize_t chunks = 0;
    if (H5Pget_layout(create.get()) == H5D_CHUNKED) note(H5Dget_num_chunks(id, space.get(), &chunks));
    if (H5Pget_layout(create.get()) == H5D_VIRTUAL || H5Pget_external_count(create.get()) > 0) return;
    const double bytes = static_cast<double>(H5Sget_simple_extent_npoints(space.get())) * static_cast<double>(H5Tget_size(type.get()));
    if (bytes <= left_) {
      left_ -= bytes;
      elements(type, space, [&](hid_t memory, void* to) { return H5Dread(id, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, to); });
    } else {
      for (const bool last : {false, true}) element(id, type, space, last);
    }
  }

  /// The first or the last one.
  void element(hid_t id, const Handle& type, const Handle& space, bool last) {
    const int rank = H5Sget_simple_extent_ndims(space.get());
    if (rank < 1) return;
    std::vector<hsize_t> at(static_cast<std::size_t>(rank)), one(at.size(), 1);
    H5Sget_simple_extent_dims(space.get(), at.data(), nullptr);
    for (hsize_t& index : at) index = last && index > 0 ? index - 1 : 0;
    const Handle stored(H5Scopy(space.get())), memory(H5Screate(H5S_SCALAR));
    H5Sselect_hyperslab(stored.get(), H5S_SELECT_SET, at.data(), nullptr, one.data(), nullptr);
    elements(type, memory, [&](hid_t to_type, void* to) { return H5Dread(id, to_type, memory.get(), stored.get(), H5P_DEFAULT, to); });
  }

  /// In the types that readers ask for.
  void elements(const Handle& type, const Handle& space, const Read& read) {
    const H5T_class_t kind = H5Tget_class(type.get());
    if (kind == H5T_FLOAT || kind == H5T_INTEGER) return read_as(Handle(H5Tcopy(H5T_NATIVE_DOUBLE)), space, read);
    if (kind == H5T_COMPOUND && H5Tget_member_index(type.get(), "r") >= 0) read_as(pair_of("r", "i"), space, read);
    if (kind == H5T_COMPOUND && H5Tget_member_index(type.get(), "real") >= 0) read_as(pair_of("real", "imag"), space, read);
    if (kind == H5T_VLEN && H5Tget_class(Handle(H5Tget_super(type.get())).get()) == H5T_REFERENCE)
      read_as(Handle(H5Tcopy(type.get())), space, read);
    if (kind == H5T_STRING || kind == H5T_REFERENCE) read_as(Handle(H5Tcopy(type.get())), space, read);
  }

  void read_as(const Handle& memory, const Handle& space, const Read& read) {
    const hssize_t count = H5Sget_simple_extent_npoints(space.get());
    const std::size_t size = H5Tget_size(memory.get());
    if (count <= 0 || size == 0) return;
    if (static_cast<double>(count) * static_cast<double>(size) > 64.0 * most_data) {  // of 4 MB stored, or one element
      enough_ = false;
      return;
    }
    const std::size_t bytes = static_cast<std::size_t>(count) * size;
    const std::unique_ptr<char[]> values(new (std::nothrow) char[bytes]());
    if (!values) {
      enough_ = false;  // HDF5 calls this: nothing may be thrown
      return;
    }
    note(read(memory.get(), values.get()));
    if (H5Tis_variable_str(memory.get()) > 0 || H5Tget_class(memory.get()) == H5T_VLEN)
      H5Dvlen_reclaim(memory.get(), space.get(), H5P_DEFAULT, values.get());
  }

  std::set<haddr_t> seen_;  ///< each object once
  std::size_t depth_ = 0;
  double left_ = most_data;
  bool enough_ = true;
};

}  // namespace

void poison_memory() {
  constexpr int no_pointer = 0x5a;
  ::mallopt(M_PERTURB, no_pointer);
  H5garbage_collect();
  H5set_free_list_limits(0, 0, 0, 0, 0, 0);
}

bool visit_all(const Handle& file) {
  if (!file.is_open()) return !lacks_memory();
  Visit visit;
  visit.object(file.get(), ".");
  for (const char* name : known) {  // where the list of names is damaged, one of them may be found all the same
    H5L_info_t link{};
    const bool there = H5Lexists(file.get(), name, H5P_DEFAULT) > 0 && H5Lget_info(file.get(), name, &link, H5P_DEFAULT) >= 0;
    if (there && link.type == H5L_TYPE_HARD) visit.object(file.get(), name);
  }
  return visit.enough();
}

}  // namespace jointid::frf::hdf5
