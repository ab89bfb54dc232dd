#include "ident/likelihood/observations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ident/chunk_pipeline.hpp"

namespace jointid::ident {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

/// 1/σ of both parts. No part is taken to be more than 10⁴ times as exact as the other, and no FRF exact to more than 8 digits:
/// weights beyond that say nothing that arithmetic could use.
Complex weight_of(const Complex& variance, const Complex& value) {
  const double larger = std::max(variance.real(), variance.imag());
  const double least = std::max(1e-8 * larger, 1e-16 * std::norm(value));
  if (!(least > 0.0) || !std::isfinite(larger)) return 0.0;
  return {1.0 / std::sqrt(std::max(variance.real(), least)), 1.0 / std::sqrt(std::max(variance.imag(), least))};
}

bool zero(const Measured& m) { return m.value == Complex(0.0); }

double within_factor_two(double weight, double before) {
  return std::isfinite(weight) && weight > 0.0 ? std::clamp(weight, 0.5 * before, 2.0 * before) : before;
}

void replace_weight(Complex& weight, const Complex& now) {
  weight = {within_factor_two(now.real(), weight.real()), within_factor_two(now.imag(), weight.imag())};
}

/// Which elements some line has, except those that are zero on every line.
template <class Raws, class Get>
std::vector<std::size_t> present(const Raws& raws, std::size_t count, bool keep_unknown, Get get) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < count; ++i) {
    bool keep = false, all_zero = true;
    for (const auto& raw : raws) {
      const Measured m = get(raw, i);
      keep = keep || m.known();
      all_zero = all_zero && m.known() && zero(m);
    }
    if (!all_zero && (keep || keep_unknown)) chosen.push_back(i);
  }
  return chosen;
}

std::vector<Element> pick(const std::vector<Element>& all, const std::vector<std::size_t>& which) {
  std::vector<Element> out;
  for (const std::size_t i : which) out.push_back(all[i]);
  return out;
}

void append(Channel& channel, const Measured& m) {
  const bool known = m.known();
  channel.value.push_back(known ? m.value : Complex(0.0));
  channel.weight.push_back(known ? weight_of(m.variance, m.value) : Complex(0.0));
}

std::size_t count_measured(const Channel& channel) {
  std::size_t count = 0;
  for (const Complex& weight : channel.weight) count += (weight.real() > 0.0) + (weight.imag() > 0.0);
  return count;
}

}  // namespace

Observations::Observations(const Scene& scene, const Dofs& coordinates, std::size_t others, const LikelihoodBlocks& blocks,
                           frf::FrfSystem& substructures, frf::FrfSystem& assembly)
    : substructures_(substructures, scene, coordinates, others, blocks.substructures),
      assembly_(assembly, scene, coordinates, others, blocks.assembly),
      blocks_(blocks),
      background_(substructures.background(coordinates, coordinates)) {
  layout_.coordinates = coordinates;
  layout_.others = others;
  layout_.joint = coordinates.size() - others;
  for (std::size_t k = 0; k < others; ++k) {
    for (std::size_t p = 0; p < layout_.joint; ++p) all_jn_.push_back({p, k});
    for (std::size_t r = 0; r <= k; ++r) all_nn_.push_back({r, k});
  }
  for (std::size_t q = 0; q < layout_.joint; ++q) {
    for (std::size_t p = 0; p <= q; ++p) all_jj_.push_back({p, q});
  }
}

