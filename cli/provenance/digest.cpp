#include "cli/provenance/digest.hpp"

#include <fstream>
#include <sstream>

#include "base/module.hpp"

namespace jointid::cli {
namespace {

std::optional<std::string> sha256_of(std::istream& in) {
  constexpr Module digest{"digest", "SHA-256 of inputs", "libssl-dev"};
  return is_there(digest) ? interface_of<DigestModule>(digest).sha256(in) : std::nullopt;
}

}  // namespace

std::optional<std::string> sha256_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return sha256_of(in);
}

std::optional<std::string> sha256_of_text(const std::string& text) {
  std::istringstream in(text);
  return sha256_of(in);
}

}  // namespace jointid::cli
