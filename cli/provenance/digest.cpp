#include "cli/provenance/digest.hpp"

#include "base/module.hpp"

namespace jointid::cli {

std::optional<std::string> sha256_of(const std::filesystem::path& file) {
  constexpr Module digest{"digest", "SHA-256 of inputs", "libssl-dev"};
  return is_there(digest) ? interface_of<DigestModule>(digest).sha256(file) : std::nullopt;
}

}  // namespace jointid::cli
