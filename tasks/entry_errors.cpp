#include "tasks/entry_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "base/error.hpp"
#include "ident/result/chunk_pipeline.hpp"
#include "ident/result/decibel_error.hpp"
#include "ident/variance/variances.hpp"
#include "tasks/line_pairs.hpp"

namespace jointid::tasks {
namespace {

std::vector<std::size_t> places_of(const ident::Dofs& wanted, const ident::Dofs& among) {
  std::vector<std::size_t> out;
  for (const frf::Dof& dof : wanted) out.push_back(frf::find_coordinate(among, dof));
  return out;
}

/// Variances of the measured FRFs of a rectangle, chunk by chunk.
class MeasuredNoise {
 public:
  MeasuredNoise(const ident::Plan& plan, const EntryErrors& of, const std::vector<ident::Line>& lines)
      : lines_(lines), entries_(of.rms_db.size()), variances_(*plan.assembly, of.responses, of.references, plan.scene) {
    std::vector<std::size_t> all;
    for (const ident::Line& line : lines) all.push_back(line.assembly);
    if (variances_.needs_prepare()) variances_.prepare(all);
  }

  /// Whether variances are known without a look at the scatter of the data.
  bool is_known() const {
    return std::ranges::none_of(variances_.origins(), [](const auto& file) { return file.origin == ident::VarianceOrigin::scatter; });
  }

  void read(std::size_t first, std::size_t last, const LinePairs& pairs) {
    std::vector<std::size_t> numbers;
    values_.clear();
    for (std::size_t i = first; i < last; ++i) {
      numbers.push_back(lines_[i].assembly);
      const minimise::View measured = pairs.assembly(i - first);
      for (std::size_t r = 0; r < measured.rows; ++r) {
        for (std::size_t c = 0; c < measured.columns; ++c) values_.push_back(measured(r, c));
      }
    }
    out_.resize(values_.size());
    variances_.read(numbers, values_, out_);
  }

  /// Of the i-th line of the last read(): E|error|².
  double variance(std::size_t i, std::size_t entry) const {
    const Complex parts = out_[i * entries_ + entry];
    return parts.real() + parts.imag();
  }

