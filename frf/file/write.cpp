#include "frf/file/write.hpp"

#include <algorithm>
#include <cctype>

#include "base/error.hpp"
#include "frf/file/file_format.hpp"

namespace jointid::frf {

void write(const FrfSet& set, const std::filesystem::path& path, std::string format) {
  if (format.empty()) format = path.extension().string();
  if (format.starts_with('.')) format.erase(0, 1);
  std::ranges::transform(format, format.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Format& each : formats()) {
    if (std::ranges::find(each.extensions, format) != each.extensions.end()) return each.write(set, path);
  }
  throw InputError(
      {.kind = ErrorKind::usage,
       .file = path.string(),
       .place = {},
       .problem = format.empty() ? "has no extension of a format" : "'" + format + "' is no format of FRF files",
       .remedy = "name the file .h5, .uff, .mat or .csv"});
}

}  // namespace jointid::frf
