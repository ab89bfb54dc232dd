#include "ident/variance/variances.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>

namespace jointid::ident {
namespace {

/// f(place in the rectangles of all lines, place in the values of the piece)
template <class Function>
void for_each(const frf::BlockPiece& piece, std::size_t lines, std::size_t size, std::size_t columns, Function f) {
  std::size_t i = 0;
  for (std::size_t line = 0; line < lines; ++line) {
    for (std::size_t r = 0; r < piece.responses.size(); ++r) {
      for (std::size_t c = 0; c < piece.references.size(); ++c, ++i) f(line * size + piece.place(r, c, columns), i);
    }
  }
}

std::set<std::size_t> places(const frf::BlockPiece& piece, std::size_t columns) {
  std::set<std::size_t> all;
  for_each(piece, 1, 0, columns, [&](std::size_t place, std::size_t) { all.insert(place); });
  return all;
}

}  // namespace

Variances::Variances(frf::FrfSystem& system, const std::vector<frf::Dof>& rows, const std::vector<frf::Dof>& columns,
                     const Scene& scene)
    : system_(system), columns_(columns.size()), background_(system.background(rows, columns)) {
  for (frf::BlockPiece& piece : system.pieces(rows, columns)) {
    frf::FrfSource& source = system.source(piece.source);
    parts_.emplace_back(source, std::move(piece), scene);
  }
  find_contested();
}

void Variances::find_contested() {
  contested_.assign(parts_.size(), false);
  std::set<std::size_t> later;
  for (std::size_t i = parts_.size(); i-- > 0;) {
    for (const std::size_t place : places(parts_[i].piece(), columns_)) {
      if (!later.insert(place).second) contested_[i] = true;
    }
    if (contested_[i]) any_contested_ = true;
  }
}

bool Variances::needs_prepare() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const VariancePiece& part) { return part.needs_prepare(); });
}

std::span<const std::size_t> Variances::lines_of(const VariancePiece& part, std::span<const std::size_t> lines) {
  source_lines_.clear();
  for (const std::size_t line : lines) source_lines_.push_back(system_.source_line(part.piece().source, line));
  return source_lines_;
}

void Variances::prepare(std::span<const std::size_t> lines) {
  for (VariancePiece& part : parts_) part.prepare(lines_of(part, lines));
}

void Variances::read(std::span<const std::size_t> lines, std::span<const Complex> frf, std::span<Complex> out) {
  const std::size_t size = background_.size();
  assert(frf.size() == lines.size() * size && out.size() == frf.size());
  for (std::size_t line = 0; line < lines.size(); ++line) {
    std::copy(background_.begin(), background_.end(), out.begin() + static_cast<std::ptrdiff_t>(line * size));
  }
  if (any_contested_) taken_.assign(frf.size(), false);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    VariancePiece& part = parts_[p];
    const auto own_lines = lines_of(part, lines);
    values_.resize(lines.size() * part.piece().size());
    variances_.resize(values_.size());
    for_each(part.piece(), lines.size(), size, columns_, [&](std::size_t at, std::size_t i) { values_[i] = frf[at]; });
    part.read(own_lines, values_, variances_);
    if (contested_[p]) part.read_values(own_lines, values_);
    for_each(part.piece(), lines.size(), size, columns_, [&](std::size_t at, std::size_t i) {
      if (std::isnan(values_[i].real()) || (any_contested_ && taken_[at])) return;
      out[at] = variances_[i];
      if (any_contested_) taken_[at] = true;
    });
  }
}

std::vector<FileVariances> Variances::origins() const {
  std::vector<FileVariances> all;
  std::map<std::size_t, FileVariances> by_source;
  for (const VariancePiece& part : parts_) {
    FileVariances& file = by_source[part.piece().source];
    file.file = part.source().header().file;
    file.origin = part.origin();
    file.unresolved += part.unresolved();
  }
  for (auto& [source, file] : by_source) all.push_back(std::move(file));
  return all;
}

std::string note(const FileVariances& file) {
  if (file.unresolved == 0) return {};
  return file.file + ": between its lines " + std::to_string(file.unresolved) +
         " FRFs change too much to see their noise; their variances are upper bounds (measure more lines, or give [noise])";
}

}  // namespace jointid::ident
