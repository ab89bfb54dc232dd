// Modal fit of 84 × 84 FRFs × 800 lines, 30 modes in the range, two rigid-body modes below and ten modes above it, 1 % circular
// noise with its variances: time, memory and accuracy; then poles and residues against numpy with the same formulas. Exit code 1
// when the fit takes 20 s or more (by the clock, and of processor time on a busy machine) or 2 GB or more, modes are missed or
// invented, a frequency is more than 1e-4 or a loss factor more than 3 % off, or numpy's answers differ.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>
#include <sstream>

#include "base/random.hpp"
#include "base/stopwatch.hpp"
#include "bench/measure.hpp"
#include "bench/output_of.hpp"
#include "frf/noise/noise.hpp"
#include "modalfit/fit.hpp"
#include "modalfit/inputs.hpp"
#include "modalfit/symmetric_model.hpp"
#include "modalfit/synthesis.hpp"
#include "problems/case/modal_set.hpp"

namespace {

using namespace jointid;
constexpr std::size_t coordinates = 84, lines = 800, inside = 30, above = 10, below = 2;

/// Of all threads: what the fit would take on one core.
double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

problems::Modes structure() {
  problems::Modes modes;
  const auto add = [&](double frequency, double loss) {
    modes.frequency_hz.push_back(frequency);
    modes.loss_factor.push_back(loss);
  };
  for (std::size_t r = 0; r < below; ++r) add(0.0, 0.0);
  for (std::size_t r = 0; r < inside + above; ++r) {
    const auto u = uniform_numbers({.seed = 84}, r);
    add(220.0 + (r < inside ? 25.0 : 60.0) * (static_cast<double>(r) + 0.6 * (u[0] - 0.5)), 0.006 + 0.01 * u[1]);
  }
  for (std::size_t i = 0; i < coordinates; ++i) modes.dofs.push_back({static_cast<std::int64_t>(i + 1), frf::Direction::z, 1});
  for (std::size_t k = 0; k < coordinates * modes.count(); ++k) modes.shapes.push_back(normal_numbers({.seed = 85}, k)[0]);
  return modes;
}

frf::FrfSet measurement(const problems::Modes& modes) {
  problems::ResponseRequest request{.response = modes.dofs, .reference = modes.dofs, .frequency_hz = {}};
  for (std::size_t i = 0; i < lines; ++i) request.frequency_hz.push_back(200.0 + static_cast<double>(i));
  return frf::polluted(problems::modal_response(modes, request),
                       {.kind = frf::NoiseKind::circular, .level = 0.01, .record_variance = true}, 1, 0);
}

bool accurate(const modalfit::ModalFit& fit, const problems::Modes& modes) {
  fmt::print("  {} of {} modes found\n", fit.modes.size(), inside);
  if (fit.modes.size() != inside || fit.status != modalfit::FitStatus::ok) return false;
  double frequency = 0.0, damping = 0.0;
  for (std::size_t r = 0; r < inside; ++r) {
    frequency = std::max(frequency, std::abs(fit.modes[r].pole.frequency_hz / modes.frequency_hz[below + r] - 1.0));
    damping = std::max(damping, std::abs(fit.modes[r].pole.damping / modes.loss_factor[below + r] - 1.0));
  }
  fmt::print("  largest relative error: frequency {:.1e}, loss factor {:.1e}\n", frequency, damping);
  return frequency <= 1e-4 && damping <= 0.03;
}

template <class T>
void append(std::ofstream& out, const T* data, std::size_t count) {
  out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(count * sizeof(T)));
}

void write_for_peer(const std::filesystem::path& file, const modalfit::Band& band, const modalfit::InputChoice& choice,
                    const std::vector<modalfit::Pole>& poles) {
  std::ofstream out(file, std::ios::binary);
  append(out, band.frequency_hz.data(), band.lines());
  const auto each = [&](const auto& put) {
    for (std::size_t o = 0; o < choice.outputs; ++o) {
      for (std::size_t c = 0; c < choice.inputs.size(); ++c) put(choice.entry(band, o, c));
    }
  };
  each([&](std::size_t e) { append(out, band.value(e), band.lines()); });
  each([&](std::size_t e) { append(out, band.weights(e), 2 * band.lines()); });
  append(out, band.values.data(), band.values.size());
  append(out, band.weight.data(), band.weight.size());
  for (const modalfit::Pole& pole : poles) append(out, &pole.frequency_hz, 2);
}

std::vector<double> numbers(const std::string& line) {
  std::istringstream stream(line);
  std::vector<double> values;
  for (double value = 0.0; stream >> value;) values.push_back(value);
  return values;
}

/// Polynomial orders as the peer has to take them, from the pole pairs of ours.
std::string order_list(const std::vector<modalfit::OrderPoles>& orders, std::size_t inputs) {
  std::string text;
  for (const auto& order : orders) text += (text.empty() ? "" : ",") + std::to_string(2 * order.order / inputs);
  return text;
}

