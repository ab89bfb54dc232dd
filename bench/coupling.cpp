// Coupling: multiplications and time of MTC against GRC on one line, and two parts of 84 × 84 FRFs × 800 lines at 40 interface
// DOFs, in memory and from files, beside numpy with the same formulas. Promised: MTC multiplies less than GRC with an
// explicit inverse, coupling the files takes at most 5 s of processor time (of two cores half of it when nobody else works), and
// numpy's answer agrees to 1e-9. The quick run takes 40 lines.
#include <fmt/core.h>

#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>

#include "base/complex.hpp"
#include "bench/bench.hpp"
#include "coupling/methods.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "tasks/couple.hpp"
#include "tests/coupling/counted_coupling.hpp"
#include "tests/test_folder.hpp"

namespace {

using namespace jointid;
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
double best_us(int rounds, const Call& call) {
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) times.push_back(1e6 * bench::seconds(call, 20));
  return bench::least(times);
}

void compare_operations(int rounds, bench::Promises& promises) {
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
    const double grc = best_us(rounds, [&] { coupling::grc(h, conditions, all); });
    const double mtc = best_us(rounds, [&] { coupling::mtc(h, conditions, all); });
    const double ratio = static_cast<double>(count.mtc) / static_cast<double>(count.grc);
    fmt::print("{:>5} {:>5} {:>12} {:>12} {:>8.3f} {:>14.3f} {:>12.1f} {:>12.1f}\n", n, m, count.grc, count.mtc, ratio,
               print_mtc / print_grc, grc, mtc);
    promises.holds(fmt::format("MTC multiplies less than GRC, {} pairs of {} coordinates", m, n),
                   m == 1 || count.mtc < count.grc);
  }
}

constexpr Index size = 84, interface_size = 40;

/// Two parts with nodes 1 … 84 and 1001 … 1084.
void write_parts(const std::filesystem::path& folder, std::size_t lines) {
  for (unsigned part = 0; part < 2; ++part) {
    frf::FrfHeader header;
    for (std::size_t line = 0; line < lines; ++line) header.frequency_hz.push_back(20.0 + static_cast<double>(line));
    for (Index k = 1; k <= size; ++k)
      header.response.push_back({static_cast<std::int64_t>(1000 * part + k), frf::Direction::y, +1});
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

void couple_files(const std::filesystem::path& folder, const char* method, bench::Times& times) {
  times.add([&] { tasks::couple(ident::read_couple_scene(folder / fmt::format("{}.toml", method)), folder / "out.h5", false); });
}

/// Both parts as the peer reads them: complex128 [line, part, 84, 84].
void write_raw(const std::filesystem::path& folder, std::size_t lines) {
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

/// Whether numpy's sum of |H| of each line is ours.
void compare_with_peer(const std::filesystem::path& folder, std::size_t lines, bench::Promises& promises) {
  write_raw(folder, lines);
  const auto text = bench::peer_output(
      fmt::format("coupling.py {} {} {} {}", (folder / "parts.bin").string(), lines, size, interface_size), promises);
  if (!text) return;
  std::istringstream in(*text);
  double peer = 0.0, worst = 0.0;
  in >> peer;
  const frf::FrfSet ours = frf::load(*frf::open_hdf5(folder / "out.h5"));
  for (std::size_t line = 0; line < lines; ++line) {
    double expected = 0.0, found = 0.0;
    in >> expected;
    for (std::size_t i = 0; i < ours.header.entries(); ++i) found += std::abs(ours.values[line * ours.header.entries() + i]);
    const double difference = std::abs(found / expected - 1.0);
    if (!(difference <= worst)) worst = difference;
  }
  fmt::print(
      "  numpy, one BLAS thread, from memory       {:8.2f} s of processor time\n  largest difference of a line's Σ|H|       "
      "{:8.1e}   at most 1e-9\n",
      peer, worst);
  promises.at_most("difference of a line's Σ|H| from numpy's", worst, 1e-9);
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t lines = line.quick() ? 40 : 800;
  const int rounds = line.quick() ? 1 : 3;
  compare_operations(line.quick() ? 1 : 7, promises);
  const TestFolder folder;
  write_parts(folder, lines);
  bench::Times mtc, grc;
  for (int round = 0; round < rounds; ++round) {
    couple_files(folder, "mtc", mtc);
    couple_files(folder, "grc", grc);
  }
  fmt::print("two parts of 84 × 84 FRFs × {} lines at 40 interface DOFs, files to file, two threads, median of {}\n", lines,
             rounds);
  const auto print = [](const char* method, const bench::Times& seconds, const char* note) {
    fmt::print("  {}                                       {:8.2f} s   of processor time {:.2f} s{}\n", method,
               median(seconds.wall), median(seconds.processor), note);
  };
  print("GRC", grc, ", below 5");
  print("MTC", mtc, "");
  fmt::print("  peak memory                               {:8.0f} MB\n", bench::peak_megabytes());
  promises.speed_at_most("processor time of GRC, s", median(grc.processor), 5.0);
  compare_with_peer(folder, lines, promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "", measure); }
