#include "frf/analyser_file.hpp"
#include "frf/corrections.hpp"
#include "frf/csv_file.hpp"
#include "frf/file_format.hpp"
#include "frf/frf_source.hpp"
#include "frf/hdf5_file.hpp"
#include "frf/mat_file.hpp"
#include "frf/uff_file.hpp"

namespace jointid::frf {
namespace {

std::unique_ptr<FrfSource> open_by_content(const std::filesystem::path& path, const OpenOptions& options) {
  switch (detect_format(path)) {
    case FileFormat::jointid_hdf5:
      return open_hdf5(path);
    case FileFormat::uff:
      return open_uff(path, options);
    case FileFormat::matlab_v5:
      return open_mat_v5(path, options);
    case FileFormat::matlab_v73:
      return open_mat_v73(path, options);
    case FileFormat::analyser_text:
      return open_analyser_text(path, options);
    case FileFormat::csv:
      break;
  }
  return open_csv(path, options);
}

}  // namespace

std::unique_ptr<FrfSource> open(const std::filesystem::path& path, const OpenOptions& options) {
  auto source = open_by_content(path, options);
  return options.quantity ? reinterpreted(std::move(source), *options.quantity) : std::move(source);
}

}  // namespace jointid::frf
