#include "report/modalfit/modal_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "modalfit/model/mac.hpp"
#include "report/text/frf_criteria.hpp"

namespace jointid::report {
namespace {

constexpr double alike = 0.3;
constexpr double harm_db = 1.0;
constexpr double much_scatter = 2.0;
constexpr double little = 1e-3;  ///< of the moduli of FRFs

/// A pole beyond the range of which hardly more is known than that it is there.
bool is_flank(const modalfit::Mode& mode) { return !mode.inside && mode.damping_deviation > 0.5 * mode.pole.damping; }

std::string decibel(double value) { return std::isfinite(value) ? fmt::format("{:.2f}", value) : "–"; }

const std::vector<modalfit::SynthesisError>& told(const tasks::ModalRun& run) { return run.symmetric ? run.of_model : run.of_fit; }

std::string entry_name(const tasks::ModalRun& run, std::size_t e) {
  const std::size_t columns = run.fit.reference.size();
  return run.fit.response[e / columns].name() + " / " + run.fit.reference[e % columns].name();
}

FrfCriteria criteria_of_entry(const tasks::ModalRun& run, std::size_t e) {
  std::vector<std::complex<double>> measured, model;
  for (std::size_t i = 0; i < run.band.lines(); ++i) {
    measured.push_back(run.band.value(e)[i]);
    model.push_back(run.regenerated.values[i * run.band.entries() + e]);
  }
  return criteria_of(measured, model);
}

std::vector<double> off_rank_one(const tasks::ModalRun& run) {
  std::vector<double> misfits;
  if (run.symmetric) {
    for (const auto& mode : run.symmetric->modes) misfits.push_back(mode.misfit);
  }
  return misfits;
}

}  // namespace

std::string model_text(const modalfit::ModelKind& kind) {
  return modalfit::name(kind.damping) + " damping, " + (kind.real_modes ? "real" : "complex") + " modes";
}

Table modes_table(const tasks::ModalRun& run) {
  const bool hysteretic = run.fit.kind.damping == modalfit::Damping::hysteretic;
  Table table({{"mode"},
               {"frequency Hz"},
               {"std"},
               {hysteretic ? "η %" : "ζ %"},
               {"std"},
               {"significance"},
               {"rank-one misfit"},
               {"", Align::left}});
  const std::vector<double> misfits = off_rank_one(run);
  for (std::size_t r = 0; r < run.fit.modes.size(); ++r) {
    const modalfit::Mode& mode = run.fit.modes[r];
    if (is_flank(mode)) continue;
    table.add({fmt::format("{}", r + 1), fmt::format("{:.4f}", mode.pole.frequency_hz), fmt::format("{:.1e}", mode.frequency_deviation_hz),
               fmt::format("{:.4f}", 100.0 * mode.pole.damping), fmt::format("{:.1e}", 100.0 * mode.damping_deviation),
               fmt::format("{:.3g}", mode.significance),
               r < misfits.size() && std::isfinite(misfits[r]) ? fmt::format("{:.2f}", misfits[r]) : "–",
               mode.inside ? "" : "outside the range"});
  }
  return table;
}

Table mac_table(const tasks::ModalRun& run) {
  Table table({{"mode"}, {"mode"}, {"MAC"}});
  const tasks::Shapes all = tasks::shapes(run);
  for (std::size_t r = 0; r < all.of_mode.size(); ++r) {
    for (std::size_t s = r + 1; s < all.of_mode.size(); ++s) {
      const double mac = modalfit::mac(all.of_mode[r], all.of_mode[s]);
      if (mac > alike) table.add({fmt::format("{}", r + 1), fmt::format("{}", s + 1), fmt::format("{:.3f}", mac)});
    }
  }
  return table;
}

Table synthesis_table(const tasks::ModalRun& run, std::size_t most) {
  Table table({{"FRF", Align::left}, {"dB rms"}, {"away from antiresonances"}, {"FRAC"}, {"LAC, mean"}});
  const auto& errors = told(run);
  std::vector<std::size_t> order;
  for (std::size_t e = 0; e < errors.size(); ++e) {
    if (errors[e].lines > 0) order.push_back(e);
  }
  std::ranges::sort(order, std::greater{}, [&](std::size_t e) { return errors[e].rms_db_away; });
  order.resize(std::min(order.size(), most));
  for (const std::size_t e : order) {
    const FrfCriteria alike = criteria_of_entry(run, e);
    table.add({entry_name(run, e), decibel(errors[e].rms_db), decibel(errors[e].rms_db_away), criterion_text(alike.frac),
               criterion_text(alike.lac)});
  }
  return table;
}

std::string synthesis_text(const std::vector<modalfit::SynthesisError>& errors) {
  const modalfit::SynthesisError all = modalfit::overall(errors);
  return fmt::format("{} dB rms, {} dB away from antiresonances", decibel(all.rms_db), decibel(all.rms_db_away));
}

namespace {

/// Modes whose peaks only the first or last lines see.
std::string edge_note(const tasks::ModalRun& run) {
  constexpr std::size_t few = 3;
  const std::vector<double>& axis = run.band.frequency_hz;
  if (axis.size() <= 2 * few) return {};
  std::string modes;
  for (const modalfit::Mode& mode : run.fit.modes) {
    const double f = mode.pole.frequency_hz;
    if (mode.inside && (f < axis[few] || f > axis[axis.size() - 1 - few])) modes += fmt::format("{}{:.6g}", modes.empty() ? "" : ", ", f);
  }
  return modes.empty() ? modes : "At the edge of the range, where few lines separate a mode from those beyond: " + modes + " Hz.";
}

/// Frequencies on which single FRFs disagree.
std::string scatter_note(const tasks::ModalRun& run) {
  std::string modes;
  for (const modalfit::Mode& mode : run.fit.modes) {
    if (!mode.inside || mode.scatter < much_scatter || !(mode.own_hz[1] > mode.own_hz[0])) continue;
    modes += fmt::format("{}{:.7g} to {:.7g}", modes.empty() ? "" : ", ", mode.own_hz[0], mode.own_hz[1]);
  }
  if (modes.empty()) return {};
  return "The FRFs do not agree on frequencies, each by itself: " + modes +
         " Hz (temperature, suspension, mass of the accelerometer). The standard deviations contain it.";
}

/// FRFs without noise deviate by little and yet by many times their scatter.
std::string misfit_note(const tasks::ModalRun& run, double times) {
  const char* noise = run.fit.known_noise ? "their noise" : "the scatter of neighbouring lines";
  if (run.fit.deviation < little) {
    return fmt::format(
        "The FRFs deviate from the model by {:.1g} of their moduli, which is {:.1f} times {}: modes outside the range, another "
        "law of damping, or rounding.",
        run.fit.deviation, times, noise);
  }
  return fmt::format("The FRFs deviate from the model by {:.1f} times {}: the structure is not that linear, or the noise is larger.", times,
                     noise);
}

std::string flank_note(const tasks::ModalRun& run) {
  std::string poles;
  for (const modalfit::Mode& mode : run.fit.modes) {
    if (is_flank(mode)) poles += fmt::format("{}{:.4g}", poles.empty() ? "" : ", ", mode.pole.frequency_hz);
  }
  return poles.empty() ? poles : "Flanks of what lies beyond the range were fitted by poles near " + poles + " Hz, which are not listed.";
}

}  // namespace

std::vector<std::string> notes(const tasks::ModalRun& run) {
  std::vector<std::string> out;
  if (!run.fit.message.empty()) out.push_back(run.fit.message);
  if (!run.fit.known_noise) out.push_back("The files state no noise: it was estimated from neighbouring lines.");
  out.insert(out.end(), run.fit.remarks.begin(), run.fit.remarks.end());
  for (const std::string& note : {scatter_note(run), flank_note(run)}) {
    if (!note.empty()) out.push_back(note);
  }
  if (!run.obstacle.empty()) out.push_back("No symmetric model: " + run.obstacle + ".");
  if (const std::string edge = edge_note(run); !edge.empty()) out.push_back(edge);
  const double misfit = run.fit.freedom > 0.0 ? run.fit.cost / run.fit.freedom : 1.0;
  if (misfit > 2.0) {
    out.push_back(misfit_note(run, std::sqrt(misfit)));
  }
  if (modalfit::overall(told(run)).rms_db_away > harm_db) {
    out.push_back(
        "The model is more than 1 dB off away from antiresonances: synthesised FRFs would be worse than the measured ones.");
  }
  return out;
}

std::string modal_text(const tasks::ModalRun& run) {
  const auto& axis = run.band.frequency_hz;
  std::string text = fmt::format("{}: {} × {} FRFs, {} lines, {:.6g} to {:.6g} Hz; {}\n\n", run.files, run.band.responses,
                                 run.band.references, axis.size(), axis.front(), axis.back(), model_text(run.fit.kind));
  if (run.fit.status != Status::ok) text += fmt::format("{}: {}\n\n", name(run.fit.status), run.fit.message);
  text += modes_table(run).text() + "\n";
  text += "  fit of each FRF:  " + synthesis_text(run.of_fit) + "\n";
  if (run.symmetric) text += "  symmetric model:  " + synthesis_text(run.of_model) + "\n";
  text += fmt::format("  residuals over noise (mean square): {:.3f}, {} FRFs, {} iterations, {:.2f} s\n",
                      run.fit.freedom > 0.0 ? run.fit.cost / run.fit.freedom : 0.0, run.fit.refined_entries, run.fit.iterations, run.fit_s);
  if (!mac_table(run).rows().empty()) text += "\nmodes of like shapes:\n" + mac_table(run).text();
  for (const std::string& note : notes(run)) {
    if (note != run.fit.message) text += "\n" + note + "\n";
  }
  return text;
}

}  // namespace jointid::report
