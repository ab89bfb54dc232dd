// Modal fit of 84 × 84 FRFs × 800 lines, 30 modes in the range, two rigid-body modes below and ten modes above it, 1 % circular
// noise with its variances: time, memory and accuracy; then poles and residues against numpy with the same formulas. Promised:
// the fit takes at most 20 s (by the clock, or of processor time on a busy machine) and 2 GB, no mode is missed or invented,
// frequencies are within 1e-4 and loss factors within 3 %, and numpy's answers are the same. The quick run takes 20 × 20 FRFs ×
// 350 lines and 12 modes. Then N responses to one hammer point: all modes, at most three times the processor time for twice the
// responses, 30 s for 5,000 (full run).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "base/random.hpp"
#include "bench/bench.hpp"
#include "frf/noise/noise.hpp"
#include "modalfit/band/inputs.hpp"
#include "modalfit/model/fit.hpp"
#include "modalfit/model/symmetric_model.hpp"
#include "modalfit/model/synthesis.hpp"
#include "problems/case/modal_set.hpp"
#include "tests/test_folder.hpp"

namespace {

using namespace jointid;

constexpr std::size_t below = 2;

/// Coordinates, lines, and modes in the range and above it.
struct Size {
  std::size_t coordinates = 84, lines = 800, inside = 30, above = 10;
};

problems::Modes structure(const Size& size) {
  problems::Modes modes;
  const auto add = [&](double frequency, double loss) {
    modes.frequency_hz.push_back(frequency);
    modes.loss_factor.push_back(loss);
  };
  for (std::size_t r = 0; r < below; ++r) add(0.0, 0.0);
  for (std::size_t r = 0; r < size.inside + size.above; ++r) {
    const auto u = uniform_numbers({.seed = 84}, r);
    add(220.0 + (r < size.inside ? 25.0 : 60.0) * (static_cast<double>(r) + 0.6 * (u[0] - 0.5)), 0.006 + 0.01 * u[1]);
  }
  for (std::size_t i = 0; i < size.coordinates; ++i)
    modes.dofs.push_back({static_cast<std::int64_t>(i + 1), frf::Direction::z, 1});
  for (std::size_t k = 0; k < size.coordinates * modes.count(); ++k) modes.shapes.push_back(normal_numbers({.seed = 85}, k)[0]);
  return modes;
}

frf::FrfSet measurement(const problems::Modes& modes, std::size_t lines) {
  problems::ResponseRequest request{.response = modes.dofs, .reference = modes.dofs, .frequency_hz = {}};
  for (std::size_t i = 0; i < lines; ++i) request.frequency_hz.push_back(200.0 + static_cast<double>(i));
  return frf::polluted(problems::modal_response(modes, request),
                       {.kind = frf::NoiseKind::circular, .level = 0.01, .record_variance = true}, 1, 0);
}

void judge(const modalfit::ModalFit& fit, const problems::Modes& modes, std::size_t inside, bench::Promises& promises) {
  fmt::print("  {} of {} modes found\n", fit.modes_inside(), inside);
  const bool found = fit.modes_inside() == inside && fit.status == Status::ok;
  promises.holds("all modes are found and no other", found);
  if (!found) return;
  double frequency = 0.0, damping = 0.0;
  for (std::size_t r = 0; r < inside; ++r) {
    frequency = std::max(frequency, std::abs(fit.modes[r].pole.frequency_hz / modes.frequency_hz[below + r] - 1.0));
    damping = std::max(damping, std::abs(fit.modes[r].pole.damping / modes.loss_factor[below + r] - 1.0));
  }
  fmt::print("  largest relative error: frequency {:.1e}, loss factor {:.1e}\n", frequency, damping);
  promises.at_most("relative error of a frequency", frequency, 1e-4);
  promises.at_most("relative error of a loss factor", damping, 0.03);
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

/// The largest relative distance of a pole found to the nearest of ours and of theirs: poles of the structure, as those of the
/// noise depend on rounding.
double difference_of_poles(const modalfit::ModalFit& fit, const std::vector<modalfit::CandidatePole>& ours,
                           const std::vector<double>& theirs) {
  double difference = 0.0;
  for (const modalfit::Mode& mode : fit.modes) {
    const auto distance = [&mode](double frequency) { return std::abs(frequency - mode.pole.frequency_hz); };
    double a = 1e300, b = 1e300;
    for (const modalfit::CandidatePole& pole : ours) {
      if (pole.damping > 0.0 && distance(pole.frequency_hz) < distance(a)) a = pole.frequency_hz;
    }
    for (const double frequency : theirs) b = distance(frequency) < distance(b) ? frequency : b;
    difference = std::max(difference, std::abs(a - b) / b);
  }
  return difference;
}

void compare_with_peer(const modalfit::Band& band, const modalfit::ModalFit& fit, bench::Promises& promises) {
  const modalfit::PolyreferenceOptions options;
  const modalfit::InputChoice choice = modalfit::choose_inputs(band, options.inputs);
  std::vector<modalfit::OrderPoles> orders;
  const double poles_s = bench::seconds([&] { orders = modalfit::polyreference_poles(band, options); });
  std::vector<std::size_t> entries(band.entries());
  for (std::size_t e = 0; e < entries.size(); ++e) entries[e] = e;
  const auto start = Clock::now();
  const auto residues = modalfit::fit_residues(band, entries, fit.kind, fit.poles());
  const double residues_s = seconds_since(start);

  const TestFolder folder;
  write_for_peer(folder / "band.bin", band, choice, fit.poles());
  const std::size_t highest = 2 * orders.back().order / choice.inputs.size();
  const auto text = bench::peer_output(
      fmt::format("modalfit.py {} {} {} {} {} {} {} {}", (folder / "band.bin").string(), choice.outputs, choice.inputs.size(),
                  band.lines(), band.entries(), fit.modes.size(), highest, order_list(orders, choice.inputs.size())),
      promises);
  if (!text) return;
  std::istringstream answer(*text);
  std::string times, pole_line, residue_line;
  std::getline(answer, times) && std::getline(answer, pole_line) && std::getline(answer, residue_line);
  const std::vector<double> seconds = numbers(times), theirs = numbers(pole_line), coefficients = numbers(residue_line);
  fmt::print(
      "  poles of {} orders: {:.2f} s, numpy {:.2f} s; residues of {} FRFs: {:.2f} s, numpy {:.2f} s: {:.1f} times faster "
      "together\n",
      orders.size(), poles_s, seconds[0], entries.size(), residues_s, seconds[1],
      (seconds[0] + seconds[1]) / (poles_s + residues_s));
  const double pole_difference = difference_of_poles(fit, orders.back().poles, theirs);
  const std::vector<double> first(residues.coefficients.begin(),
                                  residues.coefficients.begin() + static_cast<std::ptrdiff_t>(residues.columns));
  const double residue_difference = bench::largest_difference(first, coefficients, 0, first.size());
  fmt::print("  largest relative difference: poles {:.1e}, residues {:.1e}\n", pole_difference, residue_difference);
  promises.at_most("difference of a pole from numpy's", pole_difference, 1e-5);
  promises.at_most("difference of a residue from numpy's", residue_difference, 1e-6);
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const Size size = line.quick() ? Size{.coordinates = 20, .lines = 350, .inside = 12, .above = 4} : Size{};
  const problems::Modes modes = structure(size);
  const frf::FrfSet set = measurement(modes, size.lines);
  fmt::print("{} × {} FRFs × {} lines\n", size.coordinates, size.coordinates, size.lines);
  modalfit::Band band;
  modalfit::ModalFit fit;
  bench::Times time;
  time.add([&] {
    band = modalfit::make_band(set, {});
    fit = modalfit::fit(band, set.header, {.kind = {modalfit::Damping::hysteretic, true}});
  });
  const auto start = Clock::now();
  const modalfit::SymmetricModel model = modalfit::make_symmetric(fit, band);
  const frf::FrfSet regenerated = modalfit::regenerate(model, set.header);
  const auto error = modalfit::overall(modalfit::synthesis_errors(fit, band, regenerated));
  fmt::print(
      "  fit {:.2f} s, {:.2f} s of processor time ({} FRFs refine the poles, {} iterations), symmetric model and regeneration "
      "{:.2f} s, {:.0f} MB\n",
      time.wall[0], time.processor[0], fit.refined_entries, fit.iterations, seconds_since(start), bench::peak_megabytes());
  fmt::print("  regenerated FRFs: {:.3f} dB rms from the measured ones\n", error.rms_db);
  promises.speed_at_most("fit, s", std::min(time.wall[0], time.processor[0]), 20.0);
  promises.at_most("peak memory, MB", bench::peak_megabytes(), 2048.0);
  promises.at_most("regenerated FRFs, dB rms from the measured ones", error.rms_db, 0.1);
  judge(fit, modes, size.inside, promises);
  compare_with_peer(band, fit, promises);
}

/// A scanning vibrometer: mobilities of many responses to one hammer point, 400 lines, four modes, 1 % noise that no file tells.
frf::FrfSet scan(std::size_t responses) {
  problems::Modes modes;
  modes.frequency_hz = {80.0, 123.0, 210.0, 333.0};
  modes.loss_factor = {0.02, 0.01, 0.016, 0.008};
  problems::ResponseRequest request;
  for (std::size_t i = 0; i < responses; ++i) request.response.push_back({static_cast<std::int64_t>(i + 1), frf::Direction::z, 1});
  request.reference = {request.response.front()};
  for (std::size_t i = 1; i <= 400; ++i) request.frequency_hz.push_back(static_cast<double>(i));
  modes.dofs = request.response;
  for (std::size_t k = 0; k < responses * modes.count(); ++k) modes.shapes.push_back(normal_numbers({.seed = 86}, k)[0]);
  frf::FrfSet set = frf::polluted(problems::modal_response(modes, request),
                                  {.kind = frf::NoiseKind::circular, .level = 0.01, .record_variance = false}, 1, 0);
  set.header.quantity = frf::Quantity::mobility;
  return set;
}

/// Processor time of a fit with its symmetric model and all FRFs regenerated.
double scan_seconds(std::size_t responses, bench::Promises& promises) {
  const frf::FrfSet set = scan(responses);
  bench::Times time;
  std::size_t found = 0;
  time.add([&] {
    modalfit::Band band = modalfit::make_band(set, {});
    const modalfit::ModalFit fit = modalfit::fit(band, set.header, {.kind = {modalfit::Damping::hysteretic, true}});
    modalfit::regenerate(modalfit::make_symmetric(fit, band), set.header);
    found = fit.modes_inside();
  });
  fmt::print("  {} × 1 FRFs × 400 lines: {} of 4 modes, {:.2f} s by the clock, {:.2f} s of processor time\n", responses, found,
             time.wall[0], time.processor[0]);
  promises.holds(fmt::format("all four modes of {} responses and no other", responses), found == 4);
  return time.processor[0];
}

void measure_scan(const bench::CommandLine& line, bench::Promises& promises) {
  fmt::print("scanning vibrometer\n");
  const double few = scan_seconds(400, promises), twice = scan_seconds(800, promises);
  promises.speed_at_most("time of 800 responses over that of 400", twice / few, 3.0);
  if (!line.quick()) promises.speed_at_most("5,000 responses, s of processor time", scan_seconds(5000, promises), 30.0);
}

void measure_all(const bench::CommandLine& line, bench::Promises& promises) {
  measure(line, promises);
  measure_scan(line, promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "", measure_all); }
