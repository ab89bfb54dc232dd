#include "tasks/entry_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ident/result/chunk_pipeline.hpp"
#include "ident/result/decibel_error.hpp"
#include "tasks/line_pairs.hpp"

namespace jointid::tasks {
namespace {

std::vector<std::size_t> places_of(const ident::Dofs& wanted, const ident::Dofs& among) {
  std::vector<std::size_t> out;
  for (const frf::Dof& dof : wanted) out.push_back(frf::find_coordinate(among, dof));
  return out;
}

class EntryErrorWorker final : public ident::ChunkWorker {
 public:
  EntryErrorWorker(ident::Plan& plan, const std::vector<ident::BandMatrices>& bands, const std::vector<ident::Line>& lines,
                   EntryErrors& out)
      : EntryErrorWorker(plan, bands, lines, out, ident::joint_last(out.responses, plan.coordinates.joint),
                         ident::joint_last(out.references, plan.coordinates.joint)) {}

  void read(std::size_t first, std::size_t last) override { pairs_.read(first, last); }

  void work(std::size_t first, std::size_t last) override {
    for (std::size_t i = first; i < last; ++i) {
      const ident::Matrices* matrices = matrices_at(bands_, lines_[i].frequency_hz);
      if (matrices == nullptr) continue;
      add(pairs_.substructures(i - first), pairs_.assembly(i - first),
          ident::joint_impedance(*matrices, n_, lines_[i].frequency_hz));
    }
  }

  void merge() override {}

  /// [R×C] root mean squares; NaN where no line could be compared.
  std::vector<double> rms() const {
    std::vector<double> out;
    for (std::size_t e = 0; e < sums_.size(); ++e) {
      out.push_back(counts_[e] > 0.0 ? std::sqrt(sums_[e] / counts_[e]) : std::numeric_limits<double>::quiet_NaN());
    }
    return out;
  }

 private:
  EntryErrorWorker(ident::Plan& plan, const std::vector<ident::BandMatrices>& bands, const std::vector<ident::Line>& lines,
                   EntryErrors& out, const ident::Dofs& rows, const ident::Dofs& columns)
      : bands_(bands),
        lines_(lines),
        n_(plan.coordinates.joint.size()),
        rows_(places_of(out.responses, rows)),
        columns_(places_of(out.references, columns)),
        pairs_(lines, ident::whole_rectangle(*plan.substructures, rows, columns),
               ident::whole_rectangle(*plan.assembly, out.responses, out.references)),
        sums_(out.rms_db.size(), 0.0),
        counts_(out.rms_db.size(), 0.0) {}

  void add(const minimise::View& h, const minimise::View& measured, const Eigen::MatrixXcd& impedance) {
    const ident::JointEffect effect = ident::joint_effect(h, h.rows, h.columns, impedance);
    double largest = 0.0;
    for (std::size_t r = 0; r < measured.rows; ++r) {
      for (std::size_t c = 0; c < measured.columns; ++c) largest = std::fmax(largest, std::abs(measured(r, c)));
    }
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        const Complex value = effect.assembly(h(rows_[r], columns_[c]), rows_[r], columns_[c]);
        add(std::abs(value), std::abs(measured(r, c)), ident::zero_level * largest, r * columns_.size() + c);
      }
    }
  }

  void add(double predicted, double measured, double least, std::size_t entry) {
    const double db = 20.0 * std::log10(predicted / measured);
    if (!(measured > least) || !std::isfinite(db)) return;
    sums_[entry] += db * db;
    counts_[entry] += 1.0;
  }

  const std::vector<ident::BandMatrices>& bands_;
  const std::vector<ident::Line>& lines_;
  std::size_t n_;
  std::vector<std::size_t> rows_, columns_;  ///< of the entries, in the rectangle of the substructures
  LinePairs pairs_;
  std::vector<double> sums_, counts_;
};

/// How many coordinates of a side may be compared.
std::size_t most_coordinates(std::size_t lines, std::size_t joint) {
  constexpr double most_products = 2e9, most_side = 150.0, least_side = 8.0;
  const double per_entry = static_cast<double>(std::max<std::size_t>(1, lines)) * static_cast<double>(joint + 1);
  return static_cast<std::size_t>(std::clamp(std::sqrt(most_products / per_entry), least_side, most_side));
}

}  // namespace

EntryErrors entry_errors(ident::Plan& plan, const std::vector<ident::BandMatrices>& bands, const ident::Control& control) {
  const std::vector<ident::Line> lines = common_lines(plan);
  const std::size_t most = most_coordinates(lines.size(), plan.coordinates.joint.size());
  EntryErrors out{regenerable_responses(plan), regenerable_references(plan), {}, lines.size(), 0, 0};
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
  return out;
}

}  // namespace jointid::tasks
