#include "ident/likelihood/data/symmetric_frfs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/eigen.hpp"

namespace jointid::ident {
namespace {

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

std::vector<std::size_t> numbers(std::size_t first, std::size_t last) {
  std::vector<std::size_t> all(last - first);
  std::iota(all.begin(), all.end(), first);
  return all;
}

Dofs pick(const Dofs& dofs, const std::vector<std::size_t>& which) {
  Dofs out;
  for (const std::size_t i : which) out.push_back(dofs[i]);
  return out;
}

double averaged_part(double a, double va, double b, double vb) {
  if (va == 0.0 || vb == 0.0) return va == 0.0 ? a : b;
  return (a * vb + b * va) / (va + vb);
}

/// Of averaged_part() of errors with this correlation; more than nothing where they cancel.
double averaged_variance(double va, double vb, double correlation) {
  constexpr double least = 1e-4;
  if (va == 0.0 || vb == 0.0) return 0.0;
  const double apart = va * vb / (va + vb);
  return apart * std::max(least, 1.0 + 2.0 * correlation * std::sqrt(va * vb) / (va + vb));
}

/// Whether two measurements agree far better than their noise lets independent ones: one is a copy of the other.
bool copies(const Measured& a, const Measured& b) {
  const double variance = a.variance.real() + a.variance.imag() + b.variance.real() + b.variance.imag();
  return std::norm(a.value - b.value) <= 1e-8 * variance || a.value == b.value;
}

}  // namespace

SymmetricFrfs::SymmetricFrfs(frf::FrfSystem& system, const Scene& scene, const Dofs& coordinates, std::size_t others,
                             const Blocks& blocks)
    : size_(coordinates.size()) {
  const auto n = numbers(0, others), j = numbers(others, size_);
  std::vector<std::pair<std::vector<std::size_t>, std::vector<std::size_t>>> wanted;
  if (blocks.nn && blocks.jn && blocks.jj) {
    wanted.emplace_back(numbers(0, size_), numbers(0, size_));
  } else {
    if (blocks.nn) wanted.emplace_back(n, n);
    if (blocks.jn) wanted.emplace_back(n, j);
    if (blocks.jn) wanted.emplace_back(j, n);
    if (blocks.jj) wanted.emplace_back(j, j);
  }
  std::vector<FrfCovariances::Rectangle> rectangles;
  for (const auto& [rows, columns] : wanted) rectangles.push_back({rows, columns});
  covariances_ = std::make_unique<FrfCovariances>(system, scene, coordinates, rectangles);
  if (!covariances_->any()) covariances_.reset();
  sums_ = std::make_unique<FrfErrorSums>(system, coordinates);
  if (!sums_->any()) sums_.reset();
  for (auto& [rows, columns] : wanted) {
    if (rows.empty() || columns.empty()) continue;
    const Dofs row_dofs = pick(coordinates, rows), column_dofs = pick(coordinates, columns);
    parts_.push_back({std::move(rows), std::move(columns), std::make_unique<frf::BlockReader>(system, row_dofs, column_dofs),
                      std::make_unique<Variances>(system, row_dofs, column_dofs, scene)});
  }
}

std::size_t SymmetricFrfs::entries_per_line() const {
  std::size_t entries = 0;
  for (const Part& part : parts_) entries += part.rows.size() * part.columns.size();
  return entries;
}

std::vector<FileVariances> SymmetricFrfs::origins() const {
  std::vector<FileVariances> all;
  for (const Part& part : parts_) {
    for (FileVariances& file : part.variances->origins()) {
      const bool told = std::any_of(all.begin(), all.end(), [&](const FileVariances& other) { return other.file == file.file; });
      if (!told) all.push_back(std::move(file));
    }
  }
  return all;
}

bool SymmetricFrfs::variances_by_law() const {
  const auto all = origins();
  return std::any_of(all.begin(), all.end(),
                     [](const FileVariances& file) { return file.origin == VarianceOrigin::noise_model; });
}

void SymmetricFrfs::scatter(const Part& part, std::size_t lines, const std::vector<Complex>& from,
                            std::vector<Complex>& to) const {
  const Complex* next = from.data();
  for (std::size_t line = 0; line < lines; ++line) {
    for (const std::size_t row : part.rows) {
      for (const std::size_t column : part.columns) to[(line * size_ + row) * size_ + column] = *next++;
    }
  }
}

void SymmetricFrfs::prepare(std::span<const std::size_t> lines) {
  for (Part& part : parts_) {
    if (part.variances->needs_prepare()) part.variances->prepare(lines);
  }
  if (covariances_) covariances_->prepare(lines);
}

void SymmetricFrfs::read(std::span<const std::size_t> lines) {
  values_.assign(lines.size() * size_ * size_, not_measured);
  variances_.assign(values_.size(), not_measured);
  for (Part& part : parts_) {
    scratch_.resize(lines.size() * part.rows.size() * part.columns.size());
    scratch_variance_.resize(scratch_.size());
    part.reader->read(lines, scratch_);
    part.variances->read(lines, scratch_, scratch_variance_);
    scatter(part, lines.size(), scratch_, values_);
    scatter(part, lines.size(), scratch_variance_, variances_);
  }
  if (sums_) sums_->read(lines);
  if (!covariances_) return;
  covariances_->read(lines);
  take_variances_of_laws(lines.size());
}

/// A law of the covariances is one of the variances, too: those of the contrasts between responses fit those of the responses.
void SymmetricFrfs::take_variances_of_laws(std::size_t lines) {
  for (std::size_t i = 0; i < lines; ++i) {
    for (std::size_t row = 0; row < size_; ++row) {
      for (std::size_t column = 0; column < size_; ++column) {
        const StoredError error = covariances_->error(i, row, column);
        if (!error.is_known() || !covariances_->by_law(error)) continue;
        const Eigen::Index member = jointid::at(error.member);
        const double variance = 0.5 * covariances_->covariances(i)[error.group](member, member).real();
        Complex& of = variances_[(i * size_ + row) * size_ + column];
        if (variance > 0.0 && !std::isnan(of.real())) of = {variance, variance};
      }
    }
  }
}

SymmetricFrfs::Role SymmetricFrfs::role(const Measured& there, const Measured& back) const {
  if (!back.known()) return Role::there;
  return !there.known() || (!are_pairs_apart_ && copies(there, back)) ? Role::back : Role::both;
}

/// Of errors that depend on each other to first order: more FRFs than there were before they were coupled. What they do to second
/// order, and rounding, is left a hundredth of each standard deviation.
constexpr double first_order = 1.0 - 1e-4;

void SymmetricFrfs::add_terms(std::size_t i, std::size_t row, std::size_t column, double weight, ErrorTerms& out) const {
  if (weight == 0.0) return;
  if (sums_) {
    for (const auto& [error, factor, relation] : sums_->terms(i, row, column)) {
      out.push_back({ErrorTerm::independent, error, std::sqrt(first_order) * weight * factor, relation});
    }
  }
  if (!covariances_) return;
  const StoredError error = covariances_->error(i, row, column);
  if (error.is_known()) out.push_back({error.group, error.member, weight * error.sign});
}

/// With the weights of averaged_part(); the parts of errors that covariances tell of have the same variance.
ErrorTerms SymmetricFrfs::terms(std::size_t i, std::size_t row, std::size_t column) const {
  const std::size_t one = (i * size_ + row) * size_ + column, other = (i * size_ + column) * size_ + row;
  const Measured a{values_[one], variances_[one]}, b{values_[other], variances_[other]};
  const Role of = role(a, b);
  ErrorTerms out;
  const auto total = [](const Measured& m) { return m.variance.real() + m.variance.imag(); };
  double share = of == Role::there ? 1.0 : 0.0;
  if (of == Role::both) share = averaged_part(1.0, total(a), 0.0, total(b));
  add_terms(i, row, column, share, out);
  add_terms(i, column, row, 1.0 - share, out);
  return out;
}

std::shared_ptr<const LineErrors> SymmetricFrfs::errors(std::size_t i) const {
  if (!covariances_ && !sums_) return nullptr;
  auto out = std::make_shared<LineErrors>(
      LineErrors{covariances_ ? covariances_->covariances(i) : std::vector<Eigen::MatrixXcd>(), Symmetric<ErrorTerms>(size_)});
  for (std::size_t row = 0; row < size_; ++row) {
    for (std::size_t column = 0; column <= row; ++column) out->terms.at(column, row) = terms(i, column, row);
  }
  return out;
}

Measured SymmetricFrfs::at(std::size_t i, std::size_t row, std::size_t column) const {
  const std::size_t one = (i * size_ + row) * size_ + column, other = (i * size_ + column) * size_ + row;
  const Measured a{values_[one], variances_[one]}, b{values_[other], variances_[other]};
  const Role of = role(a, b);
  if (of != Role::both) return of == Role::there ? a : b;
  const double correlation = correlation_there_and_back(i, row, column);
  return {{averaged_part(a.value.real(), a.variance.real(), b.value.real(), b.variance.real()),
           averaged_part(a.value.imag(), a.variance.imag(), b.value.imag(), b.variance.imag())},
          {averaged_variance(a.variance.real(), b.variance.real(), correlation),
           averaged_variance(a.variance.imag(), b.variance.imag(), correlation)},
          true};
}

void SymmetricFrfs::add_difference(std::size_t i, std::size_t row, std::size_t column, MirrorDifferences& to) const {
  constexpr double most = 25.0;
  if (row == column || covariances_) return;
  const std::size_t one = (i * size_ + row) * size_ + column, other = (i * size_ + column) * size_ + row;
  const Measured a{values_[one], variances_[one]}, b{values_[other], variances_[other]};
  if (role(a, b) != Role::both) return;
  const Complex difference = a.value - b.value, variance = a.variance + b.variance;
  for (const auto& [square, of] : {std::pair(std::pow(difference.real(), 2), variance.real()),
                                   std::pair(std::pow(difference.imag(), 2), variance.imag())}) {
    if (!(of > 0.0)) continue;
    to.squares += std::min(most, square / of);
    to.count += 1.0;
  }
}

/// Of the errors of an FRF and that of the transposed place: not 0 where both were measured with forces at once.
double SymmetricFrfs::correlation_there_and_back(std::size_t i, std::size_t row, std::size_t column) const {
  if (!covariances_) return 0.0;
  const StoredError there = covariances_->error(i, row, column), back = covariances_->error(i, column, row);
  if (!there.is_known() || there.group != back.group) return 0.0;
  const Eigen::MatrixXcd& covariance = covariances_->covariances(i)[there.group];
  const auto of = [&](const StoredError& a, const StoredError& b) {
    return covariance(jointid::at(a.member), jointid::at(b.member)).real();
  };
  const double found = there.sign * back.sign * of(there, back) / std::sqrt(of(there, there) * of(back, back));
  return std::isfinite(found) ? found : 0.0;
}

void SymmetricFrfs::variances_of(std::size_t line, const Symmetric<Complex>& values) {
  variances_.assign(size_ * size_, not_measured);
  const std::array<std::size_t, 1> lines = {line};
  for (Part& part : parts_) {
    scratch_.clear();
    for (const std::size_t row : part.rows) {
      for (const std::size_t column : part.columns) scratch_.push_back(values.at(row, column));
    }
    scratch_variance_.resize(scratch_.size());
    part.variances->read(lines, scratch_, scratch_variance_);
    scatter(part, 1, scratch_variance_, variances_);
  }
}

Complex SymmetricFrfs::variance(std::size_t row, std::size_t column, bool averaged) const {
  const Complex one = variances_[row * size_ + column], other = variances_[column * size_ + row];
  const Complex known = std::isnan(one.real()) ? other : one;
  return averaged ? 0.5 * known : known;
}

}  // namespace jointid::ident
