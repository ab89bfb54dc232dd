// A scene of 200 non-joint and 12 joint coordinates × 1,600 lines, about 2.3 GB of HDF5: the command `jointid solve` against
// `cat` of the same files from a warm cache, in turns. Promised: it takes at most 5 times as long and 300 MB, and finds the true
// springs to 1e-6. The files are written once into DIRECTORY and kept; without DIRECTORY they go. The quick run takes 20 lines.
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "bench/bench.hpp"
#include "dense/lu.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "tests/test_folder.hpp"

namespace {

using namespace jointid;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using RowMatrixXcd = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr Index free_count = 200, joint_count = 12, count = free_count + joint_count, modes = 60;
constexpr double stiffness = 2e5, damping = 2e3;

std::vector<frf::Dof> dofs() {
  std::vector<frf::Dof> all;
  for (std::int64_t node = 1; node <= count; ++node) all.push_back({node, frf::Direction::y, +1});
  return all;
}

/// Six springs between the joint coordinates 1–7, 2–8, …, each with its own stiffness.
MatrixXcd joint_impedance() {
  MatrixXcd z = MatrixXcd::Zero(joint_count, joint_count);
  for (Index s = 0; s < joint_count / 2; ++s) {
    const Complex k = (1.0 + 0.1 * static_cast<double>(s)) * Complex(stiffness, damping);
    const Index t = s + joint_count / 2;
    z(s, s) += k;
    z(t, t) += k;
    z(s, t) -= k;
    z(t, s) -= k;
  }
  return z;
}

/// Modal receptances of a made-up structure, and those of the same structure with the joint.
void write_files(const std::filesystem::path& directory, std::size_t lines) {
  std::mt19937_64 generator(1);
  std::normal_distribution<double> normal;
  MatrixXd shapes(count, modes);
  for (double& value : shapes.reshaped()) value = 0.3 * normal(generator);
  frf::FrfHeader header;
  for (std::size_t line = 0; line < lines; ++line) header.frequency_hz.push_back(20.0 + 0.5 * static_cast<double>(line));
  header.response = header.reference = dofs();
  frf::Hdf5Writer substructure(directory / "substructure.h5", header), assembly(directory / "assembly.h5", header);
  const MatrixXcd z = joint_impedance();
  for (std::size_t line = 0; line < lines; ++line) {
    const double omega = 2.0 * M_PI * header.frequency_hz[line];
    VectorXcd modal(modes);
    for (Index r = 0; r < modes; ++r) {
      const double omega_r = 2.0 * M_PI * (30.0 + 17.0 * static_cast<double>(r));
      modal[r] = 1.0 / Complex(omega_r * omega_r - omega * omega, 0.01 * omega_r * omega_r);
    }
    const RowMatrixXcd h = shapes * modal.asDiagonal() * shapes.transpose();
    const MatrixXcd h_bb = h.bottomRightCorner(joint_count, joint_count);
    const MatrixXcd x = dense::solve(MatrixXcd::Identity(joint_count, joint_count) + z * h_bb, z);
    const RowMatrixXcd with_joint = h - h.rightCols(joint_count) * x * h.bottomRows(joint_count);
    const std::size_t values = static_cast<std::size_t>(count * count);
    substructure.write_lines(line, 1, {h.data(), values});
    assembly.write_lines(line, 1, {with_joint.data(), values});
  }
  substructure.finish();
  assembly.finish();
}

void write_scene(const std::filesystem::path& directory) {
  std::string joint_dofs, springs;
  for (Index s = 0; s < joint_count; ++s) joint_dofs += fmt::format("\"{}:+Y\", ", free_count + 1 + s);
  for (Index s = 0; s < joint_count / 2; ++s) {
    springs += fmt::format("[\"{}:+Y\", \"{}:+Y\"], ", free_count + 1 + s, free_count + 1 + s + joint_count / 2);
  }
  std::ofstream(directory / "scene.toml") << fmt::format(
      "[data]\nsubstructures = [\"substructure.h5\"]\nassembly = [\"assembly.h5\"]\n"
      "[joint]\ndofs = [{}]\n[joint.stiffness]\nsprings = [{}]\n[joint.hysteretic_damping]\nsprings = [{}]\n"
      "[identify]\nequations = [\"nn\", \"nj\"]\nweighting = \"WBS\"\n",
      joint_dofs, springs, springs);
}

struct Run {
  double seconds = 0.0;
  double megabytes = 0.0;
  int status = 0;
};

Run run(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const auto start = Clock::now();
  const pid_t child = fork();
  if (child == 0) {
    const int null = open("/dev/null", O_WRONLY);
    dup2(null, STDOUT_FILENO);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  return {seconds_since(start), static_cast<double>(usage.ru_maxrss) / 1024.0, status};
}

/// Largest relative error of the twelve springs in the written result.
double largest_error(const std::filesystem::path& json_file) {
  const auto result = nlohmann::json::parse(std::ifstream(json_file));
  double error = 0.0;
  for (std::size_t i = 0; i < 12; ++i) {
    const double exact = (i < 6 ? stiffness : damping) * (1.0 + 0.1 * static_cast<double>(i % 6));
    const double here = std::abs(result["unknowns"][i]["value"].get<double>() / exact - 1.0);
    if (!(here <= error)) error = here;
  }
  return error;
}

void measure_in(const std::filesystem::path& directory, const std::string& command, bool quick, bench::Promises& promises) {
  const std::size_t lines = quick ? 20 : 1600;
  if (!exists(directory / "assembly.h5")) write_files(directory, lines);
  write_scene(directory);
  const std::string sub = directory / "substructure.h5", assembly = directory / "assembly.h5";
  const std::string scene = directory / "scene.toml", json = directory / "result.json";
  const int rounds = quick ? 1 : 7;
  std::vector<double> cat_times, solve_times, ratios, memory;
  run({"cat", sub, assembly});  // warms the cache
  for (int round = 0; round < rounds; ++round) {
    const Run cat = run({"cat", sub, assembly}), solve = run({command, "solve", scene, "--json", json});
    promises.holds(fmt::format("{} solve {} ends with 0", command, scene), solve.status == 0);
    if (solve.status != 0) return;
    cat_times.push_back(cat.seconds);
    solve_times.push_back(solve.seconds);
    ratios.push_back(solve.seconds / cat.seconds);
    memory.push_back(solve.megabytes);
  }
  const double error = largest_error(json), peak = *std::max_element(memory.begin(), memory.end());
  fmt::print("200 + 12 coordinates, {} lines, {:.2f} GB, nn + nj, WBS, 12 unknowns; median of {} rounds in turns\n", lines,
             static_cast<double>(file_size(directory / "assembly.h5") + file_size(directory / "substructure.h5")) / 1e9, rounds);
  fmt::print("  cat of both files   {:7.3f} s\n  jointid solve       {:7.3f} s\n", median(cat_times), median(solve_times));
  fmt::print("  ratio               {:7.1f}     at most 5\n", median(ratios));
  fmt::print("  peak memory         {:7.0f} MB  below 300\n  largest error       {:7.1e}     at most 1e-6\n", peak, error);
  promises.speed_at_most("times as long as cat", median(ratios), 5.0);
  promises.at_most("peak memory, MB", peak, 300.0);
  promises.at_most("relative error of a spring", error, 1e-6);
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const TestFolder folder;
  const std::filesystem::path directory = std::filesystem::path(line.word(1, folder / "")) / (line.quick() ? "quick" : "full");
  std::filesystem::create_directories(directory);
  measure_in(directory, line.word(0, ""), line.quick(), promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "JOINTID [DIRECTORY]", measure); }
