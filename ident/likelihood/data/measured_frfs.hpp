#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/complex.hpp"
#include "ident/likelihood/line/symmetric.hpp"

namespace jointid::ident {

/// A measured FRF with the variances of its real and imaginary part; NaN where not measured.
struct Measured {
  Complex value, variance;
  bool averaged = false;  ///< of two measurements that differ

  bool known() const { return !std::isnan(value.real()) && !std::isnan(variance.real()); }
  bool is_zero() const { return known() && value == Complex(0.0); }
};

/// The difference of two independent measurements; not known unless both are.
inline Measured operator-(const Measured& a, const Measured& b) {
  return {a.value - b.value, a.variance + b.variance};
}

/// The FRFs of one system on a line as a symmetric matrix over some coordinates.
class MeasuredFrfs {
 public:
  explicit MeasuredFrfs(std::size_t size, const Measured& value = {}) : all_(size, value) {}

  /// Until pack().
  Measured& at(std::size_t row, std::size_t column) { return all_.at(row, column); }
  const Measured& at(std::size_t row, std::size_t column) const {
    return places_ ? kept_[(*places_)[triangle_place(row, column)]] : all_.at(row, column);
  }

  /// Keeps those alone that are known and not exactly zero; nothing is left of a value or variance without the other. `size` coordinates.
  /// Where they are those of `before`, which was packed, too, both share the list of places.
  void pack(std::size_t size, const MeasuredFrfs* before);

  std::size_t bytes() const;

 private:
  using Places = std::vector<std::uint32_t>;

  Symmetric<Measured> all_;              ///< empty once packed
  std::shared_ptr<const Places> places_;  ///< in kept_, of one triangle
  std::vector<Measured> kept_;           ///< the first two: not measured, zero
};

/// Of both systems.
struct BothMeasured {
  MeasuredFrfs substructures, assembly;
};

}  // namespace jointid::ident
