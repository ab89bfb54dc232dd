#include <openssl/evp.h>

#include <array>
#include <memory>
#include <vector>

#include "cli/provenance/digest.hpp"

namespace jointid::cli {
namespace {

constexpr std::size_t bytes_at_once = std::size_t{1} << 20;

std::string hexadecimal(const unsigned char* bytes, unsigned count) {
  constexpr const char* digits = "0123456789abcdef";
  std::string out;
  for (unsigned i = 0; i < count; ++i) {
    out += digits[bytes[i] / 16];
    out += digits[bytes[i] % 16];
  }
  return out;
}

class OpenSslDigest final : public DigestModule {
 public:
  std::optional<std::string> sha256(std::istream& in) override {
    const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
    if (!in || !context || EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1) return std::nullopt;
    std::vector<char> piece(bytes_at_once);
    while (in) {
      in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
      if (EVP_DigestUpdate(context.get(), piece.data(), static_cast<std::size_t>(in.gcount())) != 1) return std::nullopt;
    }
    std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
    unsigned length = 0;
    if (!in.eof() || EVP_DigestFinal_ex(context.get(), sum.data(), &length) != 1) return std::nullopt;
    return hexadecimal(sum.data(), length);
  }
};

}  // namespace
}  // namespace jointid::cli

extern "C" void* jointid_module() {
  static jointid::cli::OpenSslDigest module;
  return static_cast<jointid::cli::DigestModule*>(&module);
}
