#include "ident/variance/frf_error_sums.hpp"

#include <algorithm>

namespace jointid::ident {
namespace {

/// Its place among those that are there, at the end where it is new.
std::size_t place_in(std::vector<std::size_t>& all, std::size_t one) {
  const auto found = std::ranges::find(all, one);
  const auto place = static_cast<std::size_t>(found - all.begin());
  if (found == all.end()) all.push_back(one);
  return place;
}

}  // namespace

FrfErrorSums::FrfErrorSums(frf::FrfSystem& system, const std::vector<frf::Dof>& coordinates)
    : system_(system), size_(coordinates.size()), places_(size_ * size_) {
  for (const frf::BlockPiece& piece : system.pieces(coordinates, coordinates)) {
    if (system.source(piece.source).has_error_sums()) add(piece);
  }
}

/// The files' own FRFs come before those that stand in for their transposes.
void FrfErrorSums::add(const frf::BlockPiece& piece) {
  auto source = std::ranges::find(sources_, piece.source, &Source::source);
  if (source == sources_.end()) source = sources_.insert(sources_.end(), {.source = piece.source, .responses = {}, .references = {}});
  for (std::size_t r = 0; r < piece.responses.size(); ++r) {
    for (std::size_t c = 0; c < piece.references.size(); ++c) {
      Place& place = places_[piece.place(r, c, size_)];
      if (place.source != frf::npos) continue;
      place = {.source = static_cast<std::size_t>(source - sources_.begin()),
               .response = place_in(source->responses, piece.responses[r]),
               .reference = place_in(source->references, piece.references[c]),
               .sign = piece.response_sign[r] * piece.reference_sign[c]};
    }
  }
}

void FrfErrorSums::read(std::span<const std::size_t> lines) {
  for (Source& source : sources_) {
    std::vector<std::size_t> own;
    for (const std::size_t line : lines) own.push_back(system_.source_line(source.source, line));
    source.lines = system_.source(source.source).read_error_sums({own, source.responses, source.references});
  }
}

std::vector<frf::ErrorSums::Term> FrfErrorSums::terms(std::size_t i, std::size_t row, std::size_t column) const {
  const Place& place = places_[row * size_ + column];
  if (place.source == frf::npos) return {};
  std::size_t before = 0;  // errors of the files before it
  for (std::size_t s = 0; s < place.source; ++s) before += sources_[s].lines[i].errors;
  const Source& source = sources_[place.source];
  std::vector<frf::ErrorSums::Term> out = source.lines[i].terms[place.response * source.references.size() + place.reference];
  for (frf::ErrorSums::Term& term : out) term = {term.error + before, place.sign * term.factor, term.relation};
  return out;
}

}  // namespace jointid::ident
