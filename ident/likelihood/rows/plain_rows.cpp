#include "ident/likelihood/rows/plain_rows.hpp"

#include <algorithm>

#include "base/eigen.hpp"
#include "ident/likelihood/rows/normal_kernels.hpp"

namespace jointid::ident {
namespace {

std::uint32_t small(std::size_t i) { return static_cast<std::uint32_t>(i); }

/// Room for rows that are added up together, such that they stay in the cache.
constexpr std::size_t usual_rows = 512;

/// Columns of so many rows, not a power of two apart: these share the sets of a cache.
std::size_t apart(std::size_t rows) { return rows / kernel_width % 2 == 0 ? rows + kernel_width : rows; }

}  // namespace

PlainRows::PlainRows(const LineLayout& layout) : layout_(layout) {
  for (const auto [row, column] : layout.sub_jj) {
    y_row_.push_back(small(row));
    y_column_.push_back(small(column));
  }
  for (const Element& each : layout.sub_jn) x_row_.push_back(small(each.row));
  elements_ = layout.asm_jn.size() + layout.asm_jj.size() + layout.drop_nn.size();
  for (std::size_t k = 0; k < layout.others; ++k) add_group(small(k));
  if (!layout.asm_jj.empty()) add_group(no_run);
  for (std::size_t i = 0; i < layout.drop_nn.size(); ++i) {
    const auto [row, column] = layout.drop_nn[i];
    if (row != column) crosses_.push_back({small(layout.asm_jn.size() + layout.asm_jj.size() + i), small(row), small(column)});
  }
  for (const Group& group : groups_) {
    most_own_ = std::max(most_own_, group.own);
    most_more_ = std::max(most_more_, group.more);
  }
  stride_ = apart(std::max(usual_rows, 2 * most_own_));
  own_stride_ = apart(2 * most_own_);
  more_stride_ = apart(2 * most_more_);
}

/// Left numbers: rows of A, rows of B, columns of hᵀ; right ones: columns of X, columns of B.
void PlainRows::add_group(std::uint32_t run) {
  const std::uint32_t b_left = small(layout_.joint), d_left = small(layout_.asm_jj.empty() ? layout_.joint : 2 * layout_.joint);
  const std::uint32_t others = small(layout_.others);
  Group group{run, element_.size(), 0, 0};
  std::uint32_t element = 0;
  for (const auto [p, k] : layout_.asm_jn) {
    if (k == run) add_slot(element, small(p), run, 1.0, 0.0);
    ++element;
  }
  for (const auto [p, q] : layout_.asm_jj) {
    if (run == no_run) add_slot(element, b_left + small(p), others + small(q), 0.0, 0.0);
    ++element;
  }
  const std::uint32_t first_d = element;
  for (const auto [r, k] : layout_.drop_nn) {
    if (r == run) add_slot(element, d_left + run, small(k), r == k ? 1.0 : 0.0, 1.0);
    ++element;
  }
  group.own = fill_up(group.first);
  element = first_d;
  for (const auto [r, k] : layout_.drop_nn) {
    if (k == run && r != k) add_slot(element, d_left + small(r), run, 1.0, 0.0);
    ++element;
  }
  group.more = fill_up(group.first + group.own);
  groups_.push_back(group);
}

void PlainRows::add_slot(std::uint32_t element, std::uint32_t left, std::uint32_t right, double by_left, double by_right) {
  element_.push_back(element);
  left_.push_back(left);
  right_.push_back(right);
  by_left_.push_back(by_left);
  by_right_.push_back(by_right);
}

/// How many slots there are from the first on, with those that fill up.
std::size_t PlainRows::fill_up(std::size_t first) {
  while ((element_.size() - first) % kernel_width != 0) add_slot(small(elements_), left_.back(), right_.back(), 0.0, 0.0);
  return element_.size() - first;
}

void PlainRows::fill_tables(const LineState& state, const LineFactors& factors) {
  const Eigen::Index n = at(layout_.joint);
  const auto next = [n](double*& to, const auto& one, const auto& two, const auto& three) {
    Eigen::Map<Eigen::VectorXcd> out(reinterpret_cast<Complex*>(to), 3 * n);
    out.head(n) = one;
    out.segment(n, n) = two;
    out.tail(n) = three;
    to += 6 * n;
  };
  const std::size_t with_b = layout_.asm_jj.empty() ? 0 : layout_.joint;
  left_table_.resize(6 * layout_.joint * (layout_.joint + with_b + layout_.others));
  right_table_.resize(6 * layout_.joint * (layout_.others + with_b));
  const ComplexMatrix p = factors.p.transpose(), py = -factors.py.transpose();
  const Eigen::VectorXcd none = Eigen::VectorXcd::Zero(n);
  double* left = left_table_.data();
  for (Eigen::Index i = 0; i < n; ++i) next(left, p.col(i), py.col(i), none);
  for (Eigen::Index i = 0; i < at(with_b); ++i) next(left, -p.col(i), py.col(i), none);
  for (Eigen::Index r = 0; r < at(layout_.others); ++r) next(left, factors.h.col(r), factors.yh.col(r), state.sub_jn.col(r));
  double* right = right_table_.data();
  for (Eigen::Index k = 0; k < at(layout_.others); ++k) next(right, factors.za.col(k), state.asm_jn.col(k), factors.r.col(k));
  for (Eigen::Index q = 0; q < at(with_b); ++q) next(right, factors.c.col(q), state.asm_jj.col(q), -factors.rest_b.col(q));
}

void PlainRows::fill_elements(const LineData& data, const LineState& state) {
  weight_.clear();
  base_.clear();
  const auto append = [this](const std::vector<Element>& elements, const Channel& channel, const ComplexMatrix* now) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      weight_.push_back(channel.weight[i]);
      base_.push_back(channel.value[i] - (now ? (*now)(at(elements[i].row), at(elements[i].column)) : Complex(0.0)));
    }
  };
  append(layout_.asm_jn, data.asm_jn, &state.asm_jn);
  append(layout_.asm_jj, data.asm_jj, &state.asm_jj);
  append(layout_.drop_nn, data.drop_nn, nullptr);
  weight_.push_back(0.0);
  base_.push_back(0.0);
  for (std::vector<double>* each : {&weight_re_, &weight_im_, &base_re_, &base_im_}) each->resize(element_.size());
  for (std::size_t slot = 0; slot < element_.size(); ++slot) {
    const Complex weight = weight_[element_[slot]], base = base_[element_[slot]];
    weight_re_[slot] = weight.real();
    weight_im_[slot] = weight.imag();
    base_re_[slot] = base.real();
    base_im_[slot] = base.imag();
  }
}

