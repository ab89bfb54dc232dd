#include "frf/mat/mat_module.hpp"

#include <fstream>
#include <string>

#include "base/error.hpp"
#include "base/module.hpp"
#include "frf/hdf5/hdf5_module.hpp"
#include "frf/mat/mat_file.hpp"
#include "frf/mat/mat_v4.hpp"

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

std::unique_ptr<MatFile> open_mat_variables_v5(const std::filesystem::path& path) {
  constexpr std::size_t longest_header = 512;
  std::string head(longest_header, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return looks_like_mat_v4(head) ? open_mat_variables_v4(path) : matio_for(path).open(path);
}

std::unique_ptr<MatFile> open_mat_variables_v73(const std::filesystem::path& path) { return hdf5_module().open_mat_v73(path); }

void write_mat(const FrfSet& set, const std::filesystem::path& path) {
  validate(set.header);
  MatioModule& module = matio_for(path);
  TemporaryFile temporary(path);
  module.write(set, temporary);
  temporary.commit();
}

}  // namespace jointid::frf
