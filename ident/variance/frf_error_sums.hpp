#pragma once

#include <vector>

#include "frf/set/frf_system.hpp"

namespace jointid::ident {

/// What makes the errors of the FRFs of a system over some coordinates, where its files tell (frf::ErrorSums): those of coupled parts.
class FrfErrorSums {
 public:
  FrfErrorSums(frf::FrfSystem& system, const std::vector<frf::Dof>& coordinates);

  bool any() const { return !sources_.empty(); }

  /// Reads some common lines (ascending).
  void read(std::span<const std::size_t> lines);

  /// Of the i-th line read: the independent errors of unit variance in that of the FRF (row, column).
  std::vector<frf::ErrorSums::Term> terms(std::size_t i, std::size_t row, std::size_t column) const;

 private:
  /// A file that tells, and which of its FRFs are read.
  struct Source {
    std::size_t source;
    std::vector<std::size_t> responses, references;
    std::vector<frf::ErrorSums> lines{};
  };
  /// The FRF of a place; no source: it has no sums.
  struct Place {
    std::size_t source = frf::npos, response = 0, reference = 0;
    double sign = 1.0;
  };

  void add(const frf::BlockPiece& piece);

  frf::FrfSystem& system_;
  std::size_t size_;
  std::vector<Source> sources_;
  std::vector<Place> places_;  ///< [row, column]
};

}  // namespace jointid::ident
