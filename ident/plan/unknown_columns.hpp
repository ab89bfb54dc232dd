#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ident/scene/scene.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {

/// Columns of the whole system: one per unknown, or one per unknown and band of its joint.
class UnknownColumns {
 public:
  UnknownColumns(const restrictions::Restriction& restriction, const std::vector<restrictions::JointSpec>& joints);

  std::size_t size() const { return unknown_of_.size(); }
  std::size_t unknown_of(std::size_t column) const { return unknown_of_[column]; }
  /// Band of the column's joint, or empty where the joint has none.
  std::optional<Range> band_of(std::size_t column) const { return band_of_[column]; }

  /// The unknown's name, with the band where there are several: "K(1,2)", "K(1,2)@400-500Hz".
  std::string name(std::size_t column, const restrictions::Restriction& restriction) const;

  /// Columns of all unknowns at a line, or empty when the line lies in no band of some joint.
  std::vector<std::size_t> at(double frequency_hz) const;

  /// Distinct frequency limits of all bands in ascending order; between two of them the columns do not change.
  const std::vector<double>& limits_hz() const { return limits_hz_; }

 private:
  struct Place {
    std::size_t first_column;
    std::vector<Range> bands;
  };
  std::vector<Place> places_;  ///< per unknown
  std::vector<std::size_t> unknown_of_;
  std::vector<std::optional<Range>> band_of_;
  std::vector<double> limits_hz_;
};

}  // namespace jointid::ident
