#include "models/model_source.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "base/complex.hpp"
#include "base/eigen.hpp"

namespace jointid::models {
namespace {

std::vector<std::size_t> picked(const std::vector<std::size_t>& from, std::span<const std::size_t> places) {
  std::vector<std::size_t> out;
  for (const std::size_t place : places) out.push_back(from[place]);
  return out;
}

[[noreturn]] void fail_infinite(const frf::FrfHeader& header, double frequency_hz) {
  frf::fail(header, scene::number_text(frequency_hz) + " Hz", "the receptance of the model is infinite",
            frequency_hz == 0.0
                ? "a structure that is free to move has none at 0 Hz: leave it out by [frequency] range"
                : "an undamped resonance, or a coordinate without mass and stiffness: give damping, or leave the line out");
}

}  // namespace

ModelSource::ModelSource(NamedModel named, std::vector<double> frequency_hz) : named_(std::move(named)) {
  header_.file = named_.file;
  header_.frequency_hz = std::move(frequency_hz);
  header_.response = header_.reference = named_.coordinates.dofs;
  header_.noise = frf::NoiseRecord::variance;
  header_.averages = std::numeric_limits<double>::infinity();
  header_.nodes = named_.nodes;
  frf::validate(header_);
}

void ModelSource::do_read(const frf::Block& block, std::span<Complex> out) {
  const auto same = [](std::span<const std::size_t> a, const std::vector<std::size_t>& b) { return std::ranges::equal(a, b); };
  if (!same(block.lines, last_lines_) || !same(block.responses, last_responses_) || !same(block.references, last_references_)) {
    const std::vector<std::size_t> rows = picked(named_.coordinates.coordinates, block.responses),
                                   columns = picked(named_.coordinates.coordinates, block.references);
    last_lines_.clear();  // in case that a line throws
    announce(block, rows, columns);
    last_.resize(block.size());
    Complex* to = last_.data();
    for (const std::size_t line : block.lines) {
      const double frequency = header_.frequency_hz[line];
      const auto h = named_.model->receptance(angular(frequency), rows, columns);
      if (!h) fail_infinite(header_, frequency);
      Eigen::Map<RowMatrixXc>(to, h->rows(), h->cols()) = *h;
      to += h->size();
    }
    last_lines_.assign(block.lines.begin(), block.lines.end());
    last_responses_.assign(block.responses.begin(), block.responses.end());
    last_references_.assign(block.references.begin(), block.references.end());
  }
  std::ranges::copy(last_, out.begin());
}

void ModelSource::announce(const frf::Block& block, const std::vector<std::size_t>& rows, const std::vector<std::size_t>& columns) {
  std::vector<double> omega;
  for (const std::size_t line : block.lines) omega.push_back(angular(header_.frequency_hz[line]));
  const auto lowest = std::ranges::upper_bound(header_.frequency_hz, 0.0);
  if (lowest == header_.frequency_hz.end()) return;
  std::set<std::size_t> coordinates(rows.begin(), rows.end());
  coordinates.insert(columns.begin(), columns.end());
  const std::vector<std::size_t> all(coordinates.begin(), coordinates.end());
  named_.model->expect({omega, angular(*lowest), angular(header_.frequency_hz.back()), all});
}

void ModelSource::do_read_variance(const frf::Block& block, std::span<Complex> out) {
  if (named_.noise == 0.0) {
    std::ranges::fill(out, Complex(0.0));
    return;
  }
  do_read(block, out);
  for (Complex& value : out) {
    const double half = 0.5 * named_.noise * named_.noise * std::norm(value);
    value = {half, half};
  }
}

void ModelSource::do_read_coherence(const frf::Block&, std::span<double> out) {
  std::ranges::fill(out, std::numeric_limits<double>::quiet_NaN());
}

bool is_model(const frf::FrfHeader& header) { return std::isinf(header.averages); }

}  // namespace jointid::models
