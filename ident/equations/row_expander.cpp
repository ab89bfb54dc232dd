#include "ident/equations/row_expander.hpp"

#include <algorithm>
#include <map>

#include "base/kernel.hpp"
#include "restrictions/impedance_factor.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;

/// Place of `index` in `list`, or list.size().
std::size_t place(std::span<const std::size_t> list, std::size_t index) {
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), index) - list.begin());
}

}  // namespace

RowExpander::RowExpander(const restrictions::Restriction& restriction, std::span<const std::size_t> a_dofs,
                         std::span<const std::size_t> b_dofs, std::span<const std::size_t> unknowns, double omega0)
    : unknowns_(unknowns.size()),
      omega0_(omega0),
      a_re_(most * a_dofs.size()),
      a_im_(most * a_dofs.size()),
      b_re_(most * b_dofs.size()),
      b_im_(most * b_dofs.size()) {
  for (const restrictions::MatrixTerms& matrix : restriction.matrices) {
    Pattern pattern;
    Part part{.kind = matrix.kind, .pattern = 0, .columns = {}};
    std::map<std::size_t, std::size_t> local;
    for (const restrictions::Term& term : matrix.terms) {
      const std::size_t a = place(a_dofs, term.row), b = place(b_dofs, term.column);
      if (a == a_dofs.size() || b == b_dofs.size()) continue;
      const auto [found, added] = local.try_emplace(term.unknown, local.size());
      if (added) part.columns.push_back(place(unknowns, term.unknown));
      pattern.terms.push_back({a, b, found->second, term.coefficient});
    }
    pattern.unknowns = local.size();
    for (const restrictions::Known& known : matrix.known) {
      const std::size_t a = place(a_dofs, known.row), b = place(b_dofs, known.column);
      if (a < a_dofs.size() && b < b_dofs.size()) known_.push_back({matrix.kind, a, b, known.value});
    }
    if (pattern.terms.empty()) continue;
    const auto same = [&](const Pattern& other) {
      return std::equal(other.terms.begin(), other.terms.end(), pattern.terms.begin(), pattern.terms.end(),
                        [](const Term& a, const Term& b) {
                          return a.a == b.a && a.b == b.b && a.unknown == b.unknown && a.coefficient == b.coefficient;
                        });
    };
    const auto found = std::find_if(patterns_.begin(), patterns_.end(), same);
    part.pattern = static_cast<std::size_t>(found - patterns_.begin());
    if (found == patterns_.end()) {
      sum_re_.resize(std::max(sum_re_.size(), most * pattern.unknowns));
      sum_im_.resize(sum_re_.size());
      patterns_.push_back(std::move(pattern));
    }
    parts_.push_back(std::move(part));
  }
  known_impedance_.resize(known_.size());
  find_pair();
}

void RowExpander::find_pair() {
  if (parts_.size() != 2 || patterns_.size() != 1 || unknowns_ != 2 * patterns_.front().unknowns) return;
  if (parts_[0].kind != Kind::stiffness || parts_[1].kind != Kind::hysteretic_damping) return;
  pair_ = Pair{parts_[0].columns, parts_[1].columns};
}

void RowExpander::set_line(double omega) {
  for (Part& part : parts_) {
    const Complex factor = impedance_factor(part.kind, omega) * unscale(part.kind, omega0_);
    part.re = factor.real();
    part.im = factor.imag();
  }
  for (std::size_t k = 0; k < known_.size(); ++k) {
    known_impedance_[k] = impedance_factor(known_[k].kind, omega) * known_[k].value;
  }
}

/// The rows of R_A and R_B of some equations, turned so that equations lie side by side.
void RowExpander::gather(const Compressed& compressed, std::size_t first, std::size_t count) {
  const auto turn = [&](const SplitMatrix& from, std::vector<double>& re, std::vector<double>& im, const auto& row_of) {
    for (std::size_t e = 0; e < count; ++e) {
      const std::size_t at = row_of(first + e) * from.columns;
      for (std::size_t k = 0; k < from.columns; ++k) {
        re[k * count + e] = from.re[at + k];
        im[k * count + e] = from.im[at + k];
      }
    }
  };
  const std::size_t q_count = compressed.rb.rows;
  turn(compressed.ra, a_re_, a_im_, [&](std::size_t equation) { return equation / q_count; });
  turn(compressed.rb, b_re_, b_im_, [&](std::size_t equation) { return equation % q_count; });
}

