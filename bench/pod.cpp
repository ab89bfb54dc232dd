// Proper orthogonal decomposition of a record of 64 channels, 1,000,000 samples (quick: 20,000), by the streamed QR: from text,
// binary UFF 58 and HDF5, beside reading it alone. Promised: values to 1e-12 of those that the record was made of, at most 1.5
// times the time of reading from text and 2 times from UFF and HDF5, memory below 50 MB, at most 8 MB more for 61 times as many samples.
#include "oscillation/pod/pod.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>

#include "base/temporary_file.hpp"
#include "bench/bench.hpp"
#include "frf/hdf5/table_file.hpp"
#include "records/file/open_samples.hpp"

namespace {

using namespace jointid;
using namespace jointid::oscillation;

constexpr std::size_t channels = 64;
constexpr std::size_t least_of_a_full_block = 16'384;  ///< samples that fill all buffers of two threads

/// Ten standing waves of whole numbers of turns, made block by block.
class Waves {
 public:
  explicit Waves(std::size_t samples) : samples_(samples), shapes_(at(10), at(channels)) {
    for (std::size_t k = 0; k < channels; ++k) {
      for (std::size_t w = 0; w < 10; ++w) {  // a discrete cosine basis: orthonormal
        shapes_(at(w), at(k)) = std::sqrt(2.0 / channels) * std::cos(std::numbers::pi * (static_cast<double>(k) + 0.5) *
                                                                     static_cast<double>(w + 1) / channels);
      }
    }
  }
  std::size_t operator()(Samples& block) {
    const std::size_t count = std::min(static_cast<std::size_t>(block.rows()), samples_ - next_);
    Samples waves(at(count), at(10));
    for (std::size_t i = 0; i < count; ++i) {
      const double turns = static_cast<double>(next_ + i) / static_cast<double>(samples_);
      for (std::size_t w = 0; w < 10; ++w) {
        waves(at(i), at(w)) =
            std::pow(0.3, static_cast<double>(w)) * std::cos(2.0 * std::numbers::pi * static_cast<double>(w + 3) * turns);
      }
    }
    block.topRows(at(count)) = waves * shapes_;
    next_ += count;
    return count;
  }

 private:
  std::size_t samples_, next_ = 0;
  Samples shapes_;
};

/// Calls `write` with block after block of the record.
template <class Write>
void make_record(std::size_t samples, const Write& write) {
  Waves waves(samples);
  Samples block(4096, at(channels));
  for (std::size_t count = waves(block); count > 0; count = waves(block)) write(block.topRows(at(count)));
}

void write_text_record(const std::filesystem::path& path, std::size_t samples) {
  std::ofstream file(path, std::ios::binary);
  make_record(samples, [&](const auto& block) {
    fmt::memory_buffer text;
    for (Eigen::Index i = 0; i < block.rows(); ++i) {
      for (Eigen::Index k = 0; k < block.cols(); ++k)
        fmt::format_to(std::back_inserter(text), "{}{}", k > 0 ? "," : "", block(i, k));
      text.push_back('\n');
    }
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
  });
}

/// A dataset 58b a channel.
void write_uff_record(const std::filesystem::path& path, std::size_t samples) {
  std::vector<std::ofstream::pos_type> place;
  std::ofstream file(path, std::ios::binary);
  for (std::size_t k = 0; k < channels; ++k) {
    file << fmt::format("    -1\n    58b{:6}{:6}{:12}{:12}{:6}{:6}{:12}{:12}\n", 1, 2, 11, 8 * samples, 0, 0, 0, 0);
    for (int line = 0; line < 5; ++line) file << "NONE\n";
    file << fmt::format("{:5}{:10}{:5}{:10} {:>10}{:10}{:4} {:>10}{:10}{:4}\n", 1, 0, 0, 0, "NONE", k + 1, 3, "NONE", 0, 0);
    file << fmt::format("{:10}{:10}{:10}{:13.5e}{:13.5e}{:13.5e}\n", 4, samples, 1, 0.0, 0.001, 0.0);
    for (const int type : {17, 8, 0, 0}) file << fmt::format("{:10}{:5}{:5}{:5} {:<20} {:<20}\n", type, 0, 0, 0, "NONE", "NONE");
    place.push_back(file.tellp());
    file.seekp(static_cast<std::streamoff>(8 * samples), std::ios::cur);
    file << "    -1\n";
  }
  std::streamoff done = 0;
  make_record(samples, [&](const auto& block) {
    for (std::size_t k = 0; k < channels; ++k) {
      const Eigen::VectorXd column = block.col(at(k));
      file.seekp(place[k] + done);
      file.write(reinterpret_cast<const char*>(column.data()), static_cast<std::streamsize>(8 * column.size()));
    }
    done += static_cast<std::streamoff>(8 * block.rows());
  });
}

/// A dataset "rows", a column a channel.
void write_hdf5_record(const std::filesystem::path& path, std::size_t samples) {
  frf::TableWriter table(path, {{}, std::vector<frf::TableColumn>(channels, {"x", "m", 0.0})}, samples);
  make_record(samples, [&](const auto& block) {
    const Samples rows = block;
    table.append({rows.data(), static_cast<std::size_t>(rows.size())});
  });
  table.finish();
}

struct Record {
  std::filesystem::path path;
  std::vector<std::string> names = {};  ///< of the channels; empty: all