ElementGroup PlainRows::group_of(std::size_t first, std::size_t count) const {
  return {count,
          left_.data() + first,
          right_.data() + first,
          weight_re_.data() + first,
          weight_im_.data() + first,
          base_re_.data() + first,
          base_im_.data() + first,
          by_left_.data() + first,
          by_right_.data() + first};
}

std::span<const std::uint32_t> PlainRows::rows_of(std::uint32_t run) const {
  if (run == no_run) return {};
  return std::span(x_row_).subspan(layout_.sub_jn_first[run], layout_.sub_jn_first[run + 1] - layout_.sub_jn_first[run]);
}

/// The columns of systematic errors, for the rows of `count` slots: measured values move with them, not predicted ones.
void PlainRows::put_terms(std::size_t first, std::size_t count, const RowShape& shape, const SystematicTerms& terms,
                          RowColumns tails) const {
  for (std::size_t u = 0; u < terms.unknowns; ++u) std::fill_n(tails.data + (shape.first_other() + u) * tails.stride, 2 * count, 0.0);
  const double* const residuals = tails.data + shape.residual() * tails.stride;
  const auto part = [](double weighted, double weight) { return weight == 0.0 ? 0.0 : weighted / weight; };
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t element = element_[first + i];
    if (element == elements_) continue;
    const double re = weight_re_[first + i], im = weight_im_[first + i];
    const Complex residual(part(residuals[i], re), part(residuals[count + i], im));
    const std::size_t place = layout_.variables() + element;
    for (std::size_t t = terms.first[place]; t < terms.first[place + 1]; ++t) {
      const Complex change = terms.terms[t].derivative(residual);
      double* const column = tails.data + (shape.first_other() + terms.terms[t].unknown) * tails.stride;
      column[i] -= re * change.real();
      column[count + i] -= im * change.imag();
    }
  }
}