 private:
  const std::vector<ident::Line>& lines_;
  std::size_t entries_;
  ident::Variances variances_;
  std::vector<Complex> values_, out_;
};

/// None where the files do not know their errors.
std::unique_ptr<MeasuredNoise> measured_noise(const ident::Plan& plan, const EntryErrors& of, const std::vector<ident::Line>& lines) {
  try {
    auto noise = std::make_unique<MeasuredNoise>(plan, of, lines);
    if (noise->is_known()) return noise;
  } catch (const InputError&) {  // too few lines to see a scatter
  }
  return nullptr;
}

/// Root of the mean of squares; NaN of none.
std::vector<double> roots(const std::vector<double>& sums, const std::vector<double>& counts) {
  std::vector<double> out;
  for (std::size_t e = 0; e < sums.size(); ++e) {
    out.push_back(counts[e] > 0.0 ? std::sqrt(sums[e] / counts[e]) : std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

class EntryErrorWorker final : public ident::ChunkWorker {
 public:
  EntryErrorWorker(const ident::Plan& plan, const std::vector<ident::BandMatrices>& bands, const std::vector<ident::Line>& lines,
                   EntryErrors& out)
      : EntryErrorWorker(plan, bands, lines, out, ident::joint_last(out.responses, plan.coordinates.joint),
                         ident::joint_last(out.references, plan.coordinates.joint)) {}

  void read(std::size_t first, std::size_t last) override {
    pairs_.read(first, last);
    if (noise_) noise_->read(first, last, pairs_);
  }

  void work(std::size_t first, std::size_t last) override {
    for (std::size_t i = first; i < last; ++i) {
      const ident::Matrices* matrices = matrices_at(bands_, lines_[i].frequency_hz);
      if (matrices == nullptr) continue;
      add(i - first, pairs_.substructures(i - first), pairs_.assembly(i - first),
          ident::joint_impedance(*matrices, n_, lines_[i].frequency_hz));
    }
  }

  void merge() override {}

  /// [R×C] root mean squares; NaN where no line could be compared.
  std::vector<double> rms() const { return roots(sums_, counts_); }
  std::vector<double> rms_noise() const { return noise_ ? roots(noise_sums_, noise_counts_) : std::vector<double>(); }

 private:
  EntryErrorWorker(const ident::Plan& plan, const std::vector<ident::BandMatrices>& bands, const std::vector<ident::Line>& lines,
                   EntryErrors& out, const ident::Dofs& rows, const ident::Dofs& columns)
      : bands_(bands),
        lines_(lines),
        n_(plan.coordinates.joint.size()),
        rows_(places_of(out.responses, rows)),
        columns_(places_of(out.references, columns)),
        pairs_(lines, ident::whole_rectangle(*plan.substructures, rows, columns),
               ident::whole_rectangle(*plan.assembly, out.responses, out.references)),
        noise_(measured_noise(plan, out, lines)),
        sums_(out.rms_db.size(), 0.0),
        counts_(out.rms_db.size(), 0.0),
        noise_sums_(sums_),
        noise_counts_(sums_) {}

  void add(std::size_t line, const minimise::View& h, const minimise::View& measured, const Eigen::MatrixXcd& impedance) {
    const ident::JointEffect effect = ident::joint_effect(h, h.rows, h.columns, impedance);
    double largest = 0.0;
    for (std::size_t r = 0; r < measured.rows; ++r) {
      for (std::size_t c = 0; c < measured.columns; ++c) largest = std::fmax(largest, std::abs(measured(r, c)));
    }
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        const Complex value = effect.assembly(h(rows_[r], columns_[c]), rows_[r], columns_[c]);
        const std::size_t entry = r * columns_.size() + c;
        add(std::abs(value), std::abs(measured(r, c)), ident::zero_level * largest, entry);
        if (noise_) add_noise(std::norm(value - measured(r, c)) / noise_->variance(line, entry), entry);
      }
    }
  }

  void add(double predicted, double measured, double least, std::size_t entry) {
    const double db = 20.0 * std::log10(predicted / measured);
    if (!(measured > least) || !std::isfinite(db)) return;
    sums_[entry] += db * db;
    counts_[entry] += 1.0;
  }

  void add_noise(double squared, std::size_t entry) {
    if (!std::isfinite(squared)) return;
    noise_sums_[entry] += squared;
    noise_counts_[entry] += 1.0;
  }

  const std::vector<ident::BandMatrices>& bands_;
  const std::vector<ident::Line>& lines_;
  std::size_t n_;
  std::vector<std::size_t> rows_, columns_;  ///< of the entries, in the rectangle of the substructures
  LinePairs pairs_;
  std::unique_ptr<MeasuredNoise> noise_;
  std::vector<double> sums_, counts_;
  std::vector<double> noise_sums_, noise_counts_;
};

/// How many coordinates of a side may be compared.
std::size_t most_coordinates(std::size_t lines, std::size_t joint) {
  constexpr double most_products = 2e9, most_side = 150.0, least_side = 8.0;
  const double per_entry = static_cast<double>(std::max<std::size_t>(1, lines)) * static_cast<double>(joint + 1);
  return static_cast<std::size_t>(std::clamp(std::sqrt(most_products / per_entry), least_side, most_side));
}

}  // namespace

EntryErrors entry_errors(const ident::Plan& plan, const std::vector<ident::BandMatrices>& bands, const ident::Control& control) {
  const std::vector<ident::Line> lines = common_lines(plan);
  const std::size_t most = most_coordinates(lines.size(), plan.coordinates.joint.size());
  EntryErrors out{regenerable_responses(plan), regenerable_references(plan), {}, {}, lines.size(), 0, 0};
  out.all_responses = out.responses.size();
  out.all_references = out.references.size();
  out.responses = thinned(out.responses, most);
  out.references = thinned(out.references, most);
  out.rms_db.assign(out.responses.size() * out.references.size(), std::numeric_limits<double>::quiet_NaN());
  if (out.rms_db.empty() || lines.empty()) return out;
  std::vector<std::unique_ptr<ident::ChunkWorker>> workers;
  workers.push_back(std::make_unique<EntryErrorWorker>(plan, bands, lines, out));
  const auto& worker = static_cast<const EntryErrorWorker&>(*workers.front());
  const std::size_t joint = plan.coordinates.joint.size();
  run_chunks({0, lines.size()}, ident::chunk_lines((out.responses.size() + joint) * (out.references.size() + joint)),
             "comparing FRFs", workers, control);
  out.rms_db = worker.rms();
  out.rms_noise = worker.rms_noise();
  return out;
}

}  // namespace jointid::tasks
