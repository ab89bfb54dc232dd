#include "ident/variance/mirror_difference.hpp"

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "ident/variance/noise_fit.hpp"

namespace jointid::ident {
namespace {

using frf::npos;

constexpr std::size_t most_lines = 512, least_lines = 4;
constexpr double single_precision = 4e-7;

/// Where the transpose of the FRF (response, reference) stands in the file, and the sign between them.
struct Mirror {
  std::size_t response = npos, reference = npos;
  double sign = 1.0;
  bool exists() const { return response != npos && reference != npos; }
};

Mirror mirror_of(const frf::FrfHeader& header, std::size_t response, std::size_t reference) {
  const frf::Dof &row = header.response[response], &column = header.reference[reference];
  Mirror mirror{frf::find_coordinate(header.response, column), frf::find_coordinate(header.reference, row)};
  if (!mirror.exists()) return mirror;
  if (mirror.response == response && mirror.reference == reference) return {};
  mirror.sign = row.sign * column.sign * header.response[mirror.response].sign * header.reference[mirror.reference].sign;
  return mirror;
}

class Pair {
 public:
  void add(Complex one, Complex two, double squared_factor) {
    const double square = std::norm(one - two) / squared_factor;
    const double sum = (std::norm(one) + std::norm(two)) / squared_factor;
    if (!std::isfinite(square) || !std::isfinite(sum)) return;
    samples_.push_back({.square = square, .proportional = sum, .constant = 2.0, .freedom = 1.0});
    if (square <= single_precision * single_precision * sum) ++copies_;
  }
  std::optional<frf::VarianceLaw> law() const {
    if (samples_.size() < least_lines || 2 * copies_ >= samples_.size()) return std::nullopt;
    return fit_noise(samples_);
  }

 private:
  std::vector<SquaredError> samples_;
  std::size_t copies_ = 0;
};

}  // namespace

std::vector<std::optional<frf::VarianceLaw>> mirror_laws(frf::FrfSource& source, const frf::BlockPiece& piece,
                                                         std::span<const std::size_t> lines) {
  const frf::FrfHeader& header = source.header();
  std::vector<std::optional<frf::VarianceLaw>> laws(piece.size());
  std::vector<Mirror> mirrors;
  std::vector<std::size_t> responses = piece.responses, references = piece.references;
  for (const std::size_t response : piece.responses) {
    for (const std::size_t reference : piece.references) {
      mirrors.push_back(mirror_of(header, response, reference));
      if (!mirrors.back().exists()) continue;
      responses.push_back(mirrors.back().response);
      references.push_back(mirrors.back().reference);
    }
  }
  if (std::none_of(mirrors.begin(), mirrors.end(), [](const Mirror& mirror) { return mirror.exists(); })) return laws;
  for (auto* indices : {&responses, &references}) {
    std::sort(indices->begin(), indices->end());
    indices->erase(std::unique(indices->begin(), indices->end()), indices->end());
  }
  const auto at = [](const std::vector<std::size_t>& all, std::size_t index) {
    return static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), index) - all.begin());
  };
  std::vector<Pair> pairs(piece.size());
  std::vector<Complex> values(responses.size() * references.size());
  const std::size_t step = (lines.size() + most_lines - 1) / most_lines;
  for (std::size_t i = 0; i < lines.size(); i += step) {
    source.read({lines.subspan(i, 1), responses, references}, values);
    const double factor = frf::squared_factor(header.quantity, header.frequency_hz[lines[i]]);
    const auto value = [&](std::size_t response, std::size_t reference) {
      return values[at(responses, response) * references.size() + at(references, reference)];
    };
    for (std::size_t entry = 0; entry < mirrors.size(); ++entry) {
      const Mirror& mirror = mirrors[entry];
      if (!mirror.exists()) continue;
      const std::size_t width = piece.references.size();
      pairs[entry].add(value(piece.responses[entry / width], piece.references[entry % width]),
                       mirror.sign * value(mirror.response, mirror.reference), factor);
    }
  }
  for (std::size_t entry = 0; entry < laws.size(); ++entry) laws[entry] = pairs[entry].law();
  return laws;
}

}  // namespace jointid::ident
