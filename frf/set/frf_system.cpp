#include "frf/set/frf_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace jointid::frf {
namespace {

double spacing_at(const std::vector<double>& axis, std::size_t i) {
  double spacing = std::numeric_limits<double>::infinity();
  if (i > 0) spacing = axis[i] - axis[i - 1];
  if (i + 1 < axis.size()) spacing = std::min(spacing, axis[i + 1] - axis[i]);
  return std::isfinite(spacing) ? spacing : axis[i] * 1e-6;
}

/// The line of `axis` that is the same as `frequency` (spacing `other` on its own axis), or npos.
std::size_t same_line(const std::vector<double>& axis, double frequency, double other) {
  const auto after = std::lower_bound(axis.begin(), axis.end(), frequency);
  std::size_t nearest = static_cast<std::size_t>(after - axis.begin());
  if (nearest == axis.size() || (nearest > 0 && frequency - axis[nearest - 1] < axis[nearest] - frequency)) --nearest;
  const double tolerance = axis_tolerance * std::min(spacing_at(axis, nearest), other);
  return std::abs(axis[nearest] - frequency) <= tolerance ? nearest : npos;
}

void add_coordinates(std::vector<Dof>& to, const std::vector<Dof>& dofs) {
  for (const Dof& dof : dofs) {
    if (!has(to, dof)) to.push_back(dof);
  }
}

}  // namespace

std::string range_text(const std::vector<double>& axis) {
  return fmt::format("{} to {} Hz in {} line{}", axis.front(), axis.back(), axis.size(), axis.size() == 1 ? "" : "s");
}

std::vector<std::size_t> match_lines(const std::vector<double>& axis, const std::vector<double>& other) {
  std::vector<std::size_t> partner(axis.size());
  for (std::size_t line = 0; line < axis.size(); ++line) {
    partner[line] = same_line(other, axis[line], spacing_at(axis, line));
  }
  return partner;
}

FrfSystem::FrfSystem(std::string name, std::vector<std::unique_ptr<FrfSource>> sources, Composition composition,
                     bool use_reciprocity)
    : name_(std::move(name)),
      sources_(std::move(sources)),
      composition_(composition),
      use_reciprocity_(use_reciprocity) {
  for (auto& source : sources_) {
    if (source->in_memory()) continue;
    auto kept = std::make_unique<KeptSource>(std::move(source));
    files_.push_back(kept.get());
    source = std::move(kept);
  }
  require_disjoint();
  align_axes();
  collect_coordinates();
}

void FrfSystem::align_axes() {
  source_lines_.resize(sources_.size());
  const std::vector<double>& axis = sources_.front()->header().frequency_hz;
  std::vector<std::vector<std::size_t>> partners;
  for (const auto& source : sources_) partners.push_back(match_lines(axis, source->header().frequency_hz));
  for (std::size_t line = 0; line < axis.size(); ++line) {
    const bool everywhere = std::all_of(partners.begin(), partners.end(),
                                        [&](const auto& partner) { return partner[line] != npos; });
    if (!everywhere) {
      ++lines_without_partner_;
      continue;
    }
    frequency_hz_.push_back(axis[line]);
    for (std::size_t s = 0; s < sources_.size(); ++s) source_lines_[s].push_back(partners[s][line]);
  }
  if (frequency_hz_.empty()) {
    throw InputError({.kind = ErrorKind::data,
                      .file = sources_.front()->header().file,
                      .place = name_,
                      .problem = "no frequency line is common to all files: here " + range_text(axis) + ", in " +
                                 sources_.back()->header().file + " " +
                                 range_text(sources_.back()->header().frequency_hz),
                      .remedy = "measure or convert them to one axis"});
  }
}

void FrfSystem::collect_coordinates() {
  for (const auto& source : sources_) {
    const FrfHeader& header = source->header();
    add_coordinates(responses_, header.response);
    add_coordinates(references_, header.reference);
    if (use_reciprocity_) {
      add_coordinates(responses_, header.reference);
      add_coordinates(references_, header.response);
    }
  }
}

void FrfSystem::require_disjoint() const {
  const auto fail = [&](std::size_t second, const std::string& what, const std::string& remedy) {
    throw InputError({.kind = ErrorKind::data,
                      .file = sources_[second]->header().file,
                      .place = name_,
                      .problem = what,
                      .remedy = remedy});
  };
  for (std::size_t first = 0; first < sources_.size(); ++first) {
    for (std::size_t second = first + 1; second < sources_.size(); ++second) {
      const FrfHeader& one = sources_[first]->header();
      const FrfHeader& two = sources_[second]->header();
      for (const auto* dofs : {&two.response, &two.reference}) {
        for (const Dof& dof : *dofs) {
          if (composition_ != Composition::uncoupled || !(has(one.response, dof) || has(one.reference, dof))) continue;
          fail(second, "DOF " + dof.name() + " is also in " + one.file,
               "two substructures share no coordinate: rename the node, or put both into one file");
        }
      }
      for (const Dof& response : two.response) {
        if (!has(one.response, response)) continue;
        for (const Dof& reference : two.reference) {
          if (has(one.reference, reference)) {
            fail(second, "FRF " + response.name() + " / " + reference.name() + " is also in " + one.file,
                 "keep it in one file");
          }
        }
      }
    }
  }
}

