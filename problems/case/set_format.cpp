#include "problems/case/set_format.hpp"

#include <array>
#include <vector>

#include "base/error.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "frf/uff/uff_file.hpp"

namespace jointid::problems {
namespace {

void write_as_hdf5(const frf::FrfSet& set, const std::filesystem::path& path) { frf::write_hdf5(set, path); }

void write_as_uff(const frf::FrfSet& set, const std::filesystem::path& path) {
  frf::write_uff(set, path, {.binary = true, .quantity = set.header.quantity});
}

constexpr std::array<SetFormat, 2> formats = {{{"h5", write_as_hdf5}, {"uff", write_as_uff}}};

}  // namespace

const SetFormat& find_set_format(const std::string& name) {
  std::vector<std::string> names;
  for (const SetFormat& format : formats) {
    if (format.name == name) return format;
    names.emplace_back(format.name);
  }
  const std::string near = nearest_word(name, names);
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "problem format",
                    .problem = "'" + name + "' is not a format that problems are written in",
                    .remedy = near.empty() ? "use h5 or uff" : "did you mean " + near + "?"});
}

}  // namespace jointid::problems
