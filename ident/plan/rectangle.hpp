#pragma once

#include <memory>
#include <span>
#include <vector>

#include "frf/set/frf_system.hpp"
#include "minimise/linear/line_product.hpp"

namespace jointid::ident {

/// A band of rows of a rectangle and the columns that are needed of it.
struct Band {
  std::vector<frf::Dof> rows;
  std::vector<frf::Dof> columns;  ///< a trailing or leading part of the rectangle's columns
};

/// Some lines of the FRFs rows × columns of one system, of which only the bands are read. What no band asks for is never
/// read and must not be used.
class Rectangle {
 public:
  /// The rectangle has the rows of all bands one below the other, and the columns `columns`.
  Rectangle(frf::FrfSystem& system, const std::vector<Band>& bands, const std::vector<frf::Dof>& columns);

  void read(std::span<const std::size_t> lines);

  /// The rectangle of the i-th line of the last read().
  minimise::View line(std::size_t i) const;

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  /// FRFs read per line.
  std::size_t entries_per_line() const;

 private:
  struct Part {
    std::unique_ptr<frf::BlockReader> reader;
    std::size_t first_row = 0, first_column = 0;
  };
  std::vector<Part> parts_;
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<Complex> values_, scratch_;
};

}  // namespace jointid::ident
