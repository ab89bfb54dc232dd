#include "frf/mat_module/files.hpp"

namespace jointid::frf {
namespace {

class OwnMatio final : public MatioModule {
 public:
  std::unique_ptr<MatFile> open(const std::filesystem::path& path) override { return mat::open_file(path); }
  void write(const FrfSet& set, const TemporaryFile& file) override { mat::write_file(set, file); }
  std::size_t inflate(std::string_view packed, std::span<char> out) override { return mat::inflate_raw(packed, out); }
};

}  // namespace
}  // namespace jointid::frf

extern "C" void* jointid_module() {
  static jointid::frf::OwnMatio module;
  return static_cast<jointid::frf::MatioModule*>(&module);
}
