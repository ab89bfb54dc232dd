#include "frf/file/file_format.hpp"
#include "frf/set/corrections.hpp"

namespace jointid::frf {

std::unique_ptr<FrfSource> open(const std::filesystem::path& path, const OpenOptions& options) {
  auto source = format_of(path).open(path, options);
  return options.quantity ? reinterpreted(std::move(source), *options.quantity) : std::move(source);
}

}  // namespace jointid::frf
