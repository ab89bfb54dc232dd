// Stands in for mat_v5.cpp and mat_write.cpp in a build without matio.
#include "base/error.hpp"
#include "frf/mat/mat_file.hpp"
#include "frf/mat/mat_variable.hpp"

namespace jointid::frf {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw InputError({.kind = ErrorKind::data,
                    .file = path.string(),
                    .place = {},
                    .problem = "MATLAB v5 to v7 files need matio, which this build lacks",
                    .remedy = "build with matio, save as -v7.3, or convert to HDF5 or UFF"});
}

}  // namespace

std::unique_ptr<MatFile> open_mat_variables_v5(const std::filesystem::path& path) { fail(path); }

void write_mat(const FrfSet&, const std::filesystem::path& path) { fail(path); }

}  // namespace jointid::frf
