#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::frf {

enum class WildKind : std::uint8_t {
  not_a_number,
  infinite,
  large,  ///< far above its neighbours
  small   ///< far below them
};

/// Values of one FRF, on consecutive lines, that cannot be FRFs of a structure.
struct WildValue {
  WildKind kind = WildKind::not_a_number;
  std::size_t response = npos, reference = npos;  ///< npos: every FRF of the set that has values at all
  std::size_t line = 0, last_line = 0;            ///< the first and the last
  Complex value{};                                ///< receptance on the first
  double factor = 0.0;                            ///< of large and small: largest |value| over that of its neighbours, or least
};

struct WildValues {
  std::vector<WildValue> found;  ///< by kind, then line; at most `most_wild_values`
  std::size_t more = 0;          ///< further ones, which are only counted
  bool looked = true;            ///< false where a set has more than `most_judged_frfs`: none of it was looked at
};

inline constexpr std::size_t most_wild_values = 4096;
inline constexpr std::size_t most_judged_frfs = std::size_t{1} << 18;  ///< seven lines of them are held in memory

/// Looks for them line by line, so that a set need not be in memory. An FRF H on line l with frequency f_l > 0 is judged by those
/// of the three lines on either side that are numbers, at least three in all. M is the third smallest of six |H_n| (the lower
/// middle one of fewer), each times (f_n/f_l)² where that makes the case weaker, since a receptance may fall with the square of
/// the frequency.
///   - large: |H| > 500 M. A resonance between two lines is left out: |H_{l±1}| ≥ 1.3 |H_{l±2}| on both sides and
///     |H_{l−1} + H_{l+1}| < 0.7 |H_{l−1} − H_{l+1}|, unless |H| > 10⁵ M; on the two lines at either end, where a third of all
///     other FRFs are 10 times their nearest neighbours. What passes a row of joints on few lines is left out, too: a third of
///     all other FRFs are above 10 M, two of them above |H|/M's hundredth, |H| is below 500 times the largest M, and so is the
///     median of |H|/M of FRFs whose M is 1 % of the largest or more;
///   - small: |H| < M/1000 and its nearest neighbours that are not small themselves, one on each side, agree: their difference is
///   at most
///     their mean. So an antiresonance, where they have opposite signs, is left out, and so are the ends, and where H_ji of H_ij
///     is 30 times below its neighbours on the same line;
///   - what is below 10⁻¹⁰ of the largest FRF on lines about it is rounding: H of a large, M of a small one;
///   - an FRF that is nowhere a number or zero everywhere, and all values at 0 Hz, are left out.
/// Gaussian noise alone makes about one value in ten million small.
class WildSearch {
 public:
  /// `header` must outlive it and have at most `most_judged_frfs`.
  explicit WildSearch(const FrfHeader& header);

  /// The next lines in order, [line, response, reference] of the whole set.
  void add(std::span<const Complex> values);

  /// After the last line, or where reading ended.
  WildValues finish();

 private:
  static constexpr std::size_t reach = 3, kept = 2 * reach + 1;

  void add_line(std::span<const Complex> values);
  void judge(std::size_t line);
  void judge(std::size_t line, std::size_t entry, double floor);
  bool is_resonance(std::size_t line, std::size_t entry);
  bool others_rise(std::size_t line, std::size_t entry);
  bool passes_joints(std::size_t line, std::size_t entry);
  /// M of large values and that of small ones; nothing where fewer than three neighbours are numbers.
  struct Typical {
    double under, over;
  };
  std::optional<Typical> typical(std::size_t line, std::size_t entry) const;
  /// Of an FRF that can be compared with its neighbours: whether it is 10 times the larger one.
  std::optional<bool> rises(std::size_t line, std::size_t entry) const;
  bool mirror_falls(std::size_t line, std::size_t entry) const;
  bool is_dropout(std::size_t line, std::size_t entry, double typical) const;
  Complex value(std::size_t line, std::size_t entry) const { return values_[line % kept][entry]; }
  double magnitude(std::size_t line, std::size_t entry) const { return magnitudes_[line % kept][entry]; }
  void note(WildKind kind, std::size_t line, std::size_t entry, double factor);
  void join_common(std::vector<WildValue>& runs) const;

  const FrfHeader& header_;
  std::size_t lines_ = 0, judged_ = 0, counted_lines_ = 0;
  std::array<std::vector<Complex>, kept> values_;
  std::array<std::vector<double>, kept> magnitudes_;  ///< max(|re|, |im|); NaN where that is no finite number or at 0 Hz
  std::array<double, kept> maxima_{};                 ///< of all FRFs
  std::vector<std::size_t> mirror_;                   ///< of each FRF H_ij the place of H_ji, npos where there is none or i = j
  std::vector<std::size_t> missing_;                  ///< of each FRF, lines that are no number
  std::vector<std::array<std::size_t, 4>> open_;      ///< of each FRF and kind, the run in found_ that goes on, or npos
  std::vector<WildValue> found_;
  std::size_t more_ = 0;

  /// Of all FRFs of the line that is judged, once it was asked.
  struct Rise {
    std::size_t line, risen = 0, compared = 0;
  };
  std::optional<Rise> rise_;
  /// |H|/M of all FRFs of the line that is judged, once it was asked; 0 where there is none.
  struct Ratios {
    std::size_t line;
    std::vector<double> own{}, sorted{};
    double largest = 0.0;   ///< M
    double of_large = 0.0;  ///< the median of those whose M is large
  };
  const Ratios& ratios(std::size_t line);
  std::optional<Ratios> ratios_;
};

}  // namespace jointid::frf
