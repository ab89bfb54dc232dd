// Scenes (TOML), of identifications and of couplings.
#include "ident/scene/scene.hpp"

#include "fuzz_input.hpp"
#include "ident/scene/couple_scene.hpp"
#include "ident/scene/read_scene.hpp"

using namespace jointid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // A value of toml++ and our copy of it take some hundred bytes; `a=0\n` has four.
  const fuzz::Allowance allowance{.base = std::size_t{1} << 20, .per_byte = 1024};
  fuzz::expect_answer({data, size}, allowance, [](const auto& path) { ident::read_scene(path); });
  fuzz::expect_answer({data, size}, allowance, [](const auto& path) { ident::read_couple_scene(path); });
  return 0;
}
