// Studies of friction laws from vibration: one joint between the mass of problem sdof-iwan and ground, bilinear, Ren, Shoukry,
// Iwan, planned levels of 2, 6, 15 and 40 N with harmonics 1 and 3, 12 lines, 1 % circular noise on the FRFs of the part, 1 and 3
// % on the phasors. Promised: the rms error of parameters, stiffness and limit over the bound is 1.1 in the mean and 1.3 at
// worst, 95 % intervals cover 92 to 97 %; of all four laws the true one is chosen in 95 % of the tests, and with levels that only
// press the joint, where the laws are the same but Iwan's, which slips from the first force on, the answer says in 95 % of the
// tests that it cannot tell them apart, and rules the true one out in none of 20.
#include "laws/task/law_study.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "bench/bench.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "problems/vibration/law_problem_cases.hpp"

namespace {

using namespace jointid;

struct Law {
  const char *name, *parameters;
  bool begins_as_spring = true;
};
constexpr Law all_laws[] = {{"bilinear", "a = 2.5e-5, k = 4e5"},
                            {"ren", "a = 1e-5, b = 2.0, k = 4e5"},
                            {"shoukry", "a = 10.0, b = 4e4"},
                            {"iwan", "f = 10.0, k = 4e5, chi = -0.4, beta = 0.5", false}};

/// N. The joint slips from 10 N on; below 0.1 N it is a spring by every law but Iwan's.
const std::vector<double> that_reach = {2.0, 6.0, 15.0, 40.0}, that_do_not = {5e-4, 1e-3};

/// The scene of one study, over the part's file.
laws::LawScene scene_of(const std::filesystem::path& part, const Law& law, bool choose, const std::vector<double>& levels,
                        double noise) {
  std::string text = "[data]\nparts = [\"" + part.string() + "\"]\n";
  for (const double level : levels)
    text += fmt::format("[[data.levels]]\namplitude = {}\nforce_dofs = [\"1:+Y\"]\nharmonics = [1, 3]\n", level);
  text += "[[joint.friction]]\nname = \"joint\"\ndofs = [\"1:+Y\"]\n";
  text += choose ? "law = [\"bilinear\", \"shoukry\", \"ren\", \"iwan\"]\n" : fmt::format("law = \"{}\"\n", law.name);
  text += fmt::format("assumed = {{ law = \"{}\", {} }}\n", law.name, law.parameters);
  text += fmt::format("[frequency]\nrange = [80.0, 135.0]\n[errors]\nrelative = {}\n", noise);
  return laws::parse_law_scene(text, "study.toml");
}

class Studies {
 public:
  Studies(const bench::CommandLine& line, bench::Promises& promises) : trials_(line.count(0, 200, 2)), promises_(promises) {
    problems::write(problems::make_law_problem("sdof-iwan"), folder_, {});
  }
  ~Studies() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Studies(const Studies&) = delete;
  Studies& operator=(const Studies&) = delete;

  void accuracy(const Law& law, double noise) {
    const laws::LawStudy study = run(law, false, that_reach, noise);
    double sum = 0.0, worst = 0.0, held = 0.0, least = 1.0;
    for (const laws::StudiedValue& value : study.values) {
      const double ratio = value.rms_error / value.bound, share = covered(value);
      sum += ratio / static_cast<double>(study.values.size());
      held += share / static_cast<double>(study.values.size());
      worst = std::max(worst, ratio);
      least = std::min(least, share);
    }
    fmt::print("rms over bound {:.2f} in the mean, {:.2f} at worst; coverage {:.3f}, least {:.3f}\n", sum, worst, held, least);
    const std::string what = fmt::format("{}, {:g} %: ", law.name, 100.0 * noise);
    promises_.at_least(what + "share of usable tests", share_of(study.usable, study.trials), bench::least_share(0.98, trials_));
    promises_.at_most(what + "rms over bound, mean", sum, few() ? bench::largest_rms(trials_) : 1.1);
    promises_.at_most(what + "rms over bound, worst", worst, few() ? 1.3 * bench::largest_rms(trials_) : 1.3);
    promises_.at_least(what + "coverage", held, few() ? bench::least_share(0.95, trials_) : 0.92);
    promises_.at_least(what + "least coverage", least, bench::least_share(0.94, trials_));
    if (!few()) promises_.at_most(what + "coverage, at most", held, 0.97);
  }

  void choice(const Law& law, double noise) {
    const laws::LawStudy study = run(law, true, that_reach, noise);
    print_choice(study);
    const std::string what = fmt::format("{}, {:g} %: ", law.name, 100.0 * noise);
    promises_.at_least(what + "share of tests that choose it", share_of(study.right, study.usable),
                       bench::least_share(0.95, study.usable));
  }

  void no_choice(const Law& law) {
    const laws::LawStudy study = run(law, true, that_do_not, 0.01);
    print_choice(study);
    const std::string what = fmt::format("{}, low levels: ", law.name);
    promises_.at_least(what + "share of usable tests", share_of(study.usable, study.trials), bench::least_share(0.95, trials_));
    if (law.begins_as_spring)
      promises_.at_least(what + "share that cannot tell", share_of(study.undecided, study.usable),
                         bench::least_share(0.95, study.usable));
    promises_.at_least(what + "share that does not rule it out", 1.0 - share_of(study.missed, study.usable),
                       bench::least_share(0.95, study.usable));
  }

 private:
  /// Chance widens the limits.
  bool few() const { return trials_ < 200; }

  static double share_of(std::size_t some, std::size_t all) {
    return all > 0 ? static_cast<double>(some) / static_cast<double>(all) : jointid::nan;
  }
  static double covered(const laws::StudiedValue& value) { return share_of(value.covered, value.trials); }

  static void print_choice(const laws::LawStudy& study) {
    fmt::print("chosen in {} of {}, others as good in {}, ruled out in {};", study.right, study.usable, study.undecided,
               study.missed);
    for (const auto& [name, count] : study.chosen) fmt::print(" {} {}", name, count);
    fmt::print("\n");
  }

  laws::LawStudy run(const Law& law, bool choose, const std::vector<double>& levels, double noise) const {
    const auto start = Clock::now();
    laws::LawStudy study = laws::study_laws(scene_of(folder_ / "sdof-iwan_part_1.h5", law, choose, levels, noise),
                                            {.trials = trials_, .seed = 1, .threads = threads_or_cores(0)});
    fmt::print("{:8} {:g} %, to {:g} N, {}: {} of {} usable, χ² over freedom {:.3f}, {:.1f} s; ", law.name, 100.0 * noise,
               levels.back(), choose ? "four laws" : "its own law", study.usable, study.trials, study.chi_square,
               seconds_since(start));
    return study;
  }

  std::size_t trials_;
  bench::Promises& promises_;
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("jointid-bench-law-study-{}", ::getpid());
};

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  Studies studies(line, promises);
  std::vector<std::string> names;
  for (const Law& law : all_laws) names.emplace_back(law.name);
  for (const std::string& name : line.choice(1, names, {"bilinear"})) {
    const Law& law = *std::ranges::find(all_laws, name, [](const Law& each) { return std::string(each.name); });
    for (const double noise : {0.01, 0.03}) {
      studies.accuracy(law, noise);
      studies.choice(law, noise);
    }
    studies.no_choice(law);
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[TRIALS [LAW ...]]", measure); }
