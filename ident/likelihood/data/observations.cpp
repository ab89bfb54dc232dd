#include "ident/likelihood/data/observations.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "base/complex.hpp"
#include "base/statistics.hpp"
#include "ident/likelihood/data/choose_layout.hpp"
#include "ident/likelihood/line/frf_weight.hpp"
#include "ident/result/chunk_pipeline.hpp"

namespace jointid::ident {
namespace {

void reserve(Channel& channel, std::size_t count) {
  channel.value.reserve(count);
  channel.weight.reserve(count);
}

void append(Channel& channel, const Measured& m) {
  channel.value.push_back(m.known() ? m.value : Complex(0.0));
  channel.weight.push_back(m.known() ? frf_weight(m.variance, m.value) : Complex(0.0));
}

std::size_t count_measured(const Channel& channel) {
  std::size_t count = 0;
  for (const Complex& weight : channel.weight) count += (weight.real() > 0.0 ? 1U : 0U) + (weight.imag() > 0.0 ? 1U : 0U);
  return count;
}

/// Variances of both parts by their weights; 0 where one has none.
Complex variance_of(const Complex& weight) {
  const bool known = weight.real() > 0.0 && weight.imag() > 0.0;
  return known ? Complex(1.0 / (weight.real() * weight.real()), 1.0 / (weight.imag() * weight.imag())) : Complex(0.0);
}

/// What the headers of a system's files promise of the blocks that are read: 1 where an FRF or its transpose is there, else unknown.
MeasuredFrfs promised_frfs(const frf::FrfSystem& system, const Dofs& coordinates, std::size_t others, const Blocks& blocks) {
  MeasuredFrfs out(coordinates.size(), {nan, nan});
  const auto has = [&](std::size_t response, std::size_t reference) {
    return frf::has(system.responses(), coordinates[response]) && frf::has(system.references(), coordinates[reference]);
  };
  for (std::size_t row = 0; row < coordinates.size(); ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      const bool is_read = row < others ? blocks.nn : column < others ? blocks.jn : blocks.jj;
      if (is_read && (has(row, column) || has(column, row))) out.at(row, column) = {1.0, 1.0};
    }
  }
  return out;
}

/// Of each coordinate the first of its structure: FRFs between structures are zero, or not measured.
std::vector<std::size_t> structures(const MeasuredFrfs& frfs, std::size_t coordinates) {
  std::vector<std::size_t> of(coordinates);
  std::iota(of.begin(), of.end(), std::size_t{0});
  for (std::size_t row = 0; row < coordinates; ++row) {
    for (std::size_t column = 0; column < row; ++column) {
      const Measured& m = frfs.at(row, column);
      if (of[row] == of[column] || !m.known() || m.is_zero()) continue;
      const std::size_t first = std::min(of[row], of[column]), other = std::max(of[row], of[column]);
      std::ranges::replace(of, other, first);
    }
  }
  return of;
}

std::vector<std::size_t> places_of(const std::vector<std::size_t>& all, std::size_t value) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] == value) out.push_back(i);
  }
  return out;
}

}  // namespace

Observations::Observations(const Scene& scene, const Dofs& coordinates, std::size_t others, const LikelihoodBlocks& blocks,
                           frf::FrfSystem& substructures, frf::FrfSystem& assembly)
    : substructures_(substructures, scene, coordinates, others, blocks.substructures),
      assembly_(assembly, scene, coordinates, others, blocks.assembly),
      background_(substructures.background(coordinates, coordinates)) {
  SystematicPlan systematic = SystematicPlan::of(scene, substructures, assembly);
  if (!systematic.all().empty()) {
    systematic_ = systematic.unknowns();
    auto scaled = std::make_unique<ScaledParts>(scene, systematic, substructures, coordinates);
    if (!scaled->none()) scaled_parts_ = std::move(scaled);
    systematic_lines_ = std::make_unique<SystematicLines>(std::move(systematic), substructures, assembly, coordinates);
  }
  const std::size_t size = coordinates.size();
  Raw promised{promised_frfs(substructures, coordinates, others, blocks.substructures),
               promised_frfs(assembly, coordinates, others, blocks.assembly)};
  for (std::size_t at = 0; at < size * size; ++at) {
    if (background_[at] == Complex(0.0)) promised.substructures.at(at / size, at % size) = {0.0, 0.0};
  }
  layout_ = choose_layout(coordinates, others, count_elements(size, others, {promised}));
}

