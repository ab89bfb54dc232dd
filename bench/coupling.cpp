// Coupling: multiplications and time of MTC against GRC on one line, and two parts of 84 × 84 FRFs × 800 lines at 40 interface
// DOFs, in memory and from files, beside numpy with the same formulas. Exit code 1 when MTC multiplies more than GRC with an
// explicit inverse, coupling the files takes 5 s or more of processor time (of two cores half of it when nobody else works), or
// numpy's answer differs by more than 1e-9.
#include <fmt/format.h>
#include <sys/resource.h>

#include <Eigen/LU>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>

#include "base/stopwatch.hpp"
#include "bench/measure.hpp"
#include "bench/output_of.hpp"
#include "coupling/methods.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "ident/tasks/couple.hpp"
#include "tests/coupling/counted_coupling.hpp"

namespace {

using namespace jointid;
using Complex;
using coupling::ComplexMatrix;
using coupling::Index;
/// A symmetric modal receptance of n coordinates at one frequency.
class Modal {
 public:
  Modal(Index n, unsigned seed) : shapes_(n, n) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    for (double& value : shapes_.reshaped()) value = 0.3 * normal(generator);
    for (Index r = 0; r < n; ++r) omega_.push_back(2.0 * std::numbers::pi * (30.0 + 17.0 * static_cast<double>(r)));
  }

  ComplexMatrix at(double frequency_hz) const {
    const double omega = 2.0 * std::numbers::pi * frequency_hz;
    Eigen::VectorXcd modal(shapes_.cols());
    for (Index r = 0; r < modal.size(); ++r) {
      const double square = omega_[static_cast<std::size_t>(r)] * omega_[static_cast<std::size_t>(r)];
      modal[r] = 1.0 / Complex(square - omega * omega, 0.01 * square);
    }
    return shapes_ * modal.asDiagonal() * shapes_.transpose();
  }

 private:
  Eigen::MatrixXd shapes_;
  std::vector<double> omega_;
};

/// Best time of one call over some rounds, µs.
template <class Call>
double best_us(Call call) {
  double best = 1e9;
  for (int round = 0; round < 7; ++round) {
    constexpr int repeats = 20;
    const auto start = Clock::now();
    for (int i = 0; i < repeats; ++i) call();
    best = std::min(best, 1e6 * seconds_since(start) / repeats);
  }
  return best;
}

bool compare_operations() {
  bool less = true;
  fmt::print("multiplications and time of one line, n coordinates, m pairs\n");
  fmt::print("{:>5} {:>5} {:>12} {:>12} {:>8} {:>14} {:>12} {:>12}\n", "n", "m", "GRC", "MTC", "MTC/GRC", "print, figure",
             "GRC, µs", "MTC, µs");
  for (const auto& [n, m] :
       {std::pair<Index, Index>{12, 1}, {12, 3}, {12, 6}, {40, 5}, {40, 10}, {40, 20}, {120, 20}, {120, 40}, {120, 60}}) {
    const ComplexMatrix h = Modal(n, 1).at(100.0);
    const auto count = coupling::count_multiplications(h, m);
    // (5.45) over (5.46) of docs/formulas.md §8, which is what figure 5.4 plots.
    double print_mtc = 0.0, print_grc = static_cast<double>(m * n * (n - m) + m * m);
    for (Index i = 1; i <= m; ++i) print_mtc += static_cast<double>((n - i) * (n + 1 - i));
    for (Index i = 1; i < m; ++i) print_grc += static_cast<double>(2 * (m - i) * (m + 1));
    coupling::Conditions conditions;
    for (Index p = 0; p < m; ++p) conditions.push_back({p, p + m, 1.0});
    const coupling::Wanted all = coupling::everything(h);
    const double grc = best_us([&] { coupling::grc(h, conditions, all); });
    const double mtc = best_us([&] { coupling::mtc(h, conditions, all); });
    const double ratio = static_cast<double>(count.mtc) / static_cast<double>(count.grc);
    fmt::print("{:>5} {:>5} {:>12} {:>12} {:>8.3f} {:>14.3f} {:>12.1f} {:>12.1f}\n", n, m, count.grc, count.mtc, ratio,
               print_mtc / print_grc, grc, mtc);
    less = less && (m == 1 || count.mtc < count.grc);
  }
  return less;
}

constexpr Index size = 84, interface_size = 40;
constexpr std::size_t lines = 800;

