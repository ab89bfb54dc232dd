#include "ident/plan/rectangle.hpp"

#include <algorithm>

namespace jointid::ident {

Rectangle::Rectangle(frf::FrfSystem& system, const std::vector<Band>& bands, const std::vector<frf::Dof>& columns)
    : columns_(columns.size()) {
  for (std::size_t b = 0; b < bands.size(); ++b) {
    std::vector<frf::Dof> rows = bands[b].rows;
    // Bands that need the same columns are one read.
    while (b + 1 < bands.size() && bands[b + 1].columns == bands[b].columns) {
      ++b;
      rows.insert(rows.end(), bands[b].rows.begin(), bands[b].rows.end());
    }
    if (!rows.empty() && !bands[b].columns.empty()) {
      const auto first = std::find(columns.begin(), columns.end(), bands[b].columns.front());
      parts_.push_back({std::make_unique<frf::BlockReader>(system, rows, bands[b].columns), rows_,
                        static_cast<std::size_t>(first - columns.begin())});
    }
    rows_ += rows.size();
  }
}

std::size_t Rectangle::entries_per_line() const {
  std::size_t entries = 0;
  for (const Part& part : parts_) entries += part.reader->rows() * part.reader->columns();
  return entries;
}

void Rectangle::read(std::span<const std::size_t> lines) {
  values_.resize(lines.size() * rows_ * columns_);
  for (Part& part : parts_) {
    frf::BlockReader& reader = *part.reader;
    if (reader.rows() == rows_ && reader.columns() == columns_) {
      reader.read(lines, values_);
      continue;
    }
    scratch_.resize(lines.size() * reader.rows() * reader.columns());
    reader.read(lines, scratch_);
    const Complex* from = scratch_.data();
    for (std::size_t line = 0; line < lines.size(); ++line) {
      for (std::size_t r = 0; r < reader.rows(); ++r, from += reader.columns()) {
        Complex* to = values_.data() + (line * rows_ + part.first_row + r) * columns_ + part.first_column;
        std::copy(from, from + reader.columns(), to);
      }
    }
  }
}

minimise::View Rectangle::line(std::size_t i) const { return {values_.data() + i * rows_ * columns_, rows_, columns_, columns_}; }

}  // namespace jointid::ident
