#include "ident/likelihood/rows/element_rows.hpp"

#include <algorithm>
#include <cstring>

#include "base/kernel.hpp"

namespace jointid::ident {
namespace {

/// Of `lanes` elements.
template <std::size_t lanes>
struct Numbers {
  Lanes<lanes> re, im;
};

template <std::size_t lanes>
JOINTID_INLINE void number(const double* from, std::size_t i, Numbers<lanes>& to) {
  load(from + 2 * i * lanes, to.re);
  load(from + (2 * i + 1) * lanes, to.im);
}

template <std::size_t lanes>
JOINTID_INLINE void add_product(const Numbers<lanes>& a, const Numbers<lanes>& b, Numbers<lanes>& to) {
  to.re += a.re * b.re - a.im * b.im;
  to.im += a.re * b.im + a.im * b.re;
}

/// `lanes` numbers one after the other of each value of the table.
template <std::size_t lanes>
JOINTID_INLINE void gather(const double* table, const std::uint32_t* which, std::size_t numbers, double* to) {
  if (std::all_of(which + 1, which + lanes, [&](std::uint32_t each) { return each == which[0]; })) {
    const double* const from = table + which[0] * numbers;
    for (std::size_t i = 0; i < numbers; ++i) {
      const Lanes<lanes> all = from[i] - Lanes<lanes>{};
      store(all, to + i * lanes);
    }
    return;
  }
  for (std::size_t e = 0; e < lanes; ++e) {
    const double* const from = table + which[e] * numbers;
    for (std::size_t i = 0; i < numbers; ++i) to[i * lanes + e] = from[i];
  }
}

/// Where the weighted rows of `lanes` elements go: real parts, and `imaginary` numbers after them the imaginary ones.
template <std::size_t lanes>
struct Place {
  double* data;
  std::size_t stride, imaginary;
  Numbers<lanes> weight;
};

/// An unknown that is real.
template <std::size_t lanes>
JOINTID_INLINE void put_real(const Place<lanes>& to, std::size_t column, const Numbers<lanes>& c) {
  const Lanes<lanes> re = to.weight.re * c.re, im = to.weight.im * c.im;
  double* const data = to.data + column * to.stride;
  store(re, data);
  store(im, data + to.imaginary);
}

/// Both parts of an FRF.
template <std::size_t lanes>
JOINTID_INLINE void put_both(const Place<lanes>& to, std::size_t column, const Numbers<lanes>& c) {
  const Numbers<lanes> turned{-c.im, c.re};
  put_real(to, column, c);
  put_real(to, column + 1, turned);
}

template <std::size_t lanes>
JOINTID_INLINE void put_y(const RowShape& shape, const double* l, const double* g, const Place<lanes>& to) {
  for (std::size_t q = 0; q < shape.y_row.size(); ++q) {
    const std::size_t i = shape.y_row[q], j = shape.y_column[q];
    Numbers<lanes> l_i, l_j, g_i, g_j, sum{};
    number(l, i, l_i);
    number(g, j, g_j);
    add_product(l_i, g_j, sum);
    if (i != j) {
      number(l, j, l_j);
      number(g, i, g_i);
      add_product(l_j, g_i, sum);
    }
    const Numbers<lanes> change{-sum.re, -sum.im};
    put_both(to, 2 * q, change);
  }
}

template <std::size_t lanes>
JOINTID_INLINE void put_unknowns(const RowShape& shape, const double* lambda, const double* a, std::size_t first,
                                 const Place<lanes>& to) {
  for (const restrictions::ImpedanceShape& each : shape.shapes) {
    Numbers<lanes> sum{};
    for (std::size_t t = each.first_term; t < each.last_term; ++t) {
      const restrictions::ImpedanceTerm& term = shape.terms[t];
      Numbers<lanes> left, right;
      number(lambda, term.row, left);
      number(a, term.column, right);
      left.re *= term.coefficient;
      left.im *= term.coefficient;
      add_product(left, right, sum);
    }
    for (std::size_t i = each.first_part; i < each.last_part; ++i) {
      const auto& [factor, unknown] = shape.parts[i];
      const Numbers<lanes> derivative{factor.real() * sum.re - factor.imag() * sum.im,
                                      factor.real() * sum.im + factor.imag() * sum.re};
      put_real(to, first + unknown, derivative);
    }
  }
}

template <std::size_t lanes>
JOINTID_INLINE void put_run(std::span<const std::uint32_t> run, const double* l, const double* g, const double* by_left,
                            const double* by_right, const Place<lanes>& to) {
  Lanes<lanes> with_l, with_g;
  load(by_left, with_l);
  load(by_right, with_g);
  for (std::size_t i = 0; i < run.size(); ++i) {
    Numbers<lanes> of_l, of_g;
    number(l, run[i], of_l);
    number(g, run[i], of_g);
    const Numbers<lanes> sum{with_l * of_l.re + with_g * of_g.re, with_l * of_l.im + with_g * of_g.im};
    put_both(to, 2 * i, sum);
  }
}

template <std::size_t lanes>
JOINTID_INLINE double total(const Lanes<lanes>& of) {
  if constexpr (lanes == 2) {
    return of[0] + of[1];
  } else {
    Lanes<lanes / 2> halves[2];
    std::memcpy(&halves, &of, sizeof(of));
    const Lanes<lanes / 2> sum = halves[0] + halves[1];
    return total<lanes / 2>(sum);
  }
}

template <std::size_t lanes, std::size_t M, std::size_t N>
JOINTID_INLINE void dots(double* c, std::size_t stride, const RowColumns& a, const RowColumns& b, std::size_t rows) {
  Lanes<lanes> sum[M][N] = {};
  for (std::size_t r = 0; r < rows; r += lanes) {
    Lanes<lanes> right[N];
    for (std::size_t j = 0; j < N; ++j) load(b.data + j * b.stride + r, right[j]);
    for (std::size_t i = 0; i < M; ++i) {
      Lanes<lanes> left;
      load(a.data + i * a.stride + r, left);
      for (std::size_t j = 0; j < N; ++j) sum[i][j] += left * right[j];
    }
  }
  for (std::size_t i = 0; i < M; ++i) {
    for (std::size_t j = 0; j < N; ++j) c[i * stride + j] += total<lanes>(sum[i][j]);
  }
}

template <std::size_t lanes, std::size_t M>
JOINTID_INLINE void column_dots(double* c, std::size_t stride, const RowColumns& a, const RowColumns& b, std::size_t first,
                                std::size_t n, std::size_t rows) {
  std::size_t j = first;
  for (; j + 2 <= n; j += 2) dots<lanes, M, 2>(c + j, stride, a, {b.data + j * b.stride, b.stride}, rows);
  if (j < n) dots<lanes, M, 1>(c + j, stride, a, {b.data + j * b.stride, b.stride}, rows);
}

/// From the diagonal on, or all.
template <std::size_t lanes>
JOINTID_INLINE void all_dots(const RowColumns& c, const RowColumns& a, std::size_t m, const RowColumns& b, std::size_t n,
                             std::size_t rows, bool lower) {
  std::size_t i = 0;
  for (; i + 4 <= m; i += 4) {
    column_dots<lanes, 4>(c.data + i * c.stride, c.stride, {a.data + i * a.stride, a.stride}, b, lower ? i : 0, n, rows);
  }
  for (; i < m; ++i)
    column_dots<lanes, 1>(c.data + i * c.stride, c.stride, {a.data + i * a.stride, a.stride}, b, lower ? i : 0, n, rows);
}

template <std::size_t lanes>
JOINTID_INLINE void write_lanes(const RowShape& shape, const ElementTables& tables, const ElementGroup& group,
                                std::span<const std::uint32_t> run, RowColumns tails, RowColumns heads, double* room) {
  const std::size_t numbers = tables.numbers(), each = 2 * tables.joint * lanes;
  double* const left = room;
  double* const right = room + lanes * numbers;
  for (std::size_t e = 0; e < group.count; e += lanes) {
    gather<lanes>(tables.left, group.left + e, numbers, left);
    gather<lanes>(tables.right, group.right + e, numbers, right);
    const double *l = left, *lambda = left + each, *x = left + 2 * each, *g = right, *a = right + each, *r = right + 2 * each;
    Numbers<lanes> off{}, weight;
    for (std::size_t i = 0; i < tables.joint; ++i) {
      Numbers<lanes> x_i, g_i, l_i, r_i;
      number(x, i, x_i);
      number(g, i, g_i);
      number(l, i, l_i);
      number(r, i, r_i);
      add_product(x_i, g_i, off);
      add_product(l_i, r_i, off);
    }
    Numbers<lanes> base;
    load(group.base_re + e, base.re);
    load(group.base_im + e, base.im);
    const Numbers<lanes> residual{base.re - off.re, base.im - off.im};
    load(group.weight_re + e, weight.re);
    load(group.weight_im + e, weight.im);
    const Place<lanes> tail{tails.data + e, tails.stride, group.count, weight},
        head{heads.data + e, heads.stride, group.count, weight};
    put_y(shape, l, g, tail);
    put_unknowns(shape, lambda, a, 2 * shape.y_row.size(), tail);
    put_real(tail, shape.residual(), residual);
    put_run(run, l, g, group.by_left + e, group.by_right + e, head);
  }
}

template <std::size_t lanes>
JOINTID_INLINE void dot_lanes(RowColumns c, RowColumns a, std::size_t m, RowColumns b, std::size_t n, std::size_t rows) {
  all_dots<lanes>(c, a, m, b, n, rows, false);
}

template <std::size_t lanes>
JOINTID_INLINE void dot_lower_lanes(RowColumns c, RowColumns a, std::size_t m, std::size_t rows) {
  all_dots<lanes>(c, a, m, a, m, rows, true);
}

}  // namespace

JOINTID_KERNEL_OF_LANES(void write_rows,
                        (const RowShape& shape, const ElementTables& tables, const ElementGroup& group,
                         std::span<const std::uint32_t> run, RowColumns tails, RowColumns heads, double* room),
                        write_lanes, (shape, tables, group, run, tails, heads, room))
JOINTID_KERNEL_OF_LANES(void add_dots, (RowColumns c, RowColumns a, std::size_t m, RowColumns b, std::size_t n, std::size_t rows),
                        dot_lanes, (c, a, m, b, n, rows))
JOINTID_KERNEL_OF_LANES(void add_dots_lower, (RowColumns c, RowColumns a, std::size_t m, std::size_t rows), dot_lower_lanes,
                        (c, a, m, rows))

JOINTID_KERNEL void put_cross(RowColumns c, const double* g, std::span<const std::uint32_t> first, const double* l,
                              std::span<const std::uint32_t> second, double square_re, double square_im) {
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::size_t at_first = 2 * std::size_t{first[i]};
    const double g_re = g[at_first], g_im = g[at_first + 1];
    double* const of_re = c.data + 2 * i * c.stride;
    double* const of_im = of_re + c.stride;
    for (std::size_t j = 0; j < second.size(); ++j) {
      const std::size_t at_second = 2 * std::size_t{second[j]};
      const double l_re = l[at_second], l_im = l[at_second + 1];
      of_re[2 * j] = square_re * g_re * l_re + square_im * g_im * l_im;
      of_re[2 * j + 1] = square_im * g_im * l_re - square_re * g_re * l_im;
      of_im[2 * j] = square_im * g_re * l_im - square_re * g_im * l_re;
      of_im[2 * j + 1] = square_re * g_im * l_im + square_im * g_re * l_re;
    }
  }
}

}  // namespace jointid::ident
