#include "tasks/regenerate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ident/result/chunk_pipeline.hpp"
#include "tasks/line_pairs.hpp"

namespace jointid::tasks {
namespace {

/// The DOFs of `dofs` that `system_dofs` has too.
ident::Dofs shared(const ident::Dofs& dofs, const ident::Dofs& system_dofs) {
  ident::Dofs both;
  for (const frf::Dof& dof : dofs) {
    if (frf::has(system_dofs, dof)) both.push_back(dof);
  }
  return both;
}

void add_once(ident::Dofs& dofs, const frf::Dof& dof) {
  if (!frf::has(dofs, dof)) dofs.push_back(dof);
}

/// The rows (or columns) of the entries. The joint's stand last in a rectangle of the substructures.
struct Side {
  ident::Dofs wanted, joint;

  ident::Dofs all() const { return ident::joint_last(wanted, joint); }
  std::size_t at(const frf::Dof& dof) const { return frf::find_coordinate(all(), dof); }
  /// −1 when the joint points the other way than the entry.
  int sign(const frf::Dof& dof) const { return dof.sign * all()[at(dof)].sign; }
};

/// Where an entry stands in the rectangles of the two systems.
struct Place {
  std::size_t row = 0, column = 0;
  std::size_t measured_row = 0, measured_column = 0;
  double sign = 1.0;  ///< of what is predicted, to the entry
};

class Regenerator final : public ident::ChunkWorker {
 public:
  Regenerator(const ident::Plan& plan, const std::vector<ident::BandMatrices>& bands, const Side& rows, const Side& columns,
              const std::vector<ident::Line>& lines, Regenerated& out)
      : bands_(bands),
        n_(plan.coordinates.joint.size()),
        lines_(lines),
        pairs_(lines, ident::whole_rectangle(*plan.substructures, rows.all(), columns.all()),
               ident::whole_rectangle(*plan.assembly, rows.wanted, columns.wanted)),
        out_(out) {
    for (const RegeneratedFrf& frf : out.frfs) {
      const frf::Dof &response = frf.entry.response, &reference = frf.entry.reference;
      places_.push_back({rows.at(response), columns.at(reference), frf::find_coordinate(rows.wanted, response),
                         frf::find_coordinate(columns.wanted, reference),
                         static_cast<double>(rows.sign(response) * columns.sign(reference))});
    }
  }

  void read(std::size_t first, std::size_t last) override { pairs_.read(first, last); }

  void work(std::size_t first, std::size_t last) override {
    for (std::size_t i = first; i < last; ++i) {
      const ident::Matrices* matrices = matrices_at(bands_, lines_[i].frequency_hz);
      const minimise::View h = pairs_.substructures(i - first), measured = pairs_.assembly(i - first);
      for (std::size_t k = 0; k < places_.size(); ++k) {
        out_.frfs[k].measured[i] = measured(places_[k].measured_row, places_[k].measured_column);
      }
      if (matrices != nullptr) predict(i, h, ident::joint_impedance(*matrices, n_, lines_[i].frequency_hz));
    }
  }

  void merge() override {}

 private:
  void predict(std::size_t i, const minimise::View& h, const Eigen::MatrixXcd& impedance) {
    const ident::JointEffect effect = ident::joint_effect(h, h.rows, h.columns, impedance);
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const std::size_t row = places_[k].row, column = places_[k].column;
      out_.frfs[k].predicted[i] = places_[k].sign * effect.assembly(h(row, column), row, column);
    }
  }

  const std::vector<ident::BandMatrices>& bands_;
  std::size_t n_;
  const std::vector<ident::Line>& lines_;
  LinePairs pairs_;
  std::vector<Place> places_;
  Regenerated& out_;
};

Regenerated prepared(const std::vector<ident::Line>& lines, const std::vector<FrfEntry>& entries) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Regenerated out;
  for (const ident::Line& line : lines) out.frequency_hz.push_back(line.frequency_hz);
  const std::vector<Complex> nothing(lines.size(), Complex(nan, nan));
  for (const FrfEntry& entry : entries) out.frfs.push_back({entry, nothing, nothing});
  return out;
}

bool is_driving_point(const FrfEntry& entry) { return entry.response.same_coordinate(entry.reference); }

}  // namespace

std::vector<ident::Line> common_lines(const ident::Plan& plan) {
  const std::vector<double>& axis = plan.assembly->frequency_hz();
  const std::vector<std::size_t> partners = frf::match_lines(axis, plan.substructures->frequency_hz());
  std::vector<ident::Line> lines;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    if (partners[i] != frf::npos) lines.push_back({axis[i], partners[i], i});
  }
  return lines;
}

ident::Dofs regenerable_responses(const ident::Plan& plan) {
  return ident::joined(plan.coordinates.responses, shared(plan.coordinates.joint, plan.assembly->responses()));
}

ident::Dofs regenerable_references(const ident::Plan& plan) {
  return ident::joined(plan.coordinates.references, shared(plan.coordinates.joint, plan.assembly->references()));
}

ident::Dofs thinned(const ident::Dofs& dofs, std::size_t count) {
  if (dofs.size() <= count) return dofs;
  ident::Dofs chosen;
  for (std::size_t i = 0; i < count; ++i) {
    chosen.push_back(dofs[count == 1 ? 0 : i * (dofs.size() - 1) / (count - 1)]);
  }
  return chosen;
}

std::vector<FrfEntry> choose_entries(const ident::Plan& plan, std::size_t count) {
  const ident::Dofs rows = regenerable_responses(plan), columns = regenerable_references(plan);
  std::vector<FrfEntry> entries;
  const auto add = [&](const frf::Dof& row, const frf::Dof& column) {
    const FrfEntry entry{row, column};
    if (std::ranges::find(entries, entry) == entries.end()) entries.push_back(entry);
  };
  for (const frf::Dof& dof : thinned(shared(rows, columns), (count + 1) / 2)) add(dof, dof);
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  for (const frf::Dof& row : thinned(rows, side)) {
    for (const frf::Dof& column : thinned(columns, side)) add(row, column);
  }
  if (entries.size() > count) entries.resize(count);
  std::stable_partition(entries.begin(), entries.end(), is_driving_point);
  return entries;
}

Regenerated regenerate(const ident::Plan& plan, const std::vector<ident::BandMatrices>& bands, const std::vector<FrfEntry>& entries,
                       const ident::Control& control) {
  const std::vector<ident::Line> lines = common_lines(plan);
  Regenerated out = prepared(lines, entries);
  if (entries.empty() || lines.empty()) return out;
  Side rows{{}, plan.coordinates.joint}, columns = rows;
  for (const FrfEntry& entry : entries) {
    add_once(rows.wanted, entry.response);
    add_once(columns.wanted, entry.reference);
  }
  const std::size_t chunk = ident::chunk_lines(rows.all().size() * columns.all().size());
  std::vector<std::unique_ptr<ident::ChunkWorker>> workers;
  workers.push_back(std::make_unique<Regenerator>(plan, bands, rows, columns, lines, out));
  run_chunks({0, lines.size()}, chunk, "regenerating", workers, control);
  return out;
}

std::optional<double> decibel_error(const RegeneratedFrf& frf) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < frf.measured.size(); ++i) {
    const double db = 20.0 * std::log10(std::abs(frf.predicted[i]) / std::abs(frf.measured[i]));
    if (!std::isfinite(db)) continue;
    sum += db * db;
    count += 1.0;
  }
  if (count == 0.0) return std::nullopt;
  return std::sqrt(sum / count);
}

}  // namespace jointid::tasks