std::vector<FileVariances> Observations::origins() const {
  std::vector<FileVariances> all = substructures_.origins();
  const auto more = assembly_.origins();
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::size_t Observations::bytes() const {
  std::size_t total = 0;
  for (const Raw& raw : raw_) {
    for (const auto* part : {&raw.x, &raw.y, &raw.a, &raw.b, &raw.sub_nn, &raw.asm_nn}) total += part->capacity() * sizeof(Entry);
  }
  for (const LineData& line : data_) {
    for (const Channel* channel : {&line.x, &line.y, &line.a, &line.b, &line.d}) {
      total += (channel->value.capacity() + channel->weight.capacity()) * sizeof(Complex);
    }
  }
  return total;
}

void Observations::append(const SymmetricFrfs& from, std::size_t i, bool substructures, Raw& raw) const {
  const std::size_t n = layout_.others;
  const auto entry = [&](std::size_t row, std::size_t column) {
    return Entry{from.at(i, row, column), from.averaged(i, row, column)};
  };
  const Blocks& blocks = substructures ? blocks_.substructures : blocks_.assembly;
  for (const auto [p, k] : all_jn_) (substructures ? raw.x : raw.a).push_back(blocks.jn ? entry(n + p, k) : Entry{{nan, nan}});
  for (const auto [p, q] : all_jj_) {
    (substructures ? raw.y : raw.b).push_back(blocks.jj ? entry(n + p, n + q) : Entry{{nan, nan}});
  }
  for (const auto [r, k] : all_nn_) {
    (substructures ? raw.sub_nn : raw.asm_nn).push_back(blocks.nn ? entry(r, k) : Entry{{nan, nan}});
  }
}

void Observations::read(const std::vector<Line>& lines, const std::function<void(std::size_t)>& between) {
  plan_lines_ = lines;
  raw_.clear();
  data_.clear();
  const std::size_t chunk = std::max<std::size_t>(1, chunk_lines(entries_per_line()) / 4);
  std::vector<std::size_t> substructure_lines, assembly_lines;
  for (std::size_t first = 0; first < lines.size(); first += chunk) {
    between(first);
    substructure_lines.clear();
    assembly_lines.clear();
    for (std::size_t i = first; i < std::min(first + chunk, lines.size()); ++i) {
      substructure_lines.push_back(lines[i].substructures);
      assembly_lines.push_back(lines[i].assembly);
    }
    substructures_.read(substructure_lines);
    assembly_.read(assembly_lines);
    for (std::size_t i = 0; i < substructure_lines.size(); ++i) {
      Raw& raw = raw_.emplace_back();
      append(substructures_, i, true, raw);
      append(assembly_, i, false, raw);
    }
  }
  choose_layout();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    data_.push_back(data_of(raw_[i], 2.0 * std::numbers::pi * lines[i].frequency_hz));
  }
}

void Observations::choose_layout() {
  const std::size_t n = layout_.others, size = layout_.coordinates.size();
  const auto unless_apart = [&](const Measured& m, std::size_t row, std::size_t column) {
    return background_[row * size + column] == Complex(0.0) ? Measured{0.0, 0.0} : m;
  };
  x_of_ = present(raw_, all_jn_.size(), true, [&](const Raw& raw, std::size_t i) {
    return unless_apart(raw.x[i].measured, n + all_jn_[i].row, all_jn_[i].column);
  });
  y_of_ = present(raw_, all_jj_.size(), true, [&](const Raw& raw, std::size_t i) {
    return unless_apart(raw.y[i].measured, n + all_jj_[i].row, n + all_jj_[i].column);
  });
  a_of_ = present(raw_, all_jn_.size(), false, [](const Raw& raw, std::size_t i) { return raw.a[i].measured; });
  b_of_ = present(raw_, all_jj_.size(), false, [](const Raw& raw, std::size_t i) { return raw.b[i].measured; });
  d_of_ = present(raw_, all_nn_.size(), false, [](const Raw& raw, std::size_t i) {
    return raw.sub_nn[i].measured.known() ? raw.asm_nn[i].measured : Measured{nan, nan};
  });
  layout_.x = pick(all_jn_, x_of_);
  layout_.y = pick(all_jj_, y_of_);
  layout_.a = pick(all_jn_, a_of_);
  layout_.b = pick(all_jj_, b_of_);
  layout_.d = pick(all_nn_, d_of_);
  layout_.x_first.assign(layout_.others + 1, 0);
  for (const Element& e : layout_.x) ++layout_.x_first[e.column + 1];
  for (std::size_t k = 0; k < layout_.others; ++k) layout_.x_first[k + 1] += layout_.x_first[k];
}

LineData Observations::data_of(const Raw& raw, double omega) const {
  LineData data;
  data.omega = omega;
  using ident::append;
  for (const std::size_t i : x_of_) append(data.x, raw.x[i].measured);
  for (const std::size_t i : y_of_) append(data.y, raw.y[i].measured);
  for (const std::size_t i : a_of_) append(data.a, raw.a[i].measured);
  for (const std::size_t i : b_of_) append(data.b, raw.b[i].measured);
  for (const std::size_t i : d_of_) {
    const Measured &sub = raw.sub_nn[i].measured, &whole = raw.asm_nn[i].measured;
    const bool known = sub.known() && whole.known();
    append(data.d, known ? Measured{sub.value - whole.value, sub.variance + whole.variance} : Measured{nan, nan});
  }
  for (const Channel* channel : {&data.x, &data.y, &data.a, &data.b, &data.d}) data.measured += count_measured(*channel);
  return data;
}

