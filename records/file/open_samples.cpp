#include "records/file/open_samples.hpp"

#include "base/error.hpp"
#include "frf/file/file_format.hpp"
#include "frf/file/file_head.hpp"
#include "frf/uff/uff_file.hpp"
#include "records/file/npy_file.hpp"
#include "records/file/sample_streams.hpp"

namespace jointid::records {

std::unique_ptr<SampleStream> open_samples(const std::filesystem::path& path, const StreamOptions& options) {
  if (options.part >= options.parts)
    throw InputError({ErrorKind::usage, path.string(), "part", "is not one of " + std::to_string(options.parts), ""});
  const auto arrays = frf::detect_array_format(path);
  const bool whole = arrays == frf::FileFormat::matlab_v5 || arrays == frf::FileFormat::npz || arrays == frf::FileFormat::npy;
  if (whole) return open_column_samples(path, options);
  if (arrays) return open_hdf5_samples(path, options);
  const std::string head = frf::head_of(path);
  if (frf::looks_like_uff(head)) return open_uff_samples(path, options);
  return open_text_samples(path, options);
}

}  // namespace jointid::records
