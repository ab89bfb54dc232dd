#pragma once

#include <span>
#include <string>
#include <string_view>

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
  /// Unpacks raw deflate (zlib, which matio needs, too) until `out` is full or the data end; how many bytes it made. Throws
  /// InputError of the problem alone where the data are no such.
  virtual std::size_t inflate(std::string_view packed, std::span<char> out) = 0;
};

/// Loads it; throws InputError about `file` where it is missing.
MatioModule& matio_module(const std::string& file);

/// Whether it is there.
bool has_matio();

}  // namespace jointid::frf