void FrfSystem::keep(std::size_t bytes) {
  for (KeptSource* file : files_) file->keep(bytes / files_.size());
}

std::size_t FrfSystem::source_of(const Dof& dof) const {
  for (std::size_t s = 0; s < sources_.size(); ++s) {
    if (has(sources_[s]->header().response, dof) || has(sources_[s]->header().reference, dof)) return s;
  }
  return npos;
}

std::vector<BlockPiece> FrfSystem::pieces(const std::vector<Dof>& rows, const std::vector<Dof>& columns) const {
  std::vector<BlockPiece> result;
  for (const bool transposed : {false, true}) {
    for (std::size_t s = 0; s < sources_.size() && (use_reciprocity_ || !transposed); ++s) {
      BlockPiece piece = find_piece(sources_[s]->header(), s, rows, columns, transposed);
      if (piece.size() > 0) result.push_back(std::move(piece));
    }
  }
  return result;
}

std::vector<Complex> FrfSystem::background(const std::vector<Dof>& rows, const std::vector<Dof>& columns) const {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Complex> line(rows.size() * columns.size(), Complex(nan, nan));
  if (composition_ != Composition::uncoupled) return line;
  std::vector<std::size_t> column_source;
  for (const Dof& column : columns) column_source.push_back(source_of(column));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::size_t row_source = source_of(rows[r]);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (row_source != column_source[c]) line[r * columns.size() + c] = 0.0;
    }
  }
  return line;
}

BlockReader::BlockReader(FrfSystem& system, const std::vector<Dof>& rows, const std::vector<Dof>& columns)
    : system_(system),
      rows_(rows.size()),
      columns_(columns.size()),
      pieces_(system.pieces(rows, columns)),
      background_(system.background(rows, columns)) {}

bool BlockReader::is_plain() const {
  if (pieces_.size() != 1) return false;
  const BlockPiece& only = pieces_.front();
  const auto positive = [](const std::vector<double>& signs) {
    return std::all_of(signs.begin(), signs.end(), [](double sign) { return sign > 0.0; });
  };
  return !only.transposed && only.rows.size() == rows_ && only.columns.size() == columns_ &&
         positive(only.response_sign) && positive(only.reference_sign);
}

void BlockReader::read(std::span<const std::size_t> lines, std::span<Complex> out) {
  const bool plain = is_plain();
  if (!plain) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::copy(background_.begin(), background_.end(), out.begin() + static_cast<std::ptrdiff_t>(i * background_.size()));
    }
  }
  for (const BlockPiece& piece : pieces_) {
    source_lines_.clear();
    for (const std::size_t line : lines) source_lines_.push_back(system_.source_lines_[piece.source][line]);
    const Block block{source_lines_, piece.responses, piece.references};
    FrfSource& source = *system_.sources_[piece.source];
    if (plain) {
      source.read(block, out);
    } else {
      scratch_.resize(block.size());
      source.read(block, scratch_);
      scatter(piece, lines.size(), out);
    }
  }
}

void BlockReader::scatter(const BlockPiece& piece, std::size_t lines, std::span<Complex> out) const {
  const Complex* from = scratch_.data();
  for (std::size_t line = 0; line < lines; ++line) {
    Complex* to = out.data() + line * rows_ * columns_;
    for (std::size_t r = 0; r < piece.rows.size(); ++r) {
      Complex* row = to + (piece.transposed ? piece.rows[r] : piece.rows[r] * columns_);
      const std::size_t step = piece.transposed ? columns_ : 1;
      for (std::size_t c = 0; c < piece.columns.size(); ++c, ++from) {
        Complex& target = row[piece.columns[c] * step];
        if (piece.transposed && !std::isnan(target.real())) continue;
        target = *from * (piece.response_sign[r] * piece.reference_sign[c]);
      }
    }
  }
}

std::unique_ptr<FrfSystem> memory_system(std::string name, std::vector<FrfSet> sets, Composition composition, bool reciprocity) {
  std::vector<std::unique_ptr<FrfSource>> sources;
  for (FrfSet& set : sets) sources.push_back(from_memory(std::move(set)));
  return std::make_unique<FrfSystem>(std::move(name), std::move(sources), composition, reciprocity);
}

}  // namespace jointid::frf
