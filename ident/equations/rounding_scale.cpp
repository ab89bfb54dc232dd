#include "ident/equations/rounding_scale.hpp"

#include <cmath>
#include <span>

#include "base/kernel.hpp"

namespace jointid::ident {
namespace {

double squared(double x) { return x * x; }

/// Weighted ‖A_p‖², or of A's errors.
double column_norm2(const minimise::LineProduct& line, const SubProduct& part, std::size_t p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < part.rows.size(); ++i) {
    const std::size_t m = part.rows[i];
    const double element2 = line.a_is_unit         ? (m == p ? 1.0 : 0.0)
                            : line.a_error.empty() ? std::norm(line.a(m, p))
                                                   : squared(line.a_error[m * line.a.columns + p]);
    sum += squared(part.row_weight[i]) * element2;
  }
  return sum;
}

double row_norm2(const minimise::LineProduct& line, const SubProduct& part, std::size_t q) {
  double sum = 0.0;
  for (std::size_t i = 0; i < part.columns.size(); ++i) {
    sum += squared(part.column_weight[i]) * std::norm(line.b(q, part.columns[i]));
  }
  return sum;
}

/// Σ_k w_k² (|c1_k|² + |c2_k|²) of numbers side by side.
JOINTID_KERNEL double weighted_norm2(const double* c1, const double* c2, const double* weight, std::size_t count) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t k = 0; k < count; ++k) {
    const double size2 = c1[2 * k] * c1[2 * k] + c1[2 * k + 1] * c1[2 * k + 1] + c2[2 * k] * c2[2 * k] + c2[2 * k + 1] * c2[2 * k + 1];
    sum += weight[k] * weight[k] * size2;
  }
  return sum;
}

const double* numbers(const Complex& first) { return reinterpret_cast<const double*>(&first); }

/// Weighted squares of the elements of row m in the columns of the part, or of their errors.
double right_row_norm2(const minimise::LineProduct& line, const SubProduct& part, std::size_t m) {
  double row = 0.0;
  for (std::size_t k = 0; k < part.columns.size(); ++k) {
    const std::size_t l = part.columns[k];
    const double element2 = line.c_error.empty() ? std::norm(line.c1(m, l)) + std::norm(line.c2(m, l))
                                                 : squared(line.c_error[m * line.c1.columns + l]);
    row += squared(part.column_weight[k]) * element2;
  }
  return row;
}

bool are_side_by_side(std::span<const std::size_t> columns) {
  for (std::size_t k = 1; k < columns.size(); ++k) {
    if (columns[k] != columns[0] + k) return false;
  }
  return !columns.empty();
}

double right_norm2(const minimise::LineProduct& line, const SubProduct& part) {
  const bool plain = line.c_error.empty() && are_side_by_side(part.columns);
  double sum = 0.0;
  for (std::size_t i = 0; i < part.rows.size(); ++i) {
    const std::size_t m = part.rows[i];
    sum += squared(part.row_weight[i]) *
           (plain ? weighted_norm2(numbers(line.c1(m, part.columns[0])), numbers(line.c2(m, part.columns[0])),
                                   part.column_weight.data(), part.columns.size())
                  : right_row_norm2(line, part, m));
  }
  return sum;
}

}  // namespace

void RoundingScale::add(const minimise::LineProduct& line, const SubProduct& part, double factor) {
  add(line, part, factor, part.a_dofs, part.b_dofs, line.b.rows);
}

void RoundingScale::add(const minimise::LineProduct& line, const SubProduct& part, double factor, std::span<const std::size_t> a_dofs,
                        std::span<const std::size_t> b_dofs, std::size_t joint) {
  joint_ = joint;
  coefficient2_.resize(joint_ * joint_, 0.0);
  a2_.clear();
  b2_.clear();
  for (const std::size_t p : part.a_dofs) a2_.push_back(column_norm2(line, part, p));
  for (const std::size_t q : part.b_dofs) b2_.push_back(row_norm2(line, part, q));
  for (std::size_t i = 0; i < a2_.size(); ++i) {
    for (std::size_t k = 0; k < b2_.size(); ++k) {
      coefficient2_[a_dofs[i] * joint_ + b_dofs[k]] += squared(factor) * a2_[i] * b2_[k];
    }
  }
  right2_ += squared(factor) * right_norm2(line, part);
}

void RoundingScale::merge(const RoundingScale& other) {
  if (other.joint_ == 0) return;
  joint_ = other.joint_;
  right2_ += other.right2_;
  coefficient2_.resize(joint_ * joint_, 0.0);
  for (std::size_t i = 0; i < coefficient2_.size(); ++i) coefficient2_[i] += other.coefficient2_[i];
}

std::vector<double> RoundingScale::packed() const {
  std::vector<double> out = {static_cast<double>(joint_), right2_};
  out.insert(out.end(), coefficient2_.begin(), coefficient2_.end());
  return out;
}

void RoundingScale::merge_packed(std::span<const double> packed) {
  RoundingScale other;
  other.joint_ = static_cast<std::size_t>(packed[0]);
  other.right2_ = packed[1];
  other.coefficient2_.assign(packed.begin() + 2, packed.end());
  merge(other);
}

double RoundingScale::right() const { return std::sqrt(right2_); }

double RoundingScale::coefficient(std::size_t p, std::size_t q) const {
  return coefficient2_.empty() ? 0.0 : std::sqrt(coefficient2_[p * joint_ + q]);
}

}  // namespace jointid::ident
