#pragma once

#include "base/temporary_file.hpp"
#include "frf/mat/mat_variable.hpp"

namespace jointid::frf {

/// What the module matio implements (base/module.hpp): MATLAB v5 to v7 files.
class MatioModule {
 public:
  virtual ~MatioModule() = default;
  virtual std::unique_ptr<MatFile> open(const std::filesystem::path& path) = 0;
  /// All but the renaming.
  virtual void write(const FrfSet& set, const TemporaryFile& file) = 0;
};

/// Whether it is there.
bool has_matio();

}  // namespace jointid::frf