void Observations::weigh_at(std::size_t line, const LineState& state, const ComplexMatrix& z) {
  const Raw& raw = raw_[line];
  const LineData first = data_of(raw, data_[line].omega);
  LineData& data = data_[line];
  const std::size_t n = layout_.others, size = layout_.coordinates.size();
  std::vector<Complex> sub(size * size, nan), whole(size * size, nan);
  const auto set = [&](std::vector<Complex>& matrix, std::size_t row, std::size_t column, const Complex& value) {
    matrix[row * size + column] = matrix[column * size + row] = value;
  };
  for (const std::size_t i : x_of_) {
    const auto [p, k] = all_jn_[i];
    if (raw.x[i].measured.known()) set(sub, n + p, k, state.x(at(p), at(k)));
  }
  for (const std::size_t i : y_of_) {
    const auto [p, q] = all_jj_[i];
    if (raw.y[i].measured.known()) set(sub, n + p, n + q, state.y(at(p), at(q)));
  }
  for (const std::size_t i : a_of_) {
    const auto [p, k] = all_jn_[i];
    if (raw.a[i].measured.known()) set(whole, n + p, k, state.a(at(p), at(k)));
  }
  for (const std::size_t i : b_of_) {
    const auto [p, q] = all_jj_[i];
    if (raw.b[i].measured.known()) set(whole, n + p, n + q, state.b(at(p), at(q)));
  }
  const ComplexMatrix za = z * state.a;
  for (std::size_t e = 0; e < d_of_.size(); ++e) {
    const Measured &s = raw.sub_nn[d_of_[e]].measured, &w = raw.asm_nn[d_of_[e]].measured;
    if (!s.known() || !w.known()) continue;
    const auto [r, k] = layout_.d[e];
    // The residual of D is shared out by the variances.
    const Complex residual = first.d.value[e] - predicted_difference(state, za, layout_.d[e]), total = s.variance + w.variance;
    const Complex of_sub(total.real() > 0.0 ? residual.real() * s.variance.real() / total.real() : 0.0,
                         total.imag() > 0.0 ? residual.imag() * s.variance.imag() / total.imag() : 0.0);
    set(sub, r, k, s.value - of_sub);
    set(whole, r, k, w.value + (residual - of_sub));
  }
  substructures_.variances_of(plan_lines_[line].substructures, sub);
  assembly_.variances_of(plan_lines_[line].assembly, whole);
  data = first;
  const auto again = [&](const SymmetricFrfs& system, const std::vector<Complex>& values, std::size_t row, std::size_t column,
                         bool averaged) {
    return weight_of(system.variance(row, column, averaged), values[row * size + column]);
  };
  for (std::size_t e = 0; e < x_of_.size(); ++e) {
    const auto [p, k] = layout_.x[e];
    if (raw.x[x_of_[e]].measured.known()) replace_weight(data.x.weight[e], again(substructures_, sub, n + p, k, raw.x[x_of_[e]].averaged));
  }
  for (std::size_t e = 0; e < y_of_.size(); ++e) {
    const auto [p, q] = layout_.y[e];
    if (raw.y[y_of_[e]].measured.known()) replace_weight(data.y.weight[e], again(substructures_, sub, n + p, n + q, raw.y[y_of_[e]].averaged));
  }
  for (std::size_t e = 0; e < a_of_.size(); ++e) {
    const auto [p, k] = layout_.a[e];
    if (raw.a[a_of_[e]].measured.known()) replace_weight(data.a.weight[e], again(assembly_, whole, n + p, k, raw.a[a_of_[e]].averaged));
  }
  for (std::size_t e = 0; e < b_of_.size(); ++e) {
    const auto [p, q] = layout_.b[e];
    if (raw.b[b_of_[e]].measured.known()) replace_weight(data.b.weight[e], again(assembly_, whole, n + p, n + q, raw.b[b_of_[e]].averaged));
  }
  for (std::size_t e = 0; e < d_of_.size(); ++e) {
    const Entry &s = raw.sub_nn[d_of_[e]], &w = raw.asm_nn[d_of_[e]];
    if (!s.measured.known() || !w.measured.known()) continue;
    const auto [r, k] = layout_.d[e];
    const Complex total = (zero(s.measured) ? Complex(0.0) : substructures_.variance(r, k, s.averaged)) +
                          assembly_.variance(r, k, w.averaged);
    replace_weight(data.d.weight[e], weight_of(total, sub[r * size + k] - whole[r * size + k]));
  }
}

}  // namespace jointid::ident
