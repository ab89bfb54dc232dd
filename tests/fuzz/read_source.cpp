#include "read_source.hpp"

#include <algorithm>
#include <numeric>

namespace jointid::fuzz {
namespace {

constexpr std::size_t most_dofs = 32, most_lines = 256;

std::vector<std::size_t> first(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

}  // namespace

void read_lines(frf::FrfSource& source) {
  const frf::FrfHeader& header = source.header();
  const auto responses = first(std::min(header.response.size(), most_dofs));
  const auto references = first(std::min(header.reference.size(), most_dofs));
  std::vector<Complex> values(responses.size() * references.size());
  std::vector<double> coherences(values.size());
  std::vector<Complex> covariances;
  for (std::size_t line = 0; line < std::min(header.lines(), most_lines); ++line) {
    const frf::Block block{std::span(&line, 1), responses, references};
    source.read(block, values);
    if (header.noise == frf::NoiseRecord::variance) source.read_variance(block, values);
    if (source.has_covariance()) {
      covariances.resize(values.size() * responses.size());
      source.read_covariance(block, covariances);
    }
    if (header.noise == frf::NoiseRecord::coherence) source.read_coherence(block, coherences);
  }
}

frf::OpenOptions two_responses() {
  return {.quantity = frf::Quantity::accelerance,
          .response = {frf::Dof::parse("1:+Y"), frf::Dof::parse("2:+Y")},
          .reference = {frf::Dof::parse("1:+Y")},
          .variable = {}};
}

}  // namespace jointid::fuzz
