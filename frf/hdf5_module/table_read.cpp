#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "frf/hdf5_module/files.hpp"
#include "frf/hdf5_module/hdf5_object.hpp"
#include "frf/hdf5_module/table_sum.hpp"

namespace jointid::frf {
namespace {

using hdf5::Handle;

/// Root attributes that are text, but for the format.
std::map<std::string, std::string> root_texts(const hdf5::Object& file) {
  std::map<std::string, std::string> texts;
  const auto visit = [](hid_t, const char* name, const H5A_info_t*, void* to) -> herr_t {
    static_cast<std::vector<std::string>*>(to)->emplace_back(name);
    return 0;
  };
  std::vector<std::string> names;
  H5Aiterate2(file.id.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, visit, &names);
  for (const std::string& name : names) {
    if (name == "format" || name == "version" || name == hdf5::header_sum_name) continue;
    if (const auto text = hdf5::text_attribute(file, name.c_str())) texts[name] = *text;
  }
  return texts;
}

class Table final : public TableInput {
 public:
  explicit Table(const std::filesystem::path& path) : file_(hdf5::open_file(path)) {
    if (hdf5::text_attribute(file_, "format") != "jointid-table") {
      hdf5::fail(file_, "is no table of trials", "give the file that `jointid study` wrote");
    }
    hdf5::limit_metadata(file_.id);
    header_.texts = root_texts(file_);
    const auto names = hdf5::read_texts(hdf5::open_dataset(file_, "column"));
    const auto units = hdf5::read_texts(hdf5::open_dataset(file_, "unit"));
    const auto truths = hdf5::read_doubles(hdf5::open_dataset(file_, "truth"));
    rows_ = hdf5::open_dataset(file_, "rows");
    const bool fits = units.size() == names.size() && truths.size() == names.size() && rows_.dims.size() == 2 &&
                      rows_.dims[1] == names.size() && hdf5::is_real(rows_);
    if (!fits) hdf5::fail(file_, "its columns do not fit its rows");
    for (std::size_t i = 0; i < names.size(); ++i) header_.columns.push_back({names[i], units[i], truths[i]});
    if (hdf5::number_attribute(file_, "version").value_or(1.0) != 1.0 || hdf5::has(file_, hdf5::column_sums_name)) read_sums();
  }

  const TableHeader& header() const override { return header_; }
  std::size_t rows() const override { return rows_.dims[0]; }

  void read(std::size_t column, std::size_t first, std::span<double> out) const override {
    const hdf5::Silence silence;
    assert(column < header_.columns.size() && first + out.size() <= rows());
    if (!sums_.empty() && !checked_[column]) check(column);
    load(column, first, out);
  }

 private:
  /// Version 1 has none.
  void read_sums() {
    if (hdf5::text_attribute(file_, hdf5::header_sum_name) != hdf5::header_sum(header_, rows())) damaged("its texts or columns");
    const hdf5::Dataset stored = hdf5::open_dataset(file_, hdf5::column_sums_name);
    if (stored.dims != std::vector{header_.columns.size()}) damaged("its checksums");
    sums_.resize(header_.columns.size());
    checked_.assign(sums_.size(), false);
    if (H5Dread(stored.id.get(), H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, sums_.data()) < 0) damaged("its checksums");
  }

  /// The whole column, once.
  void check(std::size_t column) const {
    constexpr std::size_t most = 4096;
    std::vector<double> numbers(std::min(most, rows()));
    hdf5::ColumnSum sum;
    for (std::size_t first = 0; first < rows(); first += most) {
      numbers.resize(std::min(most, rows() - first));
      load(column, first, numbers);
      for (const double number : numbers) sum.add(number);
    }
    if (sum.value() != sums_[column]) damaged("column " + header_.columns[column].name);
    checked_[column] = true;
  }

  [[noreturn]] void damaged(const std::string& what) const {
    hdf5::fail(file_, "is damaged: the checksum of " + what + " does not agree", "remove it and repeat the run that wrote it");
  }

  void load(std::size_t column, std::size_t first, std::span<double> out) const {
    if (out.empty()) return;
    const std::array<hsize_t, 2> start = {first, column}, extent = {out.size(), 1};
    const Handle in_file(H5Dget_space(rows_.id.get()));
    const Handle in_memory(H5Screate_simple(2, extent.data(), nullptr));
    const bool ok =
        H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr) >= 0 &&
        H5Dread(rows_.id.get(), H5T_NATIVE_DOUBLE, in_memory.get(), in_file.get(), H5P_DEFAULT, out.data()) >= 0;
    if (!ok) hdf5::fail(rows_, "cannot be read: " + hdf5::last_failure());
  }

  hdf5::Object file_;
  hdf5::Dataset rows_;
  TableHeader header_;
  std::vector<std::uint64_t> sums_;    ///< of the columns; none in version 1
  mutable std::vector<bool> checked_;  ///< which columns agreed with theirs
};

}  // namespace

std::unique_ptr<TableInput> hdf5::open_table(const std::filesystem::path& path) {
  const Silence silence;
  return std::make_unique<Table>(path);
}

}  // namespace jointid::frf
