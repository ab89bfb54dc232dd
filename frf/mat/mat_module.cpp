#include "frf/mat/mat_module.hpp"

#include "base/error.hpp"
#include "base/module.hpp"
#include "frf/hdf5/hdf5_module.hpp"
#include "frf/mat/mat_file.hpp"

namespace jointid::frf {
namespace {

constexpr Module matio{"matio", "a MATLAB v5 to v7 file", "libmatio-dev"};

MatioModule& matio_for(const std::filesystem::path& path) {
  if (has_matio()) return interface_of<MatioModule>(matio);
  throw InputError({.kind = ErrorKind::data,
                    .file = path.string(),
                    .place = {},
                    .problem = "MATLAB v5 to v7 files need matio, which this build lacks",
                    .remedy = "build with matio, save as -v7.3, or convert to HDF5 or UFF"});
}

}  // namespace

MatioModule& matio_module(const std::string& file) {
  if (has_matio()) return interface_of<MatioModule>(matio);
  throw InputError({.kind = ErrorKind::data,
                    .file = file,
                    .place = {},
                    .problem = "arrays that are packed need zlib, which comes with matio, and this build lacks it",
                    .remedy = "build with matio, or save with numpy.savez() in place of savez_compressed()"});
}

bool has_matio() { return is_there(matio); }

std::unique_ptr<MatFile> open_mat_variables_v5(const std::filesystem::path& path) { return matio_for(path).open(path); }

std::unique_ptr<MatFile> open_mat_variables_v73(const std::filesystem::path& path) { return hdf5_module().open_mat_v73(path); }

void write_mat(const FrfSet& set, const std::filesystem::path& path) {
  validate(set.header);
  MatioModule& module = matio_for(path);
  TemporaryFile temporary(path);
  module.write(set, temporary);
  temporary.commit();
}

}  // namespace jointid::frf
