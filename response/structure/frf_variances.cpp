#include "response/structure/frf_variances.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "frf/set/h1.hpp"

namespace jointid::response {
namespace {

bool knows_variance(const frf::FrfHeader& header) {
  return header.noise == frf::NoiseRecord::variance || (header.noise == frf::NoiseRecord::coherence && header.averages > 1.0);
}

std::vector<Complex> variances_of(frf::FrfSource& source, const frf::Block& block) {
  std::vector<Complex> variances(block.size());
  if (source.header().noise == frf::NoiseRecord::variance) {
    source.read_variance(block, variances);
    return variances;
  }
  std::vector<Complex> values(block.size());
  std::vector<double> coherence(block.size());
  source.read(block, values);
  source.read_coherence(block, coherence);
  for (std::size_t i = 0; i < values.size(); ++i) {
    variances[i] = frf::h1_part_variances(values[i], coherence[i], source.header().averages);
  }
  return variances;
}

}  // namespace

std::vector<Eigen::MatrixXcd> read_variances(frf::FrfSystem& system, const std::vector<frf::Dof>& rows,
                                             const std::vector<frf::Dof>& columns) {
  const std::vector<frf::BlockPiece> pieces = system.pieces(rows, columns);
  const auto known = [&](const frf::BlockPiece& piece) { return knows_variance(system.source(piece.source).header()); };
  if (!std::ranges::all_of(pieces, known)) return {};
  std::vector<Eigen::MatrixXcd> lines;
  for (std::size_t line = 0; line < system.frequency_hz().size(); ++line) {
    RowMatrixXc all = RowMatrixXc::Zero(at(rows.size()), at(columns.size()));
    std::vector<bool> taken(static_cast<std::size_t>(all.size()), false);
    for (const frf::BlockPiece& piece : pieces) {
      const std::size_t own = system.source_line(piece.source, line);
      const std::vector<Complex> variances =
          variances_of(system.source(piece.source), {std::span(&own, 1), piece.responses, piece.references});
      for (std::size_t r = 0; r < piece.responses.size(); ++r) {
        for (std::size_t c = 0; c < piece.references.size(); ++c) {
          const std::size_t place = piece.place(r, c, columns.size());
          if (!taken[place]) all(at(place)) = variances[r * piece.references.size() + c];
          taken[place] = true;
        }
      }
    }
    if (!all.allFinite()) return {};
    lines.emplace_back(all);
  }
  return lines;
}

}  // namespace jointid::response
