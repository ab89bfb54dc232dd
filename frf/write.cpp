#include "frf/write.hpp"

#include <algorithm>
#include <cctype>

#include "frf/csv_file.hpp"
#include "base/error.hpp"
#include "frf/hdf5_writer.hpp"
#include "frf/mat_file.hpp"
#include "frf/uff_file.hpp"

namespace jointid::frf {

void write(const FrfSet& set, const std::filesystem::path& path, std::string format) {
  if (format.empty()) format = path.extension().string();
  if (format.starts_with('.')) format.erase(0, 1);
  std::ranges::transform(format, format.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (format == "h5" || format == "hdf5") return write_hdf5(set, path);
  if (format == "uff" || format == "unv") return write_uff(set, path, {.quantity = set.header.quantity});
  if (format == "mat") return write_mat(set, path);
  if (format == "csv") return write_csv(set, path);
  throw InputError({.kind = ErrorKind::usage,
                    .file = path.string(),
                    .place = {},
                    .problem = format.empty() ? "has no extension that says the format"
                                              : "'" + format + "' is no format of FRF files",
                    .remedy = "name the file .h5, .uff, .mat or .csv"});
}

}  // namespace jointid::frf