std::vector<FileVariances> Observations::origins() const {
  std::vector<FileVariances> all = substructures_.origins();
  const auto more = assembly_.origins();
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

MirrorDifferences Observations::mirror_differences() const {
  std::array<double, 2> sums = {differences_.squares, differences_.count};
  shares_.sum(sums);
  return {sums[0], sums[1]};
}

void Observations::assume(SystematicPlan gains, frf::FrfSystem& substructures, frf::FrfSystem& assembly) {
  systematic_ = gains.unknowns();
  systematic_lines_.reset();
  if (!systematic_.empty()) {
    systematic_lines_ = std::make_unique<SystematicLines>(std::move(gains), substructures, assembly, layout_.coordinates);
  }
  weigh_as_measured();
}

void Observations::forget_error_sums() {
  substructures_.forget_error_sums();
  assembly_.forget_error_sums();
}

void Observations::take_pairs_apart() {
  substructures_.take_pairs_apart();
  assembly_.take_pairs_apart();
}

bool Observations::has_independent_errors() const {
  const auto is_correlated = [](const LineData& line) { return line.correlation != nullptr; };
  return !shares_.any(has_error_sums() || std::ranges::any_of(data_, is_correlated));
}

std::size_t Observations::bytes() const {
  std::size_t total = 0;
  for (const Raw& raw : raw_) total += raw.substructures.bytes() + raw.assembly.bytes();
  for (const LineData& line : data_) {
    for (const Channel* channel : {&line.sub_jn, &line.sub_jj, &line.asm_jn, &line.asm_jj, &line.drop_nn}) {
      total += (channel->value.capacity() + channel->weight.capacity()) * sizeof(Complex);
    }
    if (line.correlation) total += line.correlation->bytes();
  }
  return total;
}

void Observations::read(const std::vector<Line>& lines, const std::function<void(std::size_t)>& between, const LineShares& shares) {
  shares_ = shares;
  own_lines_ = shares.own(lines.size());
  plan_lines_ = lines;
  raw_.clear();
  errors_.clear();
  data_.clear();
  differences_ = {};
  if (systematic_lines_) systematic_lines_->clear();
  if (scaled_parts_ && !lines.empty()) scaled_parts_->open(lines.front().frequency_hz, lines.back().frequency_hz);
  std::vector<std::size_t> substructure_lines, assembly_lines;
  for (const Line& line : lines) {
    substructure_lines.push_back(line.substructures);
    assembly_lines.push_back(line.assembly);
  }
  substructures_.prepare(substructure_lines);
  assembly_.prepare(assembly_lines);
  const std::size_t chunk = std::max<std::size_t>(1, chunk_lines(entries_per_line()) / 4);
  for (std::size_t first = own_lines_.first; first < own_lines_.last; first += chunk) {
    between(first);
    const std::size_t count = std::min(chunk, own_lines_.last - first);
    read_chunk(std::span(substructure_lines).subspan(first, count), std::span(assembly_lines).subspan(first, count));
  }
  leave_out({});
}

void Observations::leave_out(const std::vector<std::size_t>& coordinates) {
  std::vector<double> counts = count_elements(layout_.coordinates.size(), layout_.others, raw_);
  shares_.sum(counts);
  layout_ = without(choose_layout(layout_.coordinates, layout_.others, counts), coordinates);
  weigh_as_measured();
}

void Observations::read_chunk(std::span<const std::size_t> substructure_lines, std::span<const std::size_t> assembly_lines) {
  substructures_.read(substructure_lines);
  assembly_.read(assembly_lines);
  if (systematic_lines_) systematic_lines_->read(substructure_lines, assembly_lines);
  const std::size_t size = layout_.coordinates.size();
  for (std::size_t i = 0; i < substructure_lines.size(); ++i) {
    raw_.push_back({MeasuredFrfs(size), MeasuredFrfs(size)});
    Raw& raw = raw_.back();
    for (std::size_t at = 0; at < size * size; ++at) {
      const std::size_t row = at / size, column = at % size;
      if (row > column) continue;
      const bool apart = background_[at] == Complex(0.0);
      raw.substructures.at(row, column) = apart ? Measured{0.0, 0.0} : substructures_.at(i, row, column);
      raw.assembly.at(row, column) = assembly_.at(i, row, column);
      if (!apart) substructures_.add_difference(i, row, column, differences_);
      assembly_.add_difference(i, row, column, differences_);
    }
    const Raw* const before = raw_.size() > 1 ? &raw_[raw_.size() - 2] : nullptr;
    raw.substructures.pack(size, before ? &before->substructures : nullptr);
    raw.assembly.pack(size, before ? &before->assembly : nullptr);
    Errors errors{substructures_.errors(i), assembly_.errors(i)};
    if (errors.substructures || errors.assembly) errors_.push_back(std::move(errors));
  }
}

/// From the lines around, at either end from those beside; empty of fewer than three lines.
std::optional<FrfSlopes> Observations::slopes(std::size_t own_line, bool of_assembly,
                                              const std::vector<std::size_t>& coordinates) const {
  if (raw_.size() < 3) return std::nullopt;
  const std::size_t count = std::min(FrfSlopes::most_lines, raw_.size() - (raw_.size() + 1) % 2);
  const std::size_t first = std::min(own_line - std::min(own_line, count / 2), raw_.size() - count);
  std::vector<double> frequency;
  std::vector<const MeasuredFrfs*> lines;
  for (std::size_t k = first; k < first + count; ++k) {
    frequency.push_back(plan_lines_[own_lines_.first + k].frequency_hz);
    lines.push_back(of_assembly ? &raw_[k].assembly : &raw_[k].substructures);
  }
  return FrfSlopes(coordinates, frequency, std::move(lines), own_line - first);
}

void Observations::write_systematic_frfs(std::size_t line, const SystematicLines& errors, SystematicFrfs& out) const {
  const std::size_t own = line - own_lines_.first;
  struct System {
    std::vector<std::size_t> structure;                       ///< of each coordinate
    std::map<std::size_t, std::optional<FrfSlopes>> slopes;  ///< by structure
  };
  std::array<System, 2> systems;
  const auto slope = [&](bool of_assembly, Element at) -> StretchFactor {
    System& system = systems[of_assembly ? 1 : 0];
    const MeasuredFrfs& frfs = of_assembly ? raw_[own].assembly : raw_[own].substructures;
    if (system.structure.empty()) system.structure = structures(frfs, layout_.coordinates.size());
    const std::size_t structure = system.structure[at.row];
    const auto [of, is_new] = system.slopes.try_emplace(structure);
    if (is_new) of->second = slopes(own, of_assembly, places_of(system.structure, structure));
    if (!of->second) return {nan, nan};
    const double frequency = plan_lines_[line].frequency_hz;
    return {-(frequency * of->second->of(at) / frfs.at(at.row, at.column).value + 2.0), -(frequency * of->second->of_own_value() + 2.0)};
  };
  errors.write(own, layout_, raw_[own], slope, out);
}

LineData Observations::data_of(std::size_t own_line, double omega) const {
  const Raw& raw = raw_[own_line];
  const std::size_t n = layout_.others;
  LineData data;
  data.omega = omega;
  reserve(data.sub_jn, layout_.sub_jn.size());
  reserve(data.sub_jj, layout_.sub_jj.size());
  reserve(data.asm_jn, layout_.asm_jn.size());
  reserve(data.asm_jj, layout_.asm_jj.size());
  reserve(data.drop_nn, layout_.drop_nn.size());
  for (const auto [p, k] : layout_.sub_jn) append(data.sub_jn, raw.substructures.at(n + p, k));
  for (const auto [p, q] : layout_.sub_jj) append(data.sub_jj, raw.substructures.at(n + p, n + q));
  for (const auto [p, k] : layout_.asm_jn) append(data.asm_jn, raw.assembly.at(n + p, k));
  for (const auto [p, q] : layout_.asm_jj) append(data.asm_jj, raw.assembly.at(n + p, n + q));
  for (const auto [r, k] : layout_.drop_nn) append(data.drop_nn, raw.substructures.at(r, k) - raw.assembly.at(r, k));
  for (const Channel* channel : {&data.sub_jn, &data.sub_jj, &data.asm_jn, &data.asm_jj, &data.drop_nn})
    data.measured += count_measured(*channel);
  if (systematic_lines_) data.systematic = systematic_lines_->of(own_line, layout_, raw);
  if (scaled_parts_) data.scaled = scaled_parts_->line(plan_lines_[own_lines_.first + own_line].frequency_hz, layout_, raw);
  if (errors_.empty()) return data;
  std::vector<Complex> variance;
  for (const Channel* channel : {&data.sub_jn, &data.sub_jj, &data.asm_jn, &data.asm_jj, &data.drop_nn}) {
    for (const Complex& weight : channel->weight) variance.push_back(variance_of(weight));
  }
  data.correlation = correlation_of(layout_, errors_[own_line].substructures.get(), errors_[own_line].assembly.get(), variance);
  return data;
}

void Observations::weigh_as_measured() {
  data_.clear();
  std::vector<double> measured(plan_lines_.size(), 0.0);
  for (std::size_t i = 0; i < plan_lines_.size(); ++i) {
    LineData line;
    line.omega = angular(plan_lines_[i].frequency_hz);
    if (own_lines_.has(i)) line = data_of(i - own_lines_.first, line.omega);
    measured[i] = static_cast<double>(line.measured);
    data_.push_back(std::move(line));
  }
  shares_.complete(measured, measured.size());
  for (std::size_t i = 0; i < measured.size(); ++i) data_[i].measured = static_cast<std::size_t>(measured[i]);
}

void Observations::weigh_at(std::size_t line, const LineState& state, const ComplexMatrix& z) {
  const Raw& raw = raw_[line - own_lines_.first];
  LineData& data = data_[line];
  data = data_of(line - own_lines_.first, data.omega);
  const std::size_t n = layout_.others;
  const BothSystems<Complex> values = estimated_frfs(layout_, raw, data.drop_nn, state, z);
  substructures_.variances_of(plan_lines_[line].substructures, values.substructures);
  assembly_.variances_of(plan_lines_[line].assembly, values.assembly);
  reweigh(layout_.sub_jn, {n, 0}, substructures_, raw.substructures, values.substructures, data.sub_jn);
  reweigh(layout_.sub_jj, {n, n}, substructures_, raw.substructures, values.substructures, data.sub_jj);
  reweigh(layout_.asm_jn, {n, 0}, assembly_, raw.assembly, values.assembly, data.asm_jn);
  reweigh(layout_.asm_jj, {n, n}, assembly_, raw.assembly, values.assembly, data.asm_jj);
  reweigh_differences(raw, values, data.drop_nn);
}

void Observations::reweigh(const std::vector<Element>& elements, Element origin, const SymmetricFrfs& system,
                           const MeasuredFrfs& measured, const Symmetric<Complex>& values, Channel& channel) const {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::size_t row = origin.row + elements[i].row, column = origin.column + elements[i].column;
    const Measured& m = measured.at(row, column);
    if (!m.known()) continue;
    const Complex now = frf_weight(system.variance(row, column, m.averaged), values.at(row, column));
    channel.weight[i] = near_weight(now, channel.weight[i]);
  }
}

void Observations::reweigh_differences(const Raw& raw, const BothSystems<Complex>& values, Channel& channel) const {
  for (std::size_t i = 0; i < layout_.drop_nn.size(); ++i) {
    const auto [r, k] = layout_.drop_nn[i];
    const Measured &sub = raw.substructures.at(r, k), &whole = raw.assembly.at(r, k);
    if (!sub.known() || !whole.known()) continue;
    const Complex own = sub.is_zero() ? Complex(0.0) : substructures_.variance(r, k, sub.averaged);
    const Complex now = frf_weight(own + assembly_.variance(r, k, whole.averaged),
                                   values.substructures.at(r, k) - values.assembly.at(r, k));
    channel.weight[i] = near_weight(now, channel.weight[i]);
  }
}

}  // namespace jointid::ident
