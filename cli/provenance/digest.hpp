#pragma once

#include <filesystem>
#include <istream>
#include <optional>
#include <string>

namespace jointid::cli {

/// SHA-256 of a file (FIPS 180-4), 64 hexadecimal digits. None where the file cannot be read or this build lacks OpenSSL.
std::optional<std::string> sha256_of(const std::filesystem::path& file);

/// The same of a text.
std::optional<std::string> sha256_of_text(const std::string& text);

/// What module `digest` implements (base/module.hpp).
class DigestModule {
 public:
  virtual ~DigestModule() = default;
  virtual std::optional<std::string> sha256(std::istream& in) = 0;
};

}  // namespace jointid::cli