/// The rows of a group; what they add to the columns of the FRFs X.
void PlainRows::add_runs(const Group& group, const RowShape& shape, const ElementTables& tables, const SystematicTerms* terms,
                         NormalRows& normal) {
  const std::span<const std::uint32_t> run = rows_of(group.run);
  const std::size_t tail = 2 * layout_.sub_jn.size(), columns = 2 * run.size(), stride = normal.stride();
  const RowColumns own{tails_.data() + rows_, stride_}, more{more_tails_.data(), more_stride_};
  const RowColumns own_heads{heads_.data(), own_stride_}, more_heads{more_heads_.data(), more_stride_};
  write_rows(shape, tables, group_of(group.first, group.own), run, own, own_heads, room_.data());
  if (terms) put_terms(group.first, group.own, shape, *terms, own);
  rows_ += 2 * group.own;
  if (columns == 0) return;
  write_rows(shape, tables, group_of(group.first + group.own, group.more), run, more, more_heads, room_.data());
  if (terms) put_terms(group.first + group.own, group.more, shape, *terms, more);
  const std::size_t first = 2 * layout_.sub_jn_first[group.run];
  const RowColumns below{normal.block(tail, first), stride}, diagonal{normal.block(first, first), stride};
  add_dots(below, own_heads, columns, own, shape.tail(), 2 * group.own);
  add_dots(below, more_heads, columns, more, shape.tail(), 2 * group.more);
  add_dots_lower(diagonal, own_heads, columns, 2 * group.own);
  add_dots_lower(diagonal, more_heads, columns, 2 * group.more);
}

void PlainRows::flush(std::size_t width, NormalRows& normal) {
  const std::size_t tail = 2 * layout_.sub_jn.size();
  add_dots_lower({normal.block(tail, tail), normal.stride()}, {tails_.data(), stride_}, width, rows_);
  rows_ = 0;
}

void PlainRows::add_to(NormalRows& normal, const LineData& data, const LineState& state, const LineFactors& factors,
                       const JointImpedance* joint, const SystematicTerms* terms) {
  fill_tables(state, factors);
  fill_elements(data, state);
  const std::size_t others = terms ? terms->unknowns : 0;
  RowShape shape{y_row_, y_column_, {}, {}, {}, others};
  if (joint) shape = {y_row_, y_column_, joint->terms(), joint->shapes(), joint->parts(), others};
  const ElementTables tables{layout_.joint, left_table_.data(), right_table_.data()};
  std::size_t longest = 0;
  for (std::size_t k = 0; k < layout_.others; ++k)
    longest = std::max(longest, layout_.sub_jn_first[k + 1] - layout_.sub_jn_first[k]);
  make_room(room_, 2 * kernel_width * tables.numbers());
  make_room(tails_, shape.tail() * stride_);
  make_room(more_tails_, shape.tail() * more_stride_);
  make_room(heads_, 2 * longest * own_stride_);
  make_room(more_heads_, 2 * longest * more_stride_);
  rows_ = 0;
  for (const Group& group : groups_) {
    if (rows_ + 2 * group.own > stride_) flush(shape.tail(), normal);
    add_runs(group, shape, tables, terms, normal);
  }
  flush(shape.tail(), normal);
  const std::size_t d_left = layout_.joint + (layout_.asm_jj.empty() ? 0 : layout_.joint);
  for (const auto [element, row, column] : crosses_) {
    const Complex weight = weight_[element];
    if (weight == Complex(0.0)) continue;
    const double *g = right_table_.data() + column * tables.numbers(), *l = left_table_.data() + (d_left + row) * tables.numbers();
    put_cross({normal.block(2 * layout_.sub_jn_first[column], 2 * layout_.sub_jn_first[row]), normal.stride()}, g, rows_of(row),
              l, rows_of(column), weight.real() * weight.real(), weight.imag() * weight.imag());
  }
}

}  // namespace jointid::ident