JOINTID_KERNEL void RowExpander::sum_terms(const std::vector<Term>& terms, const double* a_re, const double* a_im,
                                           const double* b_re, const double* b_im, std::size_t count, double* sum_re,
                                           double* sum_im) {
  for (const Term& term : terms) {
    const double c = term.coefficient;
    const double* ar = a_re + term.a * count;
    const double* ai = a_im + term.a * count;
    const double* br = b_re + term.b * count;
    const double* bi = b_im + term.b * count;
    double* sr = sum_re + term.unknown * count;
    double* si = sum_im + term.unknown * count;
#pragma omp simd
    for (std::size_t e = 0; e < count; ++e) {
      sr[e] += c * (ar[e] * br[e] - ai[e] * bi[e]);
      si[e] += c * (ar[e] * bi[e] + ai[e] * br[e]);
    }
  }
}

void RowExpander::write(const Part& part, std::size_t count, double* rows, std::size_t stride) const {
  for (std::size_t u = 0; u < part.columns.size(); ++u) {
    double* to = rows + part.columns[u];
    for (std::size_t e = 0; e < count; ++e) {
      const double re = sum_re_[u * count + e], im = sum_im_[u * count + e];
      to[2 * e * stride] = part.re * re - part.im * im;
      to[(2 * e + 1) * stride] = part.re * im + part.im * re;
    }
  }
}

void RowExpander::sum_pattern(const Pattern& pattern, std::size_t count) {
  const auto used = static_cast<std::ptrdiff_t>(count * pattern.unknowns);
  std::fill(sum_re_.begin(), sum_re_.begin() + used, 0.0);
  std::fill(sum_im_.begin(), sum_im_.begin() + used, 0.0);
  sum_terms(pattern.terms, a_re_.data(), a_im_.data(), b_re_.data(), b_im_.data(), count, sum_re_.data(), sum_im_.data());
}

Complex RowExpander::right_side(const Compressed& compressed, std::size_t first, std::size_t count, std::size_t e) const {
  Complex right(compressed.c.re[first + e], compressed.c.im[first + e]);
  for (std::size_t k = 0; k < known_.size(); ++k) {
    const std::size_t a = known_[k].a * count + e, b = known_[k].b * count + e;
    right -= known_impedance_[k] * Complex(a_re_[a], a_im_[a]) * Complex(b_re_[b], b_im_[b]);
  }
  return right;
}

void RowExpander::expand(const Compressed& compressed, std::size_t first, std::size_t count, double* rows,
                         std::size_t stride) {
  gather(compressed, first, count);
  for (std::size_t k = 0; k < patterns_.size(); ++k) {
    sum_pattern(patterns_[k], count);
    for (const Part& part : parts_) {
      if (part.pattern == k) write(part, count, rows, stride);
    }
  }
  for (std::size_t e = 0; e < count; ++e) {
    const Complex right = right_side(compressed, first, count, e);
    rows[2 * e * stride + unknowns_] = right.real();
    rows[(2 * e + 1) * stride + unknowns_] = right.imag();
  }
}

void RowExpander::expand_complex(const Compressed& compressed, std::size_t first, std::size_t count, double* rows,
                                 std::size_t half) {
  gather(compressed, first, count);
  sum_pattern(patterns_.front(), count);
  const std::size_t unknowns = patterns_.front().unknowns;
  for (std::size_t e = 0; e < count; ++e) {
    double* row = rows + e * 2 * half;
    for (std::size_t u = 0; u < unknowns; ++u) {
      row[u] = sum_re_[u * count + e];
      row[half + u] = sum_im_[u * count + e];
    }
    const Complex right = right_side(compressed, first, count, e);
    row[unknowns] = right.real();
    row[half + unknowns] = right.imag();
  }
}

}  // namespace jointid::ident
