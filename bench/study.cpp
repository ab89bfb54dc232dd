// Studies of case A1 (WBS): 10,000 trials on one and two threads, and one solution against numpy on the same FRFs.
// Exit code 1 when 10,000 trials take 3 s or more on 2 threads, 2 threads are less than 1.8 times faster than one, a solution
// is less than 25 times cheaper than numpy's, or the answers differ by more than 1e-9 of the largest element.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "ident/study.hpp"
#include "ident/trial_runner.hpp"
#include "problems/in_memory.hpp"

namespace {

using namespace jointid;

constexpr std::size_t coordinates = 14, compared = 20;

struct Seconds {
  double wall = 1e9, processor = 1e9;
};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void run(const std::shared_ptr<const ident::TrialData>& data, std::size_t threads, Seconds& best) {
  ident::StudyOptions options;
  options.trials = 10000;
  options.threads = threads;
  options.out = std::filesystem::temp_directory_path() / "jointid_bench_study.h5";
  const auto team = ident::make_team_of_one();
  const double start = processor_seconds();
  best.wall = std::min(best.wall, ident::run_study(data, options, *team).wall_s);
  best.processor = std::min(best.processor, processor_seconds() - start);
  std::filesystem::remove(options.out);
}

/// Joint coordinates last.
std::vector<frf::Dof> order(const problems::Problem& problem) {
  std::vector<frf::Dof> dofs;
  for (const frf::Dof& dof : problem.assembly.header.response) {
    if (frf::find_coordinate(problem.joint_dofs, dof) == frf::npos) dofs.push_back(dof);
  }
  dofs.insert(dofs.end(), problem.joint_dofs.begin(), problem.joint_dofs.end());
  return dofs;
}

void add_set(const frf::FrfSet& set, const std::vector<frf::Dof>& dofs, std::vector<frf::Complex>& out) {
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t i = 0; i < dofs.size(); ++i) {
      for (std::size_t j = 0; j < dofs.size(); ++j) {
        const std::size_t r = frf::find_coordinate(set.header.response, dofs[i]);
        const std::size_t c = frf::find_coordinate(set.header.reference, dofs[j]);
        if (r != frf::npos && c != frf::npos) out[(line * dofs.size() + i) * dofs.size() + j] += set.values[set.index(line, r, c)];
      }
    }
  }
}

/// Both systems of some trials as the peer reads them.
void write_trials(const problems::Problem& problem, const std::filesystem::path& file) {
  const std::vector<frf::Dof> dofs = order(problem);
  std::ofstream out(file, std::ios::binary);
  for (std::size_t trial = 0; trial < compared; ++trial) {
    const problems::Measurement measurement = problems::polluted(problem, 1, trial);
    const std::size_t size = measurement.assembly.header.lines() * coordinates * coordinates;
    std::vector<frf::Complex> substructures(size), assembly(size);
    for (const frf::FrfSet& set : measurement.substructures) add_set(set, dofs, substructures);
    add_set(measurement.assembly, dofs, assembly);
    for (const auto* matrix : {&substructures, &assembly}) {
      out.write(reinterpret_cast<const char*>(matrix->data()), static_cast<std::streamsize>(size * sizeof(frf::Complex)));
    }
  }
}

std::string output_of(const std::string& command) {
  std::string text;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text.push_back(static_cast<char>(c));
  return pclose(pipe) == 0 ? text : std::string();
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b, std::size_t first, std::size_t last) {
  double difference = 0.0, largest = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
  }
  return difference / largest;
}

bool compare_with_peer(const problems::Problem& problem, const std::shared_ptr<const ident::TrialData>& data) {
  const auto file = std::filesystem::temp_directory_path() / "jointid_bench_study.bin";
  write_trials(problem, file);
  ident::TrialRunner runner(data);
  std::istringstream peer(output_of(fmt::format("/usr/bin/python3 {}/study_a1.py {} {} {} 2>/dev/null", JOINTID_PEER_DIR,
                                                file.string(), compared, problem.assembly.header.lines())));
  std::filesystem::remove(file);
  double peer_seconds = 0.0, seconds = 1.0, difference = 0.0;
  if (!(peer >> peer_seconds)) {
    fmt::print("  numpy is missing (python3-numpy): nothing to compare with\n");
    return true;
  }
  for (int round = 0; round < 10; ++round) {
    double sum = 0.0;
    for (std::size_t trial = 0; trial < compared; ++trial) sum += runner.run(1, trial).solve_s;
    seconds = std::min(seconds, sum / compared);
  }
  for (std::size_t trial = 0; trial < compared; ++trial) {
    std::vector<double> theirs(20);
    for (double& value : theirs) peer >> value;
    const std::vector<double> ours = runner.run(1, trial).values;
    difference = std::max({difference, largest_difference(ours, theirs, 0, 10), largest_difference(ours, theirs, 10, 20)});
  }
  fmt::print("  one solution, numpy            {:8.3f} ms\n", 1e3 * peer_seconds);
  fmt::print("  one solution, jointid          {:8.3f} ms\n", 1e3 * seconds);
  fmt::print("  ratio                          {:8.1f}     at least 25\n", peer_seconds / seconds);
  fmt::print("  largest difference             {:8.1e}     of the largest element, at most 1e-9\n", difference);
  return peer_seconds / seconds >= 25.0 && difference <= 1e-9;
}

}  // namespace

int main() {
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  const problems::Problem problem = problems::make("A1");
  ident::Scene scene = problems::scene(problem);
  scene.identify.weighting = weighting::Weighting::wbs;
  const auto data = problems::trial_data(scene, problem);
  Seconds one, two;
  for (int round = 0; round < 5; ++round) {
    run(data, 1, one);
    run(data, 2, two);
  }
  fmt::print("case A1, 31 lines, nn + nj, WBS, 5 % noise; best of 5 rounds in turns\n");
  fmt::print("  10,000 trials, 1 thread        {:8.2f} s      of processor time {:.2f} s\n", one.wall, one.processor);
  fmt::print("  10,000 trials, 2 threads       {:8.2f} s      less than 3; of processor time {:.2f} s\n", two.wall, two.processor);
  fmt::print("  ratio                          {:8.2f}        at least 1.8, when no other program needs the processors\n",
             one.wall / two.wall);
  const bool peer_holds = compare_with_peer(problem, data);
  return two.wall < 3.0 && one.wall / two.wall >= 1.8 && peer_holds ? 0 : 1;
}
