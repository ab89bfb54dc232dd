#pragma once

#include <filesystem>
#include <string>

#include "frf/set/frf_set.hpp"

namespace jointid::problems {

/// A way to write FRF files; the name is also the extension of the files.
struct SetFormat {
  const char* name;
  void (*write)(const frf::FrfSet& set, const std::filesystem::path& path);
};

/// "h5" or "uff"; throws InputError (usage) for others.
const SetFormat& find_set_format(const std::string& name);

}  // namespace jointid::problems
