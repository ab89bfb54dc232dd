// The likelihood of 1,000 lines shared by two processes that mpirun started, beside one: time of the solution as it tells it
// (runtime_s.total, without the start of MPI), the command with one thread each, in turns; median of five.
// Promised: two are 1.8 times as fast as one, and both find the same joint to 1e-10. The quick run takes 60 lines.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "bench/bench.hpp"
#include "bench/random_structures.hpp"
#include "frf/file/write.hpp"
#include "tests/test_folder.hpp"

namespace {

using namespace jointid;

constexpr double level = 0.01;

void write_scene(const std::filesystem::path& folder, std::size_t lines) {
  bench::RandomSets sets = bench::random_sets(lines);
  std::mt19937 generator(3);
  for (const auto& [name, set] : {std::pair("a.h5", &sets.a), std::pair("b.h5", &sets.b), std::pair("both.h5", &sets.both)}) {
    bench::pollute(*set, level, generator);
    frf::write(*set, folder / name);
  }
  const std::string dofs = comma_list(bench::random_joint(), [](const frf::Dof& dof) { return fmt::format("\"{}\"", dof.name()); });
  std::ofstream(folder / "scene.toml") << fmt::format(
      "[data]\nsubstructures = [\"a.h5\", \"b.h5\"]\nassembly = [\"both.h5\"]\n[joint]\ndofs = [{}]\n"
      "[joint.stiffness]\npattern = \"symmetric\"\n[joint.hysteretic_damping]\npattern = \"symmetric\"\n"
      "[identify]\nmethod = \"likelihood\"\n",
      dofs);
}

struct Run {
  double seconds = 0.0;
  std::vector<double> values;
};

Run run(const std::string& mpirun, const std::string& jointid, int processes, const std::filesystem::path& folder) {
  const std::string json = folder / "result.json";
  const std::string command =
      fmt::format("{} --allow-run-as-root --oversubscribe -n {} {} solve {} --threads 1 --json {} > /dev/null", mpirun, processes,
                  jointid, (folder / "scene.toml").string(), json);
  if (std::system(command.c_str()) != 0) throw std::runtime_error(command + " failed");
  const auto result = nlohmann::json::parse(std::ifstream(json));
  Run out{result["runtime_s"]["total"].get<double>(), {}};
  for (const auto& unknown : result["unknowns"]) out.values.push_back(unknown["value"].get<double>());
  return out;
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::string jointid = line.word(0, ""), mpirun = line.word(1, "mpirun");
  if (!std::filesystem::exists(mpirun)) {
    promises.skip("there is no mpirun");
    return;
  }
  const TestFolder folder;
  const std::size_t lines = line.quick() ? 60 : 1000;
  write_scene(folder / "", lines);
  std::vector<double> one_times, two_times, ratios;
  double difference = 0.0;
  for (int round = 0; round < (line.quick() ? 1 : 5); ++round) {
    const Run one = run(mpirun, jointid, 1, folder / ""), two = run(mpirun, jointid, 2, folder / "");
    one_times.push_back(one.seconds);
    two_times.push_back(two.seconds);
    ratios.push_back(one.seconds / two.seconds);
    for (std::size_t i = 0; i < one.values.size(); ++i)
      difference = std::max(difference, std::abs(two.values.at(i) / one.values[i] - 1.0));
  }
  fmt::print(
      "{} lines x (20 + 4) coordinates: one process {:.2f} s, two {:.2f} s; {:.2f} times as fast, at least 1.8; difference "
      "{:.1g}\n",
      lines, median(one_times), median(two_times), median(ratios), difference);
  promises.speed_at_least("two processes, times as fast as one", median(ratios), 1.8);
  promises.at_most("relative difference of an unknown", difference, 1e-10);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "JOINTID MPIRUN", measure); }
