#include <hdf5.h>

#include "frf/hdf5_module/files.hpp"

namespace jointid::frf {
namespace {

class OwnHdf5 final : public Hdf5Module {
 public:
  bool has_format_attribute(const std::filesystem::path& path) override { return hdf5::has_format_attribute(path); }

  std::unique_ptr<FrfSource> open(const std::filesystem::path& path) override { return hdf5::open_source(path); }

  std::unique_ptr<LinesOutput> create(const TemporaryFile& file, const FrfHeader& header,
                                      const Hdf5WriteOptions& options) override {
    return hdf5::create_lines_file(file, header, options);
  }

  std::unique_ptr<TableInput> open_table(const std::filesystem::path& path) override { return hdf5::open_table(path); }

  std::unique_ptr<TableOutput> create_table(const TemporaryFile& file, const TableHeader& header, std::size_t rows) override {
    return hdf5::create_table(file, header, rows);
  }

  std::unique_ptr<MatFile> open_mat_v73(const std::filesystem::path& path) override { return hdf5::open_mat_v73(path); }
};

}  // namespace
}  // namespace jointid::frf

/// HDF5 prints a line at the end of the process where a damaged file left it something that it cannot close; files that were written are
/// closed long before.
extern "C" void* jointid_module() {
  [[maybe_unused]] static const herr_t set = H5dont_atexit();
  static jointid::frf::OwnHdf5 module;
  return static_cast<jointid::frf::Hdf5Module*>(&module);
}
