#include "ident/likelihood/line/lane_matrix.hpp"

#include "base/kernel.hpp"

namespace jointid::ident {
namespace {

/// Columns of real parts and, `stride` numbers after each, of imaginary ones.
template <class Number>
struct Columns {
  Number* data;
  std::size_t stride;
};

/// b(k, j) at k · down + j · along, and `imaginary` numbers after it the imaginary part; signs of both parts.
struct Numbers {
  const double* data;
  std::size_t down, along, imaginary;
  double re_sign, im_sign;
};

/// `lanes` rows of N columns of C; `turns`: the sign of the imaginary parts of A.
template <std::size_t lanes, std::size_t N>
JOINTID_INLINE void add_rows(const Columns<double>& c, const Columns<const double>& a, double turns, const Numbers& b,
                             std::size_t depth) {
  Lanes<lanes> re[N], im[N];
  for (std::size_t j = 0; j < N; ++j) {
    load(c.data + 2 * j * c.stride, re[j]);
    load(c.data + (2 * j + 1) * c.stride, im[j]);
  }
  for (std::size_t k = 0; k < depth; ++k) {
    Lanes<lanes> a_re, a_im;
    load(a.data + 2 * k * a.stride, a_re);
    load(a.data + (2 * k + 1) * a.stride, a_im);
    for (std::size_t j = 0; j < N; ++j) {
      const double* const number = b.data + k * b.down + j * b.along;
      const double b_re = b.re_sign * number[0], b_im = b.im_sign * number[b.imaginary];
      re[j] += a_re * b_re - a_im * (turns * b_im);
      im[j] += a_re * b_im + a_im * (turns * b_re);
    }
  }
  for (std::size_t j = 0; j < N; ++j) {
    store(re[j], c.data + 2 * j * c.stride);
    store(im[j], c.data + (2 * j + 1) * c.stride);
  }
}

template <std::size_t machine_lanes>
JOINTID_INLINE void add_lanes(const Columns<double>& c, std::size_t columns, const Columns<const double>& a, double turns,
                              const Numbers& b, std::size_t depth) {
  constexpr std::size_t lanes = machine_lanes < 4 ? machine_lanes : 4;
  const std::size_t rows = c.stride;
  for (std::size_t i = 0; i < rows; i += lanes) {
    std::size_t j = 0;
    const auto of_column = [&](std::size_t first) {
      return Numbers{b.data + first * b.along, b.down, b.along, b.imaginary, b.re_sign, b.im_sign};
    };
    for (; j + 2 <= columns; j += 2) {
      add_rows<lanes, 2>({c.data + 2 * j * c.stride + i, c.stride}, {a.data + i, a.stride}, turns, of_column(j), depth);
    }
    if (j < columns)
      add_rows<lanes, 1>({c.data + 2 * j * c.stride + i, c.stride}, {a.data + i, a.stride}, turns, of_column(j), depth);
  }
}

JOINTID_KERNEL_OF_LANES(void add_columns,
                        (const Columns<double>& c, std::size_t columns, const Columns<const double>& a, double turns,
                         const Numbers& b, std::size_t depth),
                        add_lanes, (c, columns, a, turns, b, depth))

}  // namespace

void LaneMatrix::add_product(const Factor& left, const Factor& right, double sign) {
  const LaneMatrix &a = *left.of, &b = *right.of;
  const std::size_t one_down = right.transposed ? 2 * b.stride_ : 1, one_along = right.transposed ? 1 : 2 * b.stride_;
  const Numbers numbers{b.values_.data(), one_down, one_along, b.stride_, sign, right.conjugated ? -sign : sign};
  add_columns({values_.data(), stride_}, columns_, {a.values_.data(), a.stride_}, left.conjugated ? -1.0 : 1.0, numbers,
              a.columns_);
}

}  // namespace jointid::ident
