#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "ident/identify.hpp"
#include "memory_systems.hpp"

namespace jointid::ident {

/// FRFs that are computed when they are read.
class Computed final : public frf::FrfSource {
 public:
  Computed(std::size_t lines, const Dofs& all, double seed) : seed_(seed) {
    for (std::size_t i = 1; i <= lines; ++i) header_.frequency_hz.push_back(0.1 * static_cast<double>(i));
    header_.response = header_.reference = all;
  }

 private:
  void do_read(const frf::Block& block, std::span<Complex> out) override {
    std::size_t next = 0;
    for (const std::size_t line : block.lines) {
      for (const std::size_t r : block.responses) {
        for (const std::size_t c : block.references) {
          const double phase = static_cast<double>(1 + 31 * r + 17 * c + line * (r + 2 * c + 1)) * seed_;
          out[next++] = {phase - std::floor(phase), 0.1};
        }
      }
    }
  }
  void do_read_variance(const frf::Block&, std::span<Complex>) override {}
  void do_read_coherence(const frf::Block&, std::span<double>) override {}

  double seed_;
};

inline std::unique_ptr<frf::FrfSystem> computed_system(const char* name, std::size_t lines, const Dofs& all, double seed) {
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  sources.push_back(std::make_unique<Computed>(lines, all, seed));
  return std::make_unique<frf::FrfSystem>(name, std::move(sources), frf::Composition::merged, false);
}

/// Lines of two such systems of 40×40 FRFs and a joint of three DOFs; 327 lines or so make a chunk.
inline std::unique_ptr<Plan> computed_plan(std::size_t lines) {
  Dofs all;
  for (int node = 1; node <= 40; ++node) all.push_back({.node = node, .direction = frf::Direction::x});
  Scene scene;
  scene.joints = {joint_of({all.begin(), all.begin() + 3}, restrictions::Kind::stiffness, restrictions::Pattern::full)};
  return make_plan(scene, computed_system("substructures", lines, all, 0.7),
                   computed_system("assembly", lines, all, 1.3));
}

}  // namespace jointid::ident
