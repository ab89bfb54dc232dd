#include "ident/likelihood/line/normal_rows.hpp"

#include <algorithm>

#include "minimise/linear/kernel.hpp"

namespace jointid::ident {
namespace {

JOINTID_INLINE void add_scaled(double* to, const double* re, const double* im, double by_re, double by_im,
                               std::size_t count) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) to[i] += by_re * re[i] + by_im * im[i];
}

JOINTID_KERNEL void add_row(double* values, std::size_t stride, const NormalRows::Run* runs, std::size_t run_count,
                            const double* re, const double* im) {
  std::size_t at = 0;
  for (std::size_t a = 0; a < run_count; ++a) {
    for (std::size_t i = 0; i < runs[a].count; ++i, ++at) {
      double* column = values + (runs[a].first + i) * stride;
      std::size_t from = at;
      add_scaled(column + runs[a].first + i, re + from, im + from, re[at], im[at], runs[a].count - i);
      from += runs[a].count - i;
      for (std::size_t b = a + 1; b < run_count; ++b) {
        add_scaled(column + runs[b].first, re + from, im + from, re[at], im[at], runs[b].count);
        from += runs[b].count;
      }
    }
  }
}

}  // namespace

void NormalRows::reset(std::size_t columns) {
  columns_ = columns;
  values_.assign(columns * columns, 0.0);
  real_.assign(columns, 0.0);
  imaginary_.assign(columns, 0.0);
}

void NormalRows::add(const std::array<Run, 3>& runs) {
  add_row(values_.data(), columns_, runs.data(), runs.size(), real_.data(), imaginary_.data());
  const std::size_t used = runs[0].count + runs[1].count + runs[2].count;
  std::fill_n(real_.begin(), used, 0.0);
  std::fill_n(imaginary_.begin(), used, 0.0);
}

}  // namespace jointid::ident
