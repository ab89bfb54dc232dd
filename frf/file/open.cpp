#include <algorithm>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/file/file_format.hpp"
#include "frf/file/memory_file.hpp"
#include "frf/file/one_sided.hpp"
#include "frf/set/corrections.hpp"
#include "frf/set/unit_label.hpp"

namespace jointid::frf {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, std::string problem, std::string remedy) {
  throw InputError(
      {.kind = ErrorKind::usage, .file = path.string(), .place = {}, .problem = std::move(problem), .remedy = std::move(remedy)});
}

/// What the user says and the format has no place for is not left out silently.
void require_variables(const Format& format, const std::filesystem::path& path, const OpenOptions& options) {
  if (format.variables || (options.variable.empty() && options.frequency_variable.empty())) return;
  const bool frf = !options.variable.empty();
  const std::string option = frf ? "--variable, in a scene variable" : "--frequency-variable, in a scene frequency_variable";
  refuse(path,
         "the variable '" + (frf ? options.variable : options.frequency_variable) + "' is named, and a file of format " +
             format.name + " has none",
         "leave out " + option);
}

void require_own_unit(const Format& format, const std::filesystem::path& path, const OpenOptions& options) {
  if (options.unit.empty() || format.takes_unit) return;
  refuse(path, "the unit '" + options.unit + "' is given, and a file of format " + format.name + " has a place of its own for it",
         "write it there (a variable unit in MATLAB and numpy files, an attribute in HDF5) and leave out "
         "--unit, in a scene unit");
}

void require_own_axis(const Format& format, const std::filesystem::path& path, const OpenOptions& options) {
  if (options.frequency_unit.empty()) return;
  hertz_per(options.frequency_unit);
  if (!format.states_hertz) return;
  refuse(path,
         "the unit '" + options.frequency_unit + "' of the frequencies is given, and a file of format " + format.name + " has Hz",
         "leave out --frequency-unit, in a scene frequency_unit; a scene can stretch frequencies (frequency_scale)");
}

/// DOFs that a reader had no use for, since the file names its own.
void require_given_dofs(const FrfHeader& header, const std::filesystem::path& path, const OpenOptions& options) {
  const auto require = [&](const std::vector<Dof>& given, const std::vector<Dof>& own, const char* which, const char* option) {
    if (given.empty() || given == own) return;
    constexpr std::size_t most = 6;
    const std::vector<Dof> some(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(std::min(most, own.size())));
    refuse(path,
           std::string("names its ") + which + " itself, " + comma_list(names(some)) + (own.size() > most ? " …" : "") +
               ", and others are given",
           std::string("leave out ") + option + "; a scene can rename DOFs ([data.files], rename)");
  };
  require(options.response, header.response, "responses", "--response, in a scene dofs");
  require(options.reference, header.reference, "references", "--reference, in a scene reference_dofs");
}

/// Arrays say themselves what a file may leave open; only another quantity can be given.
std::unique_ptr<FrfSource> as_given(std::unique_ptr<FrfSource> arrays, const std::filesystem::path& path,
                                    const OpenOptions& options) {
  require_given_dofs(arrays->header(), path, options);
  const bool other = !options.unit.empty() || !options.variable.empty() || !options.frequency_variable.empty();
  if (other) refuse(path, "a unit or a variable is given for FRFs in memory", "leave it out, and give arrays in SI units");
  return options.quantity ? reinterpreted(std::move(arrays), *options.quantity) : std::move(arrays);
}

}  // namespace

std::unique_ptr<FrfSource> open(const std::filesystem::path& path, const OpenOptions& options) {
  if (auto arrays = open_memory_file(path)) return as_given(std::move(arrays), path, options);
  const Format& format = format_of(path);
  require_variables(format, path, options);
  require_own_unit(format, path, options);
  require_own_axis(format, path, options);
  auto source = format.open(path, options);
  require_one_sided(*source);
  if (!format.variables) require_given_dofs(source->header(), path, options);
  return options.quantity ? reinterpreted(std::move(source), *options.quantity) : std::move(source);
}

}  // namespace jointid::frf
