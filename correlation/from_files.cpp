#include "correlation/from_files.hpp"

#include "frf/file/open_as_one.hpp"

namespace jointid::correlation {

frf::FrfSet read_frfs(const std::filesystem::path& file) { return frf::load(*frf::open_as_one({file})); }

ModeFile read_modes(const std::filesystem::path& file) { return {file.string(), frf::read_uff55(file)}; }

ExpandedFrfs expanded_files(const std::filesystem::path& parent, const std::filesystem::path& measured, const std::string& way,
                            std::size_t modes) {
  const frf::FrfSet set = read_frfs(measured);
  if (way == "serep") return expanded(read_modes(parent), set, modes);
  return expanded(read_frfs(parent), set, way == "semm" ? Semm::basic : Semm::extended);
}

}  // namespace jointid::correlation
