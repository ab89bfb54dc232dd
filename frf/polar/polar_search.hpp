#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <string>

#include "base/complex.hpp"
#include "frf/set/quantity.hpp"

namespace jointid::frf {

/// Looks for magnitudes and phases among numbers that a file calls real and imaginary parts, a and b of each line.
///
/// They are only ever found where no a of all FRFs is below 0 (or none above 0: decibels of small magnitudes), and by one of
///   - wraps: b is bounded by ±π or [0, 2π] (±180, [0, 360]) and leaps by 0.9 of a turn or more from one line to the next, while it
///     stays within a tenth of a turn of this edge on two lines on either side, and a within a factor of 3. An imaginary part that
///     leaps so has a pole between the two lines, and falls to half of the leap or less beside them;
///   - levels: in one FRF, b is within 0.04 of a right angle of two or more multiples of it, six lines or more at the second of
///     them in runs of four or more, and at most three times as many between all levels. A resonance passes through, with twenty;
///   - turns, where no a is below 0: from half power to half power at most peaks of a, two at least, b turns by a right angle
///     ± 20 %, while these peaks are below 0.05 or above 5 half turns, or differ by a factor of 8. The circle of a resonance is as
///     wide as it is high;
///   - sizes, where no a is below 0, but for mobilities, which little damping leaves imaginary on most lines: |b| is
///     100 a or more on 80 % of the lines of every FRF and at least 0.3, at most 360.
/// Values that are not finite are left out, FRFs of fewer than eight others not looked at.
class PolarOrder {
 public:
  /// `phase_first`: a is then the second number of a line.
  explicit PolarOrder(Quantity quantity, bool phase_first = false) : quantity_(quantity), phase_first_(phase_first) {}

  /// One FRF over all lines, as the file has it, or with its numbers exchanged.
  void add(std::span<const Complex> frf);

  /// False once a of both signs were seen: nothing will be found.
  bool may_be() const { return !(above_ && below_); }

  /// Whether some a is above 0 and none below.
  bool is_positive() const { return above_ && !below_; }

  std::optional<std::string> finding() const;
  std::optional<std::string> doubt() const;

 private:
  static constexpr std::array<double, 2> halves = {std::numbers::pi, 180.0};

  /// From half power to half power: whether b turns by a right angle, and how high.
  struct Turns {
    std::size_t peaks = 0, right = 0;
    double lowest = 0.0, highest = 0.0;
  };
  struct Leap {
    double from = 0.0, to = 0.0;
  };

  void look_for_wraps(std::span<const Complex> frf);
  bool stays_at_edge(std::span<const Complex> frf, std::size_t line, double half, double low) const;
  void look_for_levels(std::span<const Complex> frf);
  void look_for_turns(std::span<const Complex> frf);
  void look_at_sizes(std::span<const Complex> frf);
  bool within(double low, double high) const;
  bool turns_right(std::size_t unit) const;

  std::string signs() const;
  bool ends_at_a_turn(std::size_t unit) const;

  Quantity quantity_;
  bool phase_first_;
  std::size_t frfs_ = 0, large_ = 0, values_ = 0;
  std::array<std::size_t, 2> at_half_turns_{};  ///< b within a tenth of a half turn or more, by unit
  bool above_ = false, below_ = false;  ///< a of either sign
  double least_ = 0.0, most_ = 0.0;     ///< b
  std::array<std::array<std::optional<Leap>, 2>, 2> wraps_{};  ///< by unit, by whether from 0
  std::array<bool, 2> levels_{};
  std::array<Turns, 2> turns_{};
};

/// In both orders. The imaginary part of a driving point has one sign, as a magnitude has: of phases before magnitudes wraps are found.
/// Turns are a doubt, and so are levels, and a fifth of all b within a tenth of a half turn, where b ends at a half turn or a turn: a real
/// part is as large only at its largest resonance.
class PolarSearch {
 public:
  explicit PolarSearch(Quantity quantity) : magnitude_first_(quantity), phase_first_(quantity, true) {}

  /// One FRF over all lines, as the file has it.
  void add(std::span<const Complex> frf);

  /// All FRFs of a set, [line, FRF] with `frfs` of them.
  void add(std::span<const Complex> values, std::size_t frfs);

  /// False once numbers of both signs were seen in either place: nothing will be found.
  bool may_be() const { return magnitude_first_.may_be() || phase_first_.may_be(); }

  /// Whether first numbers were seen, and none of them is below 0.
  bool may_be_magnitudes() const { return magnitude_first_.is_positive(); }

  /// Where they are magnitudes and phases, a phrase that says by what; else empty.
  std::optional<std::string> finding() const;

  /// Where no magnitude is below 0 and phases end at a half turn or a turn, but nothing is found: a phrase; else empty.
  std::optional<std::string> doubt() const;

 private:
  PolarOrder magnitude_first_, phase_first_;
};

}  // namespace jointid::frf
