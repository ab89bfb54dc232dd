#include "base/error.hpp"
#include "frf/file/file_format.hpp"
#include "frf/set/corrections.hpp"

namespace jointid::frf {
namespace {

void require_applicable(const std::filesystem::path& path, const Format& format, const OpenOptions& options) {
  const auto refuse = [&](const char* option, const char* what, const char* remedy) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = path.string(),
                      .place = {},
                      .problem = std::string(option) + " is given, and " + format.name + " " + what,
                      .remedy = remedy});
  };
  const bool uff = format.format == FileFormat::uff, analyser = format.format == FileFormat::analyser_text;
  if (!options.variable.empty() && (uff || analyser || format.format == FileFormat::csv))
    refuse("variable (--variable)", "has no variables", "leave it out");
  if (!options.unit.empty() && !uff && !analyser)
    refuse("unit (--unit)", "has a place of its own for it", "write it there: # unit = g/lbf in CSV, a variable unit in MATLAB files, the attribute in HDF5");
}

}  // namespace

std::unique_ptr<FrfSource> open(const std::filesystem::path& path, const OpenOptions& options) {
  const Format& format = format_of(path);
  require_applicable(path, format, options);
  auto source = format.open(path, options);
  return options.quantity ? reinterpreted(std::move(source), *options.quantity) : std::move(source);
}

}  // namespace jointid::frf