bool compare_with_peer(const modalfit::Band& band, const modalfit::ModalFit& fit) {
  const modalfit::PolyreferenceOptions options;
  const modalfit::InputChoice choice = modalfit::choose_inputs(band, options.inputs);
  auto start = Clock::now();
  const auto orders = modalfit::polyreference_poles(band, options);
  const double poles_s = seconds_since(start);
  std::vector<std::size_t> entries(band.entries());
  for (std::size_t e = 0; e < entries.size(); ++e) entries[e] = e;
  start = Clock::now();
  const auto residues = modalfit::fit_residues(band, entries, fit.kind, fit.poles());
  const double residues_s = seconds_since(start);

  const auto file = std::filesystem::temp_directory_path() / "jointid-bench-modalfit.bin";
  write_for_peer(file, band, choice, fit.poles());
  const std::size_t highest = 2 * orders.back().order / choice.inputs.size();
  std::istringstream answer(bench::output_of(fmt::format(
      "/usr/bin/python3 {}/modalfit.py {} {} {} {} {} {} {} {} 2>/dev/null", JOINTID_PEER_DIR, file.string(), choice.outputs,
      choice.inputs.size(), band.lines(), band.entries(), fit.modes.size(), highest, order_list(orders, choice.inputs.size()))));
  std::filesystem::remove(file);
  std::string times, pole_line, residue_line;
  if (!std::getline(answer, times) || !std::getline(answer, pole_line) || !std::getline(answer, residue_line)) {
    fmt::print("  numpy is missing (python3-numpy): nothing to compare with\n");
    return true;
  }
  const std::vector<double> seconds = numbers(times), theirs = numbers(pole_line), coefficients = numbers(residue_line);
  fmt::print(
      "  poles of {} orders: {:.2f} s, numpy {:.2f} s; residues of {} FRFs: {:.2f} s, numpy {:.2f} s: {:.1f} times faster "
      "together\n",
      orders.size(), poles_s, seconds[0], entries.size(), residues_s, seconds[1],
      (seconds[0] + seconds[1]) / (poles_s + residues_s));
  double pole_difference = 0.0;
  for (const modalfit::Mode& mode : fit.modes) {  // poles of the structure; those of the noise depend on rounding
    const auto nearest = [&](auto begin, auto end, auto frequency) {
      double best = 1e300;
      for (auto each = begin; each != end; ++each)
        best = std::abs(frequency(*each) - mode.pole.frequency_hz) < std::abs(best - mode.pole.frequency_hz) ? frequency(*each)
                                                                                                             : best;
      return best;
    };
    const auto& own = orders.back().poles;
    const double a = nearest(own.begin(), own.end(), [](const auto& pole) { return pole.damping > 0.0 ? pole.frequency_hz : 0.0; });
    const double b = nearest(theirs.begin(), theirs.end(), [](double frequency) { return frequency; });
    pole_difference = std::max(pole_difference, std::abs(a - b) / b);
  }
  const std::vector<double> first(residues.coefficients.begin(),
                                  residues.coefficients.begin() + static_cast<std::ptrdiff_t>(residues.columns));
  const double residue_difference = bench::largest_difference(first, coefficients, 0, first.size());
  fmt::print("  largest relative difference: poles {:.1e}, residues {:.1e}\n", pole_difference, residue_difference);
  return pole_difference < 1e-5 && residue_difference < 1e-6;
}

}  // namespace

int main() {
  const problems::Modes modes = structure();
  bool good = true;
  {
    const frf::FrfSet set = measurement(modes);
    fmt::print("{} × {} FRFs × {} lines\n", coordinates, coordinates, lines);
    const auto start = Clock::now();
    const double processor_start = processor_seconds();
    modalfit::Band band = modalfit::make_band(set, {});
    const modalfit::ModalFit fit = modalfit::fit(band, set.header, {.kind = {modalfit::Damping::hysteretic, true}});
    const double fit_s = seconds_since(start), processor_s = processor_seconds() - processor_start;
    const modalfit::SymmetricModel model = modalfit::make_symmetric(fit, band);
    const frf::FrfSet regenerated = modalfit::regenerate(model, set.header);
    const auto error = modalfit::overall(modalfit::synthesis_errors(fit, band, regenerated));
    fmt::print(
        "  fit {:.2f} s, {:.2f} s of processor time ({} FRFs refine the poles, {} iterations), symmetric model and regeneration "
        "{:.2f} s, {:.0f} MB\n",
        fit_s, processor_s, fit.refined_entries, fit.iterations, seconds_since(start) - fit_s, peak_megabytes());
    fmt::print("  regenerated FRFs: {:.3f} dB rms from the measured ones\n", error.rms_db);
    good = accurate(fit, modes) && std::min(fit_s, processor_s) < 20.0 && peak_megabytes() < 2048.0;
    good = compare_with_peer(band, fit) && good;
  }
  return good ? 0 : 1;
}
