#include "tasks/modalfit/modal_run.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/complex.hpp"
#include "base/control.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "frf/file/open_as_one.hpp"
#include "frf/file/write.hpp"
#include "frf/set/merged_set.hpp"
#include "ident/plan/data_source.hpp"
#include "modalfit/band/basis.hpp"
#include "modalfit/model/appearance.hpp"

namespace jointid::tasks {
namespace {

constexpr double most_regenerated_bytes = 16e9;

void synthesise(ModalRun& run) {
  frf::FrfHeader lines = run.header;
  lines.frequency_hz = run.band.frequency_hz;
  const std::array range = {lines.frequency_hz.front(), lines.frequency_hz.back()};
  run.regenerated = modalfit::regenerate(run.fit, lines, range);
  run.of_fit = modalfit::synthesis_errors(run.fit, run.band, run.regenerated);
  modalfit::judge(run.fit, modalfit::overall(run.of_fit).rms_db_away);
  run.obstacle = modalfit::obstacle(run.fit);
  if (!run.obstacle.empty()) return;
  run.symmetric = modalfit::make_symmetric(run.fit, run.band);
  run.regenerated = modalfit::regenerate(*run.symmetric, lines);
  run.of_model = modalfit::synthesis_errors(run.fit, run.band, run.regenerated);
}

/// Column of residues of the reference that shows the mode best.
std::vector<std::complex<double>> residue_shape(const modalfit::ModalFit& fit, std::size_t mode) {
  const std::size_t references = fit.reference.size(), own = fit.kind.real_modes ? 1 : 2;
  std::vector<std::complex<double>> best;
  double largest = -1.0;
  for (std::size_t c = 0; c < references; ++c) {
    std::vector<std::complex<double>> column;
    double size = 0.0;
    for (std::size_t r = 0; r < fit.response.size(); ++r) {
      const double* at = fit.residues.coefficients.data() + (r * references + c) * fit.residues.columns + mode * own;
      column.emplace_back(at[0], own == 2 ? at[1] : 0.0);
      size += std::norm(column.back());
    }
    if (size <= largest) continue;
    largest = size;
    best = std::move(column);
  }
  for (auto& value : best) value /= std::sqrt(largest);
  return best;
}

frf::Uff55Mode uff_mode(const ModalRun& run, const Shapes& all, std::size_t r) {
  const modalfit::Pole& pole = run.fit.modes[r].pole;
  const bool hysteretic = run.fit.kind.damping == modalfit::Damping::hysteretic;
  frf::Uff55Mode mode;
  mode.id = {"mode " + std::to_string(r + 1), "jointid modalfit", run.symmetric ? "NONE" : "shape of arbitrary scale", "NONE",
             "NONE"};
  mode.number = static_cast<int>(r + 1);
  mode.is_complex = !run.fit.kind.real_modes;
  mode.frequency_hz = pole.frequency_hz;
  (hysteretic ? mode.hysteretic_damping : mode.viscous_damping) = pole.damping;
  const double omega = angular(pole.frequency_hz);
  const std::complex<double> i(0.0, 1.0);
  // A/(ω_r²(1+iη) + s²) = A/(2λ)·(1/(s−λ) − 1/(s+λ)) with λ = iω_r√(1+iη)
  mode.eigenvalue = hysteretic ? i * omega * std::sqrt(1.0 + i * pole.damping)
                               : omega * std::complex<double>(-pole.damping, std::sqrt(1.0 - pole.damping * pole.damping));
  mode.modal_a = hysteretic ? 2.0 * mode.eigenvalue : 1.0;
  mode.modal_b = -mode.eigenvalue * mode.modal_a;
  mode.dofs = all.dofs;
  mode.shape = all.of_mode[r];
  return mode;
}

/// FRFs between all coordinates grow with their square: of a scanning vibrometer they are hundreds of gigabytes.
void require_room(const frf::FrfHeader& header) {
  const double size =
      static_cast<double>(header.lines()) * static_cast<double>(header.entries()) * 2.0 * sizeof(std::complex<double>);
  if (size <= most_regenerated_bytes) return;
  frf::fail(header, "--regenerate",
            fmt::format("{0} × {0} FRFs on {1} lines take {2:.0f} GB", header.response.size(), header.lines(), size / 1e9),
            "give the files of fewer responses, or a narrower --range");
}

/// A fit that was stopped with modes of its own is worth writing.
void mark_interrupted(modalfit::ModalFit& fit) {
  if (fit.modes.empty()) throw Interrupted();
  fit.status = Status::not_converged;
  fit.message = "Interrupted: the modes are those found so far.";
}

}  // namespace

ModalRun run_modal(const std::string& name, const frf::FrfSet& set, const modalfit::FitOptions& options) {
  const auto start = Clock::now();
  ModalRun run;
  run.files = name;
  run.header = set.header;
  run.band = modalfit::make_band(set, options.range_hz);
  if (options.abandoned) run.band.watch = [abandoned = options.abandoned] { stop_if(abandoned); };
  run.fit = modalfit::fit(run.band, run.header, options);
  if (options.interrupted && options.interrupted()) mark_interrupted(run.fit);
  synthesise(run);
  if (run.fit.status == Status::poor_fit && !modalfit::doubt_phase(run.fit, run.band))
    modalfit::explain(run.fit, run.band, options);
  run.band.watch = {};  // of this run alone
  run.fit_s = seconds_since(start);
  return run;
}

ModalRun run_modal_files(const std::vector<std::filesystem::path>& files, const frf::OpenOptions& open,
                         const modalfit::FitOptions& options) {
  const auto start = Clock::now();
  const frf::FrfSet set = frf::load(*frf::open_as_one(files, open));
  const double read_s = seconds_since(start);
  ModalRun run = run_modal(comma_list(files, [](const auto& file) { return file.filename().string(); }), set, options);
  run.read_s = read_s;
  return run;
}

frf::FrfSet load_structure(const std::vector<ident::DataFile>& files) {
  const auto sources = ident::open_all(files);
  if (sources.size() == 1) return frf::load(*sources.front());
  std::vector<frf::FrfSet> sets;
  for (const auto& source : sources) sets.push_back(frf::load_with_covariance(*source));
  return frf::merged(std::move(sets));
}

Shapes shapes(const ModalRun& run) {
  Shapes out;
  if (run.symmetric) {
    out.dofs = run.symmetric->dofs;
    for (const auto& mode : run.symmetric->modes) out.of_mode.push_back(mode.shape);
    return out;
  }
  out.dofs = run.fit.response;
  for (std::size_t r = 0; r < run.fit.modes.size(); ++r) out.of_mode.push_back(residue_shape(run.fit, r));
  return out;
}

void write_regenerated(const ModalRun& run, const std::filesystem::path& path) {
  if (!run.symmetric) {
    frf::write(run.regenerated, path);
    return;
  }
  frf::FrfHeader header = run.header;
  header.frequency_hz = run.band.frequency_hz;
  header.response = header.reference = run.symmetric->dofs;
  require_room(header);
  frf::write(modalfit::regenerate(*run.symmetric, header), path);
}

std::vector<frf::Uff55Mode> uff_modes(const ModalRun& run) {
  const Shapes all = shapes(run);
  std::vector<frf::Uff55Mode> modes;
  for (std::size_t r = 0; r < run.fit.modes.size(); ++r) modes.push_back(uff_mode(run, all, r));
  return modes;
}

void write_shapes(const ModalRun& run, const std::filesystem::path& path) {
  frf::write_uff55(uff_modes(run), run.header.nodes, path);
}

}  // namespace jointid::tasks
