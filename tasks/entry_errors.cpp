#include "tasks/entry_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "coupling/joint_loop.hpp"
#include "ident/judgement/measured_rectangle.hpp"
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
  /// `lines`: of this system.
  MeasuredNoise(frf::FrfSystem& system, const ident::Dofs& rows, const ident::Dofs& columns, const ident::Scene& scene,
                std::vector<std::size_t> lines)
      : lines_(std::move(lines)),
        entries_(rows.size() * columns.size()),
        columns_(columns.size()),
        variances_(system, rows, columns, scene) {
    if (variances_.needs_prepare()) variances_.prepare(lines_);
  }

  /// Whether variances are known without a look at the scatter of the data.
  bool is_known() const {
    return std::ranges::none_of(variances_.origins(), [](const auto& file) { return file.origin == ident::VarianceOrigin::scatter; });
  }

  /// `measured(i)`: the FRFs of the i-th line from `first` on.
  template <class Measured>
  void read(std::size_t first, std::size_t last, Measured measured) {
    values_.clear();
    for (std::size_t i = first; i < last; ++i) {
      const minimise::View frfs = measured(i - first);
      for (std::size_t r = 0; r < frfs.rows; ++r) {
        for (std::size_t c = 0; c < frfs.columns; ++c) values_.push_back(frfs(r, c));
      }
    }
    out_.resize(values_.size());
    variances_.read(std::span(lines_).subspan(first, last - first), values_, out_);
  }

  /// Of the i-th line of the last read(): E|error|².
  double variance(std::size_t i, std::size_t entry) const {
    const Complex parts = out_[i * entries_ + entry];
    return parts.real() + parts.imag();
  }

  /// [rows, columns] of that line.
  Eigen::MatrixXd variances(std::size_t i) const {
    Eigen::MatrixXd of(at(entries_ / columns_), at(columns_));
    for (std::size_t e = 0; e < entries_; ++e) of(at(e / columns_), at(e % columns_)) = variance(i, e);
    return of;
  }

 private:
  std::vector<std::size_t> lines_;
  std::size_t entries_, columns_;
  ident::Variances variances_;
  std::vector<Complex> values_, out_;
};

/// None where the files do not know their errors.
std::unique_ptr<MeasuredNoise> measured_noise(frf::FrfSystem& system, const ident::Dofs& rows, const ident::Dofs& columns,
                                              const ident::Scene& scene, const std::vector<ident::Line>& lines,
                                              std::size_t ident::Line::*line_of) {
  try {
    auto noise = std::make_unique<MeasuredNoise>(system, rows, columns, scene, ident::lines_of(lines, line_of));
    if (noise->is_known()) return noise;
  } catch (const InputError&) {  // too few lines to see a scatter
  }
  return nullptr;
}

/// Squares of the factors with which an error of the substructures' FRF (a, b) comes to the assembly's FRF (i, j), to first
/// order: dH = (I − left E) dh (I − Eᵀ right), E the joint's rows. Of one side: of the joint's coordinates, and of i itself where
/// it is none of these.
struct ErrorFactors {
  Eigen::MatrixXd joint;  ///< [entries, N]
  std::vector<double> own;

  /// `effect` [entries, N]: left, or the transpose of right; `places` of the entries among `count` coordinates, the joint's last.
  ErrorFactors(const Eigen::MatrixXcd& effect, const std::vector<std::size_t>& places, std::size_t count)
      : joint(effect.rows(), effect.cols()) {
    const auto others = static_cast<Eigen::Index>(count) - effect.cols();
    for (Eigen::Index i = 0; i < effect.rows(); ++i) {
      const Eigen::Index place = at(places[static_cast<std::size_t>(i)]) - others;
      own.push_back(place < 0 ? 1.0 : 0.0);
      for (Eigen::Index n = 0; n < effect.cols(); ++n) joint(i, n) = std::norm((n == place ? 1.0 : 0.0) - effect(i, n));
    }
  }
};

/// Variances of the predicted FRFs by those of the substructures', `v`, whose errors are taken as independent.
Eigen::MatrixXd predicted_variances(const ident::JointEffect& effect, const minimise::View& h, const Eigen::MatrixXcd& impedance,
                                    const Eigen::MatrixXd& v, const std::vector<std::size_t>& rows,
                                    const std::vector<std::size_t>& columns) {
  const Eigen::Index n = impedance.rows(), r = v.rows(), c = v.cols();
  const Eigen::MatrixXcd h_bb = map(h).bottomRightCorner(n, n), left = effect.left(rows, Eigen::all);
  const Eigen::MatrixXcd to_joint = map(effect.right)(Eigen::all, columns);
  const Eigen::MatrixXcd right = coupling::force_with_joint(impedance, h_bb, impedance * to_joint);
  const ErrorFactors above(left, rows, static_cast<std::size_t>(r)),
      below(right.transpose(), columns, static_cast<std::size_t>(c));
  Eigen::MatrixXd half = above.joint * v.bottomRows(n);  // [entries, columns of h]
  for (Eigen::Index i = 0; i < half.rows(); ++i) {
    if (above.own[static_cast<std::size_t>(i)] > 0.0)
      half.row(i) += v.row(static_cast<Eigen::Index>(rows[static_cast<std::size_t>(i)]));
  }
  Eigen::MatrixXd out = half.rightCols(n) * below.joint.transpose();
  for (Eigen::Index k = 0; k < out.cols(); ++k) {
    if (below.own[static_cast<std::size_t>(k)] > 0.0)
      out.col(k) += half.col(static_cast<Eigen::Index>(columns[static_cast<std::size_t>(k)]));
  }
  return out;
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
    if (noise_) noise_->read(first, last, [this](std::size_t i) { return pairs_.assembly(i); });
    if (part_noise_) part_noise_->read(first, last, [this](std::size_t i) { return pairs_.substructures(i); });
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
        noise_(measured_noise(*plan.assembly, out.responses, out.references, plan.scene, lines, &ident::Line::assembly)),
        part_noise_(noise_ ? measured_noise(*plan.substructures, rows, columns, plan.scene, lines, &ident::Line::substructures)
                           : nullptr),
        sums_(out.rms_db.size(), 0.0),
        counts_(out.rms_db.size(), 0.0),
        noise_sums_(sums_),
        noise_counts_(sums_) {}

  void add(std::size_t line, const minimise::View& h, const minimise::View& measured, const Eigen::MatrixXcd& impedance) {
    const ident::JointEffect effect = ident::joint_effect(h, h.rows, h.columns, impedance);
    Eigen::MatrixXd predicted;
    if (part_noise_) predicted = predicted_variances(effect, h, impedance, part_noise_->variances(line), rows_, columns_);
    double largest = 0.0;
    for (std::size_t r = 0; r < measured.rows; ++r) {
      for (std::size_t c = 0; c < measured.columns; ++c) largest = std::fmax(largest, std::abs(measured(r, c)));
    }
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        const Complex value = effect.assembly(h(rows_[r], columns_[c]), rows_[r], columns_[c]);
        const std::size_t entry = r * columns_.size() + c;
        add(std::abs(value), std::abs(measured(r, c)), ident::zero_level * largest, entry);
        const double of_parts = part_noise_ ? predicted(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) : 0.0;
        if (noise_) add_noise(std::norm(value - measured(r, c)) / (noise_->variance(line, entry) + of_parts), entry);
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
  std::unique_ptr<MeasuredNoise> noise_, part_noise_;
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
