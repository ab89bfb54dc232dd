#include "base/error.hpp"
#include "frf/file/file_format.hpp"
#include "frf/set/corrections.hpp"

namespace jointid::frf {
namespace {

/// Of formats that have a place of their own for it, it is told there.
void require_unit_applies(const Format& format, const std::filesystem::path& path, const OpenOptions& options) {
  if (options.unit.empty() || format.format == FileFormat::uff || format.format == FileFormat::analyser_text) return;
  throw InputError({.kind = ErrorKind::usage,
                    .file = path.string(),
                    .place = {},
                    .problem = "the unit '" + options.unit + "' is given, and a file of format " + format.name +
                               " has a place of its own for it",
                    .remedy = "write it there (# unit = g/lbf in CSV, a variable unit in MATLAB files, an attribute in HDF5) and "
                              "leave out --unit, in a "
                              "scene unit"});
}

}  // namespace

std::unique_ptr<FrfSource> open(const std::filesystem::path& path, const OpenOptions& options) {
  const Format& format = format_of(path);
  require_unit_applies(format, path, options);
  auto source = format.open(path, options);
  return options.quantity ? reinterpreted(std::move(source), *options.quantity) : std::move(source);
}

}  // namespace jointid::frf
