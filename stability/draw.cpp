#include "stability/draw.hpp"

#include <array>
#include <cmath>
#include <random>

namespace jointid::stability {
namespace {

class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t index, std::uint32_t purpose) {
    std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), static_cast<std::uint32_t>(index),
                           static_cast<std::uint32_t>(index >> 32), purpose};
    random_.seed(sequence);
  }

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double decades(double low, double high) { return std::pow(10.0, between(low, high)); }
  bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(random_) == 1; }
  template <class T, std::size_t n>
  T of(const std::array<T, n>& values) {
    return values[std::uniform_int_distribution<std::size_t>(0, n - 1)(random_)];
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace

ExtremeScene draw(std::uint64_t seed, std::uint64_t index) {
  using weighting::Weighting;
  Draw draw(seed, index, 0);
  ExtremeScene out;
  out.joint_stiffness = draw.decades(-6.0, 9.0);
  out.second_spring = draw.one_in(2) ? draw.decades(-12.0, 0.0) : draw.decades(-1.0, 1.0);
  out.joint_loss = draw.one_in(4) ? 0.0 : draw.decades(-8.0, 0.0);
  out.loss_factor = draw.of(std::array{0.0, 1e-8, 1e-4, 1e-2, 0.5});
  out.free_free = draw.one_in(3);
  out.gap = draw.one_in(4) ? draw.decades(-12.0, 0.0) : 1.0;
  out.lowest_hz = draw.one_in(3) ? draw.decades(-2.0, 1.0) : draw.between(10.0, 50.0);
  out.highest_hz = draw.between(60.0, 500.0);
  out.logarithmic = draw.one_in(2);
  out.lines = std::uint64_t{1} + static_cast<std::size_t>(draw.between(0.0, 8.0));
  out.on_resonance = draw.one_in(4);
  out.storage = draw.one_in(4) ? Storage::single_precision : Storage::double_precision;
  out.form = draw.one_in(3) ? Form::symmetric : Form::springs;
  out.method = draw.of(std::array{ident::Method::one, ident::Method::one, ident::Method::two, ident::Method::direct});
  out.weighting = draw.of(std::array{Weighting::none, Weighting::wa, Weighting::wb, Weighting::wbg, Weighting::wbs});
  out.seed = 1 + index;
  return out;
}

ident::Solver draw_solver(std::uint64_t seed, std::uint64_t index) {
  using enum ident::Solver;
  return Draw(seed, index, 1).of(std::array{qr, qr, spqr, normal});
}

}  // namespace jointid::stability
