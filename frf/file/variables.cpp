#include "frf/file/variables.hpp"

#include "frf/file/file_format.hpp"
#include "frf/npy/npy_file.hpp"

namespace jointid::frf {

std::unique_ptr<MatFile> open_variables(const std::filesystem::path& path) {
  switch (detect_array_format(path).value_or(FileFormat::csv)) {
    case FileFormat::matlab_v5:
      return open_mat_variables_v5(path);
    case FileFormat::matlab_v73:
    case FileFormat::jointid_hdf5:
      return open_mat_variables_v73(path);
    case FileFormat::npz:
      return open_npz_variables(path);
    case FileFormat::npy:
      return open_npy_variable(path);
    default:
      return nullptr;
  }
}

}  // namespace jointid::frf
