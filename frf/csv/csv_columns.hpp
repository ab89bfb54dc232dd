#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "frf/csv/csv_table.hpp"
#include "frf/csv/csv_titles.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Which column holds what, by the header row of a table.
class CsvColumns {
 public:
  /// Columns of one response and reference, by part; 0 (the frequency) where there is none.
  class OfPair {
   public:
    std::size_t& operator[](CsvPart part) { return column_[static_cast<std::size_t>(part)]; }
    std::size_t operator[](CsvPart part) const { return column_[static_cast<std::size_t>(part)]; }
    bool has(CsvPart part) const { return (*this)[part] != 0; }

   private:
    std::array<std::size_t, csv_part_names.size()> column_{};
  };
  using Pairs = std::map<std::pair<std::size_t, std::size_t>, OfPair>;

  /// Fills the DOFs of `header`; `table` must outlive it. Throws InputError naming the column that is none of an FRF, stands
  /// there twice, lacks its other half or has a unit that its part cannot have, and where the columns name other DOFs than the
  /// options.
  CsvColumns(const CsvTable& table, const OpenOptions& options, FrfHeader& header);

  /// Columns by (response, reference) index.
  const Pairs& pairs() const { return pairs_; }

  bool has(CsvPart part) const;

  /// The unit that the titles or a row under them give a pair, and its column; empty where they give none.
  const std::string& unit(const OfPair& pair, std::size_t& column) const;

 private:
  const CsvTable& table_;
  Pairs pairs_;
};

}  // namespace jointid::frf