/// Two parts with nodes 1 … 84 and 1001 … 1084.
void write_parts(const std::filesystem::path& folder) {
  for (unsigned part = 0; part < 2; ++part) {
    frf::FrfHeader header;
    for (std::size_t line = 0; line < lines; ++line) header.frequency_hz.push_back(20.0 + static_cast<double>(line));
    for (Index k = 1; k <= size; ++k) header.response.push_back({static_cast<std::int64_t>(1000 * part + k), frf::Direction::y, +1});
    header.reference = header.response;
    frf::Hdf5Writer writer(folder / fmt::format("part{}.h5", part), header);
    const Modal modal(size, part + 1);
    for (std::size_t line = 0; line < lines; ++line) {
      const ComplexMatrix h = modal.at(header.frequency_hz[line]);  // symmetric: columns are rows
      writer.write_lines(line, 1, {h.data(), static_cast<std::size_t>(size * size)});
    }
    writer.finish();
  }
  std::string join;
  for (Index k = 1; k <= interface_size; ++k) join += fmt::format("[\"{}:+Y\", \"{}:+Y\"], ", k, 1000 + k);
  for (const char* method : {"grc", "mtc"}) {
    std::ofstream(folder / fmt::format("{}.toml", method))
        << "[data]\nparts = [\"part0.h5\", \"part1.h5\"]\n[couple]\njoin = [" << join << "]\nmethod = \"" << method << "\"\n";
  }
}

/// By the clock, and of all threads.
struct Seconds {
  std::vector<double> wall, processor;
};

void couple_files(const std::filesystem::path& folder, const char* method, Seconds& out) {
  const auto start = Clock::now();
  const std::clock_t used = std::clock();
  ident::couple(ident::read_couple_scene(folder / fmt::format("{}.toml", method)), folder / "out.h5", false);
  out.wall.push_back(seconds_since(start));
  out.processor.push_back(static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC);
}

/// Both parts as the peer reads them: complex128 [line, part, 84, 84].
void write_raw(const std::filesystem::path& folder) {
  std::ofstream out(folder / "parts.bin", std::ios::binary);
  const Modal parts[] = {Modal(size, 1), Modal(size, 2)};
  for (std::size_t line = 0; line < lines; ++line) {
    for (const Modal& part : parts) {
      const ComplexMatrix h = part.at(20.0 + static_cast<double>(line));
      out.write(reinterpret_cast<const char*>(h.data()),
                static_cast<std::streamsize>(sizeof(Complex) * static_cast<std::size_t>(h.size())));
    }
  }
}

/// Whether numpy's sum of |H| of each line is ours; true without numpy.
bool compare_with_peer(const std::filesystem::path& folder) {
  write_raw(folder);
  const std::string text = bench::output_of(fmt::format("/usr/bin/python3 {}/coupling.py {} {} {} {} 2>/dev/null", JOINTID_PEER_DIR,
                                                 (folder / "parts.bin").string(), lines, size, interface_size));
  if (text.empty()) {
    fmt::print("  numpy is missing (python3-numpy): nothing to compare with\n");
    return true;
  }
  std::istringstream in(text);
  double peer = 0.0, worst = 0.0;
  in >> peer;
  const frf::FrfSet ours = frf::load(*frf::open_hdf5(folder / "out.h5"));
  for (std::size_t line = 0; line < lines; ++line) {
    double expected = 0.0, found = 0.0;
    in >> expected;
    for (std::size_t i = 0; i < ours.header.entries(); ++i) found += std::abs(ours.values[line * ours.header.entries() + i]);
    worst = std::max(worst, std::abs(found / expected - 1.0));
  }
  fmt::print(
      "  numpy, one BLAS thread, from memory       {:8.2f} s of processor time\n  largest difference of a line's Σ|H|       "
      "{:8.1e}   at most 1e-9\n",
      peer, worst);
  return worst <= 1e-9;
}

}  // namespace

int main() {
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  const bool less = compare_operations();
  const auto folder = std::filesystem::temp_directory_path() / "jointid_bench_coupling";
  std::filesystem::create_directories(folder);
  write_parts(folder);
  Seconds grc, mtc;
  for (int round = 0; round < 3; ++round) {
    couple_files(folder, "mtc", mtc);
    couple_files(folder, "grc", grc);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print("two parts of 84 × 84 FRFs × 800 lines at 40 interface DOFs, files to file, two threads, median of 3\n");
  const auto print = [](const char* method, const Seconds& seconds, const char* note) {
    fmt::print("  {}                                       {:8.2f} s   of processor time {:.2f} s{}\n", method, bench::median(seconds.wall),
               bench::median(seconds.processor), note);
  };
  print("GRC", grc, ", below 5");
  print("MTC", mtc, "");
  fmt::print("  peak memory                               {:8.0f} MB\n", static_cast<double>(usage.ru_maxrss) / 1024.0);
  const bool same = compare_with_peer(folder);
  std::filesystem::remove_all(folder);
  return less && bench::median(grc.processor) < 5.0 && same ? 0 : 1;
}
