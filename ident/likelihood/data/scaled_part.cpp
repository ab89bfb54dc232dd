#include "ident/likelihood/data/scaled_part.hpp"

#include <cmath>
#include <numeric>

#include "base/eigen.hpp"

namespace jointid::ident {
namespace {

constexpr double beside = 1e-6;  ///< of the frequency: truncation and rounding are both far below what a derivative needs
constexpr std::size_t prepared_lines = 16;

}  // namespace

ScaledPart::ScaledPart(const DataFile& file, const std::vector<frf::Dof>& coordinates, Range expected)
    : frfs_(file), coordinates_(coordinates) {
  std::vector<double> lines;
  for (std::size_t i = 0; i < prepared_lines; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(prepared_lines - 1);
    lines.push_back(expected.low_hz + share * (expected.high_hz - expected.low_hz));
  }
  if (expected.high_hz > expected.low_hz) read(lines);
}

std::vector<Complex> ScaledPart::read(const std::vector<double>& frequency_hz) const {
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  sources.push_back(frfs_.at(frequency_hz));
  frf::FrfSystem system("substructures", std::move(sources), frf::Composition::uncoupled, true);
  frf::BlockReader reader(system, coordinates_, coordinates_);
  std::vector<std::size_t> lines(frequency_hz.size());
  std::iota(lines.begin(), lines.end(), std::size_t{0});
  std::vector<Complex> out(lines.size() * coordinates_.size() * coordinates_.size());
  reader.read(lines, out);
  return out;
}

ScaledPart::Values ScaledPart::at(double frequency_hz, double stiffness, double mass) {
  const double scale = std::exp(-stiffness), moved = frequency_hz * std::exp(0.5 * (mass - stiffness));
  const Eigen::Index n = jointid::at(coordinates_.size());
  const bool is_static = moved == 0.0;
  std::vector<Complex> read_there;
  {
    const std::lock_guard lock(one_at_a_time_);
    read_there = is_static ? read({0.0}) : read({moved * (1.0 - beside), moved, moved * (1.0 + beside)});
  }
  const auto block = [&](Eigen::Index line) { return Eigen::Map<const RowMatrixXc>(read_there.data() + line * n * n, n, n); };
  Values out{scale * block(is_static ? 0 : 1), {}, Eigen::MatrixXcd::Zero(n, n)};
  if (!is_static) out.by_mass = (block(2) - block(0)) * (0.5 * scale / (2.0 * beside));
  out.by_stiffness = -out.h - out.by_mass;
  return out;
}

}  // namespace jointid::ident
