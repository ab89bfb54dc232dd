#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>

#include "frf/hdf5_module/files.hpp"
#include "frf/hdf5_module/hdf5_create.hpp"
#include "frf/hdf5_module/hdf5_output.hpp"
#include "frf/hdf5_module/table_sum.hpp"

namespace jointid::frf {
namespace {

using hdf5::Handle;

constexpr std::size_t rows_per_chunk = 4096;

/// Without the time of creation: equal tables are equal files.
Handle creation_list() {
  Handle create(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_obj_track_times(create.get(), false);
  return create;
}

/// Texts of one length, padded with zeros: they lie in the dataset itself.
bool write_texts(const Handle& file, const char* name, const std::vector<std::string>& texts) {
  std::size_t length = 1;
  for (const std::string& text : texts) length = std::max(length, text.size());
  std::string packed;
  for (const std::string& text : texts) packed += text + std::string(length - text.size(), '\0');
  const Handle type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.get(), length);
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  const hsize_t count = texts.size();
  const Handle space(H5Screate_simple(1, &count, nullptr));
  const Handle set(H5Dcreate2(file.get(), name, type.get(), space.get(), H5P_DEFAULT, creation_list().get(), H5P_DEFAULT));
  return set.is_open() && H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()) >= 0;
}

bool write_numbers(const Handle& file, const char* name, const std::vector<double>& numbers) {
  const hsize_t count = numbers.size();
  const Handle space(H5Screate_simple(1, &count, nullptr));
  const Handle set(H5Dcreate2(file.get(), name, H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT, creation_list().get(),
                              H5P_DEFAULT));
  return set.is_open() && H5Dwrite(set.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) >= 0;
}

bool write_sums(const Handle& file, const std::vector<std::uint64_t>& sums) {
  const hsize_t count = sums.size();
  const Handle space(H5Screate_simple(1, &count, nullptr));
  const Handle set(H5Dcreate2(file.get(), hdf5::column_sums_name, H5T_STD_U64LE, space.get(), H5P_DEFAULT, creation_list().get(),
                              H5P_DEFAULT));
  return set.is_open() && H5Dwrite(set.get(), H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, sums.data()) >= 0;
}

Handle create_rows(const Handle& file, std::size_t rows, std::size_t columns) {
  const std::array<hsize_t, 2> dims = {rows, columns}, chunk = {std::min(rows, rows_per_chunk), 1};
  const Handle create = creation_list();
  H5Pset_chunk(create.get(), 2, chunk.data());
  H5Pset_fill_time(create.get(), H5D_FILL_TIME_NEVER);
  const Handle space(H5Screate_simple(2, dims.data(), nullptr));
  return Handle(H5Dcreate2(file.get(), "rows", H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT, create.get(), H5P_DEFAULT));
}

class Rows {
 public:
  Rows(const TemporaryFile& file, const TableHeader& header, std::size_t rows)
      : output_(file), columns_(header.columns.size()), total_(rows), sums_(columns_) {
    hdf5::limit_metadata(output_.file());
    output_.require(write_header(header));
    rows_ = create_rows(output_.file(), rows, columns_);
    output_.require(rows_.is_open());
  }

  /// Whole chunks reach HDF5, so that none is read back.
  void append(std::span<const double> rows) {
    waiting_.insert(waiting_.end(), rows.begin(), rows.end());
    const std::size_t chunk = rows_per_chunk * columns_;
    std::size_t taken = 0;
    for (; waiting_.size() - taken >= chunk; taken += chunk) put({waiting_.data() + taken, chunk});
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(taken));
  }

  void finish() {
    put(waiting_);
    assert(written_ == total_);
    std::vector<std::uint64_t> sums;
    for (const hdf5::ColumnSum& sum : sums_) sums.push_back(sum.value());
    output_.require(write_sums(output_.file(), sums));
    output_.finish(rows_.close());
  }

 private:
  bool write_header(const TableHeader& header) const {
    const Handle& file = output_.file();
    std::vector<std::string> names, units;
    std::vector<double> truths;
    for (const TableColumn& column : header.columns) {
      names.push_back(column.name);
      units.push_back(column.unit);
      truths.push_back(column.truth);
    }
    bool ok = hdf5::write_text_attribute(file, "format", "jointid-table") &&
              hdf5::write_integer_attribute(file, "version", 2) &&
              hdf5::write_text_attribute(file, hdf5::header_sum_name, hdf5::header_sum(header, total_));
    for (const auto& [name, text] : header.texts) ok = ok && hdf5::write_text_attribute(file, name.c_str(), text);
    return ok && write_texts(file, "column", names) && write_texts(file, "unit", units) &&
           write_numbers(file, "truth", truths);
  }

  void put(std::span<const double> rows) {
    if (rows.empty()) return;
    const std::array<hsize_t, 2> start = {written_, 0}, extent = {rows.size() / columns_, columns_};
    const Handle in_file(H5Dget_space(rows_.get()));
    const Handle in_memory(H5Screate_simple(2, extent.data(), nullptr));
    output_.require(
        H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr) >= 0 &&
        H5Dwrite(rows_.get(), H5T_NATIVE_DOUBLE, in_memory.get(), in_file.get(), H5P_DEFAULT, rows.data()) >= 0);
    written_ += extent[0];
    for (std::size_t i = 0; i < rows.size(); ++i) sums_[i % columns_].add(rows[i]);
  }

  hdf5::Output output_;
  std::size_t columns_, total_, written_ = 0;
  std::vector<double> waiting_;
  std::vector<hdf5::ColumnSum> sums_;
  Handle rows_;
};

class RowsFile final : public TableOutput {
 public:
  RowsFile(const TemporaryFile& file, const TableHeader& header, std::size_t rows) {
    const hdf5::Silence silence;
    rows_.emplace(file, header, rows);
  }

  ~RowsFile() override {
    const hdf5::Silence silence;
    rows_.reset();
  }

  void append(std::span<const double> rows) override {
    const hdf5::Silence silence;
    rows_->append(rows);
  }

  void finish() override {
    const hdf5::Silence silence;
    rows_->finish();
  }

 private:
  std::optional<Rows> rows_;
};

}  // namespace

std::unique_ptr<TableOutput> hdf5::create_table(const TemporaryFile& file, const TableHeader& header, std::size_t rows) {
  return std::make_unique<RowsFile>(file, header, rows);
}

}  // namespace jointid::frf
