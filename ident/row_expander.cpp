#include "ident/row_expander.hpp"

#include <algorithm>
#include <map>

namespace jointid::ident {
namespace {

using restrictions::Kind;

/// Place of `index` in `list`, or list.size().
std::size_t place(std::span<const std::size_t> list, std::size_t index) {
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), index) - list.begin());
}

}  // namespace

Complex impedance_factor(Kind kind, double omega) {
  switch (kind) {
    case Kind::mass:
      return -omega * omega;
    case Kind::viscous_damping:
      return {0.0, omega};
    case Kind::hysteretic_damping:
      return {0.0, 1.0};
    case Kind::stiffness:
      break;
  }
  return 1.0;
}

double unscale(Kind kind, double omega0) {
  switch (kind) {
    case Kind::mass:
      return 1.0 / (omega0 * omega0);
    case Kind::viscous_damping:
      return 1.0 / omega0;
    case Kind::stiffness:
    case Kind::hysteretic_damping:
      break;
  }
  return 1.0;
}

RowExpander::RowExpander(const restrictions::Restriction& restriction, std::span<const std::size_t> a_dofs,
                         std::span<const std::size_t> b_dofs, std::span<const std::size_t> unknowns, double omega0)
    : unknowns_(unknowns.size()),
      omega0_(omega0),
      product_re_(a_dofs.size() * b_dofs.size()),
      product_im_(a_dofs.size() * b_dofs.size()) {
  const auto element = [&](std::size_t row, std::size_t column, std::size_t& at) {
    const std::size_t i = place(a_dofs, row), j = place(b_dofs, column);
    at = i * b_dofs.size() + j;
    return i < a_dofs.size() && j < b_dofs.size();
  };
  for (const restrictions::MatrixTerms& matrix : restriction.matrices) {
    Pattern pattern;
    Part part{.kind = matrix.kind, .pattern = 0, .columns = {}};
    std::map<std::size_t, std::size_t> local;
    for (const restrictions::Term& term : matrix.terms) {
      std::size_t at = 0;
      if (!element(term.row, term.column, at)) continue;
      const auto [found, added] = local.try_emplace(term.unknown, local.size());
      if (added) part.columns.push_back(place(unknowns, term.unknown));
      pattern.terms.push_back({at, found->second, term.coefficient});
    }
    pattern.unknowns = local.size();
    for (const restrictions::Known& known : matrix.known) {
      std::size_t at = 0;
      if (element(known.row, known.column, at)) known_.push_back({matrix.kind, at, known.value});
    }
    if (pattern.terms.empty()) continue;
    const auto same = [&](const Pattern& other) {
      return std::equal(other.terms.begin(), other.terms.end(), pattern.terms.begin(), pattern.terms.end(),
                        [](const Term& a, const Term& b) {
                          return a.element == b.element && a.unknown == b.unknown && a.coefficient == b.coefficient;
                        });
    };
    const auto found = std::find_if(patterns_.begin(), patterns_.end(), same);
    part.pattern = static_cast<std::size_t>(found - patterns_.begin());
    if (found == patterns_.end()) patterns_.push_back(std::move(pattern));
    parts_.push_back(std::move(part));
  }
  known_impedance_.resize(known_.size());
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

void RowExpander::expand(const Compressed& compressed, std::size_t p, double* rows, std::size_t stride) {
  const std::size_t na = compressed.ra.columns, nb = compressed.rb.columns, q_count = compressed.rb.rows;
  const double* a_re = compressed.ra.re.data() + p * na;
  const double* a_im = compressed.ra.im.data() + p * na;
  for (std::size_t q = 0; q < q_count; ++q) {
    const double* b_re = compressed.rb.re.data() + q * nb;
    const double* b_im = compressed.rb.im.data() + q * nb;
    for (std::size_t i = 0; i < na; ++i) {
      for (std::size_t j = 0; j < nb; ++j) {
        product_re_[i * nb + j] = a_re[i] * b_re[j] - a_im[i] * b_im[j];
        product_im_[i * nb + j] = a_re[i] * b_im[j] + a_im[i] * b_re[j];
      }
    }
    double* real_row = rows + 2 * q * stride;
    double* imag_row = real_row + stride;
    for (std::size_t k = 0; k < patterns_.size(); ++k) {
      const Pattern& pattern = patterns_[k];
      sum_re_.assign(pattern.unknowns, 0.0);
      sum_im_.assign(pattern.unknowns, 0.0);
      for (const Term& term : pattern.terms) {
        sum_re_[term.unknown] += term.coefficient * product_re_[term.element];
        sum_im_[term.unknown] += term.coefficient * product_im_[term.element];
      }
      for (const Part& part : parts_) {
        if (part.pattern != k) continue;
        for (std::size_t u = 0; u < pattern.unknowns; ++u) {
          real_row[part.columns[u]] = part.re * sum_re_[u] - part.im * sum_im_[u];
          imag_row[part.columns[u]] = part.re * sum_im_[u] + part.im * sum_re_[u];
        }
      }
    }
    Complex right(compressed.c.re[p * q_count + q], compressed.c.im[p * q_count + q]);
    for (std::size_t k = 0; k < known_.size(); ++k) {
      const std::size_t at = known_[k].element;
      right -= known_impedance_[k] * Complex(product_re_[at], product_im_[at]);
    }
    real_row[unknowns_] = right.real();
    imag_row[unknowns_] = right.imag();
  }
}

}  // namespace jointid::ident
