#include "ident/equations/line_assembler.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <unordered_map>

#include "base/complex.hpp"
#include "weighting/delta_filter.hpp"

namespace jointid::ident {
namespace {

bool finite(const Complex& value) { return std::isfinite(value.real()) && std::isfinite(value.imag()); }

/// Largest modulus of `count` elements, 0 when one of them is not measured: such an equation cannot be used.
double largest(const Complex* first, std::size_t count, std::size_t step) {
  double square = 0.0;
  bool measured = true;
  for (std::size_t i = 0; i < count; ++i) {
    const double norm = std::norm(first[i * step]);
    measured = measured && std::isfinite(norm);
    square = std::max(square, norm);
  }
  return measured ? std::sqrt(square) : 0.0;
}

/// Whether compressing a product is cheaper than writing out its equations, by counted flops.
bool worth_compressing(std::size_t m, std::size_t l, std::size_t na, std::size_t nb, std::size_t unknowns) {
  const auto flops = [](std::size_t count) { return static_cast<double>(count); };
  const double per_equation = 8.0 * flops(na * nb) + 4.0 * flops(unknowns * unknowns);
  const std::size_t p = std::min(m, na), q = std::min(l, nb);
  const double factor = 16.0 * flops(m * na * na + l * nb * nb) + 8.0 * flops(m * l * p + l * p * q);
  return factor + per_equation * flops(p * q) < per_equation * flops(m * l);
}

}  // namespace

void make_expanders(AssemblySpec& spec) {
  spec.expanders.clear();
  for (const Support& support : spec.supports) {
    spec.expanders.emplace_back(*spec.restriction, support.a_dofs, support.b_dofs, support.unknowns, spec.omega0);
  }
}

LineAssembler::LineAssembler(const AssemblySpec& spec, bool measures_rounding, RoundingScale* shared)
    : spec_(spec), measures_rounding_(measures_rounding), shared_rounding_(shared), expanders_(spec.expanders) {
  if (!spec.is_of_part) return;
  a_places_.resize(spec.supports.front().a_dofs.size());
  b_places_.resize(spec.supports.front().b_dofs.size());
  std::iota(a_places_.begin(), a_places_.end(), std::size_t{0});
  std::iota(b_places_.begin(), b_places_.end(), std::size_t{0});
}

SubProduct LineAssembler::sub_product(const Group& group) const {
  const Support& support = spec_.supports[group.support];
  return {.a_dofs = spec_.is_of_part ? a_places_ : support.a_dofs,
          .b_dofs = spec_.is_of_part ? b_places_ : support.b_dofs,
          .rows = group.rows,
          .columns = group.columns,
          .row_weight = group.row_weight,
          .column_weight = group.column_weight};
}

/// False for a line in no band of some joint. Of the columns of all unknowns, which may be many, those of the supports stay.
bool LineAssembler::find_columns(double frequency_hz) {
  const std::vector<std::size_t> all = spec_.columns->at(frequency_hz);
  columns_.resize(spec_.supports.size());
  for (std::size_t s = 0; s < columns_.size() && !all.empty(); ++s) {
    columns_[s].clear();
    for (const std::size_t unknown : spec_.supports[s].unknowns) columns_[s].push_back(all[unknown]);
  }
  return !all.empty();
}

void LineAssembler::add(const minimise::LineProduct& line, minimise::Accumulator& accumulator) {
  if (!find_columns(line.frequency_hz)) return;
  measure(line);
  const std::size_t used_before = count_.used;
  const bool regular = mask(line);
  if (count_.used == used_before) return;
  ++lines_used_;
  weigh(line, regular);
  group(line, regular);
  factored_ = nullptr;
  for (RowExpander& expander : expanders_) expander.set_line(angular(line.frequency_hz));
  if (spec_.weighting == weighting::Weighting::wa) {
    push_weighted_after(line, accumulator);
  } else {
    for (std::size_t g = 0; g < group_count_; ++g) push(line, groups_[g], accumulator);
    if (measures_rounding_) measure_rounding(line, 1.0);
  }
}

void LineAssembler::measure_rounding(const minimise::LineProduct& line, double factor) {
  for (std::size_t g = 0; g < group_count_; ++g) {
    const Group& group = groups_[g];
    const Support& support = spec_.supports[group.support];
    RoundingScale& to = shared_rounding_ != nullptr ? *shared_rounding_ : rounding_;
    const std::size_t joint = spec_.is_of_part ? spec_.restriction->dofs.size() : line.b.rows;
    to.add(line, sub_product(group), factor, support.a_dofs, support.b_dofs, joint);
  }
}

void LineAssembler::measure(const minimise::LineProduct& line) {
  const std::size_t rows = line.row_class.size(), columns = line.column_class.size();
  row_max_.resize(rows);
  for (std::size_t m = 0; m < rows; ++m) {
    row_max_[m] = line.a_is_unit ? 1.0 : largest(line.a.data + m * line.a.stride, line.a.columns, 1);
  }
  column_max_.resize(columns);
  for (std::size_t l = 0; l < columns; ++l) column_max_[l] = largest(line.b.data + l, line.b.rows, line.b.stride);
}

/// Decides which equations are in use; true when all are, so that no mask is needed.
bool LineAssembler::mask(const minimise::LineProduct& line) {
  const std::size_t rows = row_max_.size(), columns = column_max_.size();
  const auto positive = [](double value) { return value > 0.0; };
  const bool all_wanted = line.wanted[0][0] && line.wanted[0][1] && line.wanted[1][0] && line.wanted[1][1];
  const bool one_class = line.row_class.front() == line.row_class.back();
  const std::uint8_t row_class = line.row_class.front();
  const bool rectangle = all_wanted || (one_class && line.wanted[row_class][line.column_class.front()] &&
                                        line.wanted[row_class][line.column_class.back()]);
  if (rectangle && spec_.delta == 0.0 && std::all_of(row_max_.begin(), row_max_.end(), positive) &&
      std::all_of(column_max_.begin(), column_max_.end(), positive) && right_side_is_finite(line)) {
    count_.used += rows * columns;
    return true;
  }
  keep_.assign(rows * columns, 1);
  std::size_t used = 0, wanted = 0;
  for (std::size_t m = 0; m < rows; ++m) {
    for (std::size_t l = 0; l < columns; ++l) {
      if (!line.wanted[line.row_class[m]][line.column_class[l]]) {
        keep_[m * columns + l] = 0;
        continue;
      }
      ++wanted;
      const Complex& c1 = line.c1(m, l);
      const Complex& c2 = line.c2(m, l);
      const bool usable = row_max_[m] > 0.0 && column_max_[l] > 0.0 && finite(c1) && finite(c2) &&
                          !weighting::drops(spec_.delta, c1, c2);
      keep_[m * columns + l] = usable;
      used += usable;
    }
  }
  count_.used += used;
  count_.dropped += wanted - used;
  return used == rows * columns;
}

void LineAssembler::weigh(const minimise::LineProduct& line, bool regular) {
  const weighting::LineShape shape{.row_max = row_max_,
                                   .column_max = column_max_,
                                   .column_class = line.column_class,
                                   .keep = regular ? std::span<const std::uint8_t>() : keep_};
  weighting::line_weights(spec_.weighting, shape, weights_);
}

/// Covers the equations in use by products: columns with the same mask (and support) share one.
void LineAssembler::group(const minimise::LineProduct& line, bool regular) {
  const std::size_t rows = row_max_.size(), columns = column_max_.size();
  group_count_ = 0;
  // With a mask, the factor of a WBG group depends on row and named equation together and is no product of the two.
  const bool split_by_class = !regular && spec_.weighting == weighting::Weighting::wbg;
  std::unordered_map<std::string, std::size_t> known;
  std::string key;
  std::vector<std::size_t> group_of_support(spec_.supports.size(), static_cast<std::size_t>(-1));
  for (std::size_t l = 0; l < columns; ++l) {
    const std::size_t support = spec_.column_support[l];
    std::size_t* found = &group_of_support[support];
    if (!regular) {
      key.clear();
      for (std::size_t m = 0; m < rows; ++m) key.push_back(keep_[m * columns + l] ? '1' : '0');
      if (key.find('1') == std::string::npos) continue;
      key += split_by_class && line.column_class[l] ? 'j' : 'n';
      key += std::to_string(support);
      found = &known.try_emplace(key, static_cast<std::size_t>(-1)).first->second;
    }
    if (*found == static_cast<std::size_t>(-1)) {
      *found = group_count_++;
      if (groups_.size() < group_count_) groups_.emplace_back();
      Group& fresh = groups_[*found];
      fresh.support = support;
      fresh.rows.clear();
      fresh.columns.clear();
      fresh.row_weight.clear();
      fresh.column_weight.clear();
      for (std::size_t m = 0; m < rows; ++m) {
        if (!regular && !keep_[m * columns + l]) continue;
        fresh.rows.push_back(m);
        fresh.row_weight.push_back(weights_.row[line.column_class[l] * rows + m]);
      }
    }
    groups_[*found].columns.push_back(l);
    groups_[*found].column_weight.push_back(weights_.column[l]);
  }
}

void LineAssembler::compress(const minimise::LineProduct& line, const Group& group) {
  const Support& support = spec_.supports[group.support];
  const SubProduct part = sub_product(group);
  if (worth_compressing(group.rows.size(), group.columns.size(), support.a_dofs.size(), support.b_dofs.size(),
                        support.unknowns.size())) {
    const bool same_a = factored_ != nullptr && factored_->rows == group.rows && factored_->row_weight == group.row_weight &&
                        spec_.supports[factored_->support].a_dofs == support.a_dofs;
    compressor_.compress(line, part, same_a, compressed_);
    factored_ = &group;
  } else {
    KroneckerCompressor::copy(line, part, compressed_);
    factored_ = nullptr;
  }
}

/// Room for rows of a group, real or complex.
LineAssembler::Rows LineAssembler::append(const Group& group, std::size_t equations, minimise::Accumulator& accumulator) {
  const minimise::Accumulator::Columns& columns = columns_[group.support];
  const RowExpander& expander = expanders_[group.support];
  count_.rows += 2 * equations;
  if (is_complex(group, accumulator)) {
    minimise::ComplexTriangle& triangle =
        accumulator.complex_triangle(columns, expander.pair()->stiffness, expander.pair()->damping);
    return {triangle.append(equations), triangle.stride(), equations};
  }
  minimise::Triangle& triangle = accumulator.triangle(columns);
  return {triangle.append(2 * equations), triangle.stride(), 2 * equations};
}

bool LineAssembler::is_complex(const Group& group, const minimise::Accumulator& accumulator) const {
  return expanders_[group.support].pair() && accumulator.reduction() == minimise::Reduction::orthogonal;
}

void LineAssembler::expand(const Group& group, bool complex, std::size_t first, std::size_t count, const Rows& to) {
  if (complex) {
    expanders_[group.support].expand_complex(compressed_, first, count, to.data, to.stride / 2);
  } else {
    expanders_[group.support].expand(compressed_, first, count, to.data, to.stride);
  }
}

void LineAssembler::push(const minimise::LineProduct& line, const Group& group, minimise::Accumulator& accumulator) {
  compress(line, group);
  const std::size_t equations = compressed_.ra.rows * compressed_.rb.rows;
  for (std::size_t first = 0; first < equations; first += RowExpander::most) {
    const std::size_t count = std::min(RowExpander::most, equations - first);
    expand(group, is_complex(group, accumulator), first, count, append(group, count, accumulator));
  }
}

/// Squared norms of the columns of the rows of a group, added up per unknown of the restriction.
void LineAssembler::add_column_norms(const Group& group, bool complex, const Rows& rows) {
  const Support& support = spec_.supports[group.support];
  group_norm2_.assign(rows.stride, 0.0);
  for (std::size_t i = 0; i < rows.count; ++i) {
    const double* row = rows.data + i * rows.stride;
    for (std::size_t u = 0; u < rows.stride; ++u) group_norm2_[u] += row[u] * row[u];
  }
  if (!complex) {
    for (std::size_t u = 0; u < support.unknowns.size(); ++u) norm2_[support.unknowns[u]] += group_norm2_[u];
    return;
  }
  const RowExpander::Pair& pair = *expanders_[group.support].pair();
  for (std::size_t u = 0; u < pair.stiffness.size(); ++u) {
    const double square = group_norm2_[u] + group_norm2_[rows.stride / 2 + u];
    norm2_[support.unknowns[pair.stiffness[u]]] += square;
    norm2_[support.unknowns[pair.damping[u]]] += square;
  }
}

/// WA: the factor 1/√(largest element of E₀ᵀE₀) is known only when all rows of the line are written. That matrix is positive
/// semidefinite, so its largest element is a squared column norm.
void LineAssembler::push_weighted_after(const minimise::LineProduct& line, minimise::Accumulator& accumulator) {
  norm2_.assign(spec_.restriction->unknowns.size(), 0.0);
  line_rows_.clear();
  for (std::size_t g = 0; g < group_count_; ++g) {
    compress(line, groups_[g]);
    const bool complex = is_complex(groups_[g], accumulator);
    const std::size_t unknowns = expanders_[groups_[g].support].unknowns();
    const std::size_t stride = complex ? 2 * minimise::ComplexTriangle::half(unknowns / 2) : unknowns + 1;
    const std::size_t equations = compressed_.ra.rows * compressed_.rb.rows, per_equation = complex ? 1 : 2;
    const std::size_t written = line_rows_.size();
    line_rows_.resize(written + per_equation * equations * stride, 0.0);
    for (std::size_t first = 0; first < equations; first += RowExpander::most) {
      const std::size_t count = std::min(RowExpander::most, equations - first);
      expand(groups_[g], complex, first, count,
             {line_rows_.data() + written + per_equation * first * stride, stride, per_equation * count});
    }
    add_column_norms(groups_[g], complex, {line_rows_.data() + written, stride, per_equation * equations});
    groups_[g].equations_written = equations;
    groups_[g].row_length = stride;
  }
  const double largest_square = *std::max_element(norm2_.begin(), norm2_.end());
  const double factor = largest_square > 0.0 ? 1.0 / std::sqrt(largest_square) : 0.0;
  const double* from = line_rows_.data();
  for (std::size_t g = 0; g < group_count_; ++g) {
    const Rows to = append(groups_[g], groups_[g].equations_written, accumulator);
    for (std::size_t i = 0; i < to.count; ++i, from += groups_[g].row_length) {
      for (std::size_t u = 0; u < groups_[g].row_length; ++u) to.data[i * to.stride + u] = factor * from[u];
    }
  }
  if (measures_rounding_) measure_rounding(line, factor);
}

}  // namespace jointid::ident
