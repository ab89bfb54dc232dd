#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ident/equations/kronecker.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {

/// Writes compressed equations R_A Z_j R_Bᵀ = C'' as real rows over the unknowns: row = [E T_f T | p] with
/// E = R_A ⊗ R_B, T_f = [I, −(ω/ω₀)²I, i(ω/ω₀)I, iI] (docs/formulas.md §1, 6.35), T the restriction matrix (§4),
/// p = C'' − R_A Z_known R_Bᵀ,
/// real and imaginary part one below the other (6.46–6.49). The unknowns are those of x = {k, ω₀²m, ω₀c, d} (6.36).
///
/// Made for one set of unknowns (a `Support`); matrices with the same terms share the work.
class RowExpander {
 public:
  /// `a_dofs` × `b_dofs` are the elements of Z_j with coefficients, `unknowns` those that occur in them.
  RowExpander(const restrictions::Restriction& restriction, std::span<const std::size_t> a_dofs,
              std::span<const std::size_t> b_dofs, std::span<const std::size_t> unknowns, double omega0);

  /// Prepares for a line at ω in rad/s.
  void set_line(double omega);

  /// Equations handled at a time.
  static constexpr std::size_t most = 64;

  /// The 2·count real rows of equations [first, first + count) of the P·Q, count ≤ `most`, equation (p,q) at p·Q + q: real
  /// and imaginary part of each; `rows` zero-filled, `stride` apart, right-hand side at unknowns().
  void expand(const Compressed& compressed, std::size_t first, std::size_t count, double* rows, std::size_t stride);

  /// The same as `count` complex rows for a ComplexTriangle over pair(): coefficients and right-hand side, imaginary parts
  /// `half` further on.
  void expand_complex(const Compressed& compressed, std::size_t first, std::size_t count, double* rows, std::size_t half);

  /// Where the joint has stiffness and hysteretic damping of the same pattern and nothing else, k and d of every unknown make
  /// one complex unknown k + i·d: their columns. Empty otherwise.
  struct Pair {
    std::vector<std::size_t> stiffness, damping;
  };
  const std::optional<Pair>& pair() const { return pair_; }

  std::size_t unknowns() const { return unknowns_; }

 private:
  /// One element of T: product A(·,a)·B(·,b) times the coefficient goes to an unknown of the pattern.
  struct Term {
    std::size_t a, b;
    std::size_t unknown;
    double coefficient;
  };
  struct Pattern {
    std::vector<Term> terms;
    std::size_t unknowns = 0;
  };
  struct Part {
    restrictions::Kind kind;
    std::size_t pattern;
    std::vector<std::size_t> columns;  ///< pattern unknown → column of the support
    double re = 0.0, im = 0.0;         ///< factor of T_f at the current line
  };
  struct Known {
    restrictions::Kind kind;
    std::size_t a, b;
    double value;
  };

  void find_pair();
  void gather(const Compressed& compressed, std::size_t first, std::size_t count);
  void sum_pattern(const Pattern& pattern, std::size_t count);
  Complex right_side(const Compressed& compressed, std::size_t first, std::size_t count, std::size_t e) const;
  void write(const Part& part, std::size_t count, double* rows, std::size_t stride) const;
  static void sum_terms(const std::vector<Term>& terms, const double* a_re, const double* a_im, const double* b_re,
                        const double* b_im, std::size_t count, double* sum_re, double* sum_im);

  std::size_t unknowns_;
  double omega0_;
  std::vector<Pattern> patterns_;
  std::vector<Part> parts_;
  std::vector<Known> known_;
  std::optional<Pair> pair_;
  std::vector<Complex> known_impedance_;  ///< Z_known at the current line, per element of known_
  /// Equations side by side, `count` of them: coefficients of A and B, sums per unknown.
  std::vector<double> a_re_, a_im_, b_re_, b_im_, sum_re_, sum_im_;
};

}  // namespace jointid::ident