  std::unique_ptr<records::SampleStream> open() const { return records::open_samples(path, {names}); }
};

Pod decomposed(const Record& record, std::size_t threads) {
  const auto stream = record.open();
  const auto next = [&](std::span<double> rows) { return stream->read(rows); };
  return pod(record_triangle(channels, next, threads));
}

/// Of processor time, so that other work on the machine does not count.
template <class Work>
double work_seconds(const Work& work) {
  const double before = bench::processor_seconds();
  work();
  return bench::processor_seconds() - before;
}

void only_read(const Record& record) {
  const auto stream = record.open();
  std::vector<double> block(4096 * channels);
  while (stream->read(block) > 0) {
  }
}

double largest_error(const Pod& found) {
  double worst = 0.0;
  for (int w = 0; w < 10; ++w) worst = std::max(worst, std::abs(found.values(w) - 0.5 * std::pow(0.09, w)));
  return worst;
}

/// Reading alone and reading with decomposing, the least processor time of three of each in turns.
void measure_file(const std::string& what, const Record& record, std::size_t samples, double most,
                  bench::Promises& promises) {
  only_read(record);  // the first time the file comes from the disk
  double reading = HUGE_VAL, alone = HUGE_VAL;
  Pod one, two;
  for (int round = 0; round < 3; ++round) {
    reading = std::min(reading, work_seconds([&] { only_read(record); }));
    alone = std::min(alone, work_seconds([&] { one = decomposed(record, 1); }));
  }
  const double clock_one = bench::seconds([&] { one = decomposed(record, 1); }),
               clock_two = bench::seconds([&] { two = decomposed(record, 2); });
  const double unit = 1e6 / static_cast<double>(samples);
  fmt::print("{:<10}{:>8.2f}{:>16.2f}{:>8.2f}{:>16.2f}{:>12.2f}\n", what, reading * unit, alone * unit, alone / reading,
             clock_one * unit, clock_two * unit);
  promises.at_most(what + ": values less the true ones", largest_error(one), 1e-12);
  promises.holds(what + ": the same on two threads", one.sigma == two.sigma);
  promises.speed_at_most(what + ": reading and decomposing, times reading", alone / reading, most);
}

/// Runs `work` in a process of its own, whose memory does not count.
template <class Work>
void elsewhere(const Work& work) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      work();
    } catch (...) {
      _exit(1);
    }
    _exit(0);
  }
  int status = 1;
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0) throw std::runtime_error("cannot write a record");
}

/// Calls visit(what, record, most times reading) with the record as text, UFF and HDF5. None is ever committed.
template <class Visit>
void with_files(std::size_t samples, const Visit& visit) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  {
    const TemporaryFile text(folder / "jointid-bench-pod.csv");
    elsewhere([&] { write_text_record(text.path(), samples); });
    visit("text", Record{text.path()}, 1.5);
  }
  {
    const TemporaryFile uff(folder / "jointid-bench-pod.uff");
    elsewhere([&] { write_uff_record(uff.path(), samples); });
    visit("UFF 58b", Record{uff.path()}, 2.0);
  }
  const TemporaryFile hdf5(folder / "jointid-bench-pod.h5");
  elsewhere([&] { write_hdf5_record(hdf5.path(), samples); });
  Record rows{hdf5.path()};
  for (std::size_t k = 1; k <= channels; ++k) rows.names.push_back(fmt::format("rows({})", k));
  visit("HDF5", rows, 2.0);
}

/// Peaks of this process after records of more and more samples of all formats, on two threads.
void measure_memory(std::size_t most, bench::Promises& promises) {
  std::vector<double> peaks;
  fmt::print("{:>12}{:>18}\n", "samples", "peak memory, MB");
  for (const std::size_t part : {64u, 16u, 4u, 1u}) {
    const std::size_t samples = std::max(most / part, least_of_a_full_block);
    with_files(samples, [](const char*, const Record& record, double) { decomposed(record, 2); });
    peaks.push_back(bench::peak_megabytes());
    fmt::print("{:>12}{:>18.1f}\n", samples, peaks.back());
  }
  promises.at_most("memory of the longest record, MB", peaks.back(), 50.0);
  promises.at_most("growth of memory from the shortest record to the longest, MB", peaks.back() - peaks.front(), 8.0);
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t samples = line.count(0, 1'000'000, 20'000);
  measure_memory(samples, promises);
  fmt::print("{} samples of {} channels, us a sample: processor time, by the clock\n{:<10}{:>8}{:>16}{:>8}{:>16}{:>12}\n",
             samples, channels, "", "read", "and decompose", "times", "clock 1 thread", "2 threads");
  with_files(samples, [&](const char* what, const Record& record, double most) {
    measure_file(what, record, samples, most, promises);
  });
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SAMPLES]", measure); }
