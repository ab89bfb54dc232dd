#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/statistics.hpp"
#include "base/stopwatch.hpp"

/// What the benchmarks share: the command line, times, promises with the exit code, and peers to compare with.
/// docs/benchmarks.md.
namespace jointid::bench {

/// The command line does not fit the usage: `run` says why and ends with 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What stands behind a program's name: `--quick` anywhere, other words by their place, from 0.
class CommandLine {
 public:
  explicit CommandLine(const std::vector<std::string>& words);

  /// The short run that CI makes: fewer seeds and sizes, no promise of speed.
  bool quick() const { return quick_; }
  std::size_t words() const { return words_.size(); }

  /// A number; where the line is shorter `full`, or `few` in a quick run.
  std::size_t count(std::size_t place, std::size_t full, std::size_t few) const;

  std::string word(std::size_t place, const std::string& otherwise) const;

  /// The words from a place on, each one of `known`; where there is none, all of `known`, or `few` in a quick run.
  std::vector<std::string> choice(std::size_t first, const std::vector<std::string>& known,
                                  const std::vector<std::string>& few) const;

 private:
  std::vector<std::string> words_;
  bool quick_ = false;
};

/// What the documentation promises, beside what was measured. A value that is not a number misses its limit.
class Promises {
 public:
  explicit Promises(bool quick) : quick_(quick) {}

  void at_most(const std::string& what, double value, double limit);
  void at_least(const std::string& what, double value, double limit);
  void holds(const std::string& what, bool kept);

  /// The same of times and their ratios, which a quick run prints only: machines of CI have other work.
  void speed_at_most(const std::string& what, double value, double limit);
  void speed_at_least(const std::string& what, double value, double limit);

  /// A part that could not be measured here.
  void skip(const std::string& why) { skipped_ = why; }

  /// Prints the missed ones. 0 when all are kept, 1 when one is missed, 77 when one could not be measured; that is 1, too, where
  /// JOINTID_REQUIRE_ALL=1 says that this machine has all that is used (tests/skip.sh).
  int exit_code() const;

 private:
  void judge(const std::string& what, double value, const char* relation, double limit, bool kept);

  bool quick_;
  std::size_t judged_ = 0, times_not_judged_ = 0;
  std::vector<std::string> missed_;
  std::string skipped_;
};

/// `main` of a benchmark: reads the command line, measures, and returns the exit code of its promises; 2 for a line that does not
/// fit. `usage` names the words, "[TRIALS [CASE ...]]"; those outside of brackets must be there, dots stand for any number.
int run(int argc, char** argv, const std::string& usage, const std::function<void(const CommandLine&, Promises&)>& measure);

/// Seconds of one call, the mean of some in a row.
template <class Work>
double seconds(const Work& work, int repeats = 1) {
  const auto start = Clock::now();
  for (int i = 0; i < repeats; ++i) work();
  return seconds_since(start) / repeats;
}

double least(const std::vector<double>& values);

/// Of this process: all threads together, what the work would take on one core.
double processor_seconds();

double peak_megabytes();

/// Seconds of some runs, by the clock and of processor time.
struct Times {
  std::vector<double> wall, processor;

  template <class Work>
  void add(const Work& work) {
    const double before = processor_seconds();
    wall.push_back(seconds(work));
    processor.push_back(processor_seconds() - before);
  }
};

/// Output of `script` of bench/peer and its arguments. None without numpy, which is skipped, and none where it fails, which is
/// missed.
std::optional<std::string> peer_output(const std::string& command, Promises& promises);

// Limits that chance alone breaks once in 100,000 times, so that all gates of a program together raise fewer than one false alarm
// in 1,000 runs.

/// Least share of `count` independent trials when the true one is `promised` (Chernoff: P(share ≤ s) ≤ exp(−n·KL(s‖p)), for
/// shares within a trial as well).
double least_share(double promised, std::size_t count);
/// Largest rms of `count` normal errors in parts of their deviation: √(χ²/n) at the quantile of 4.27 deviations.
double largest_rms(std::size_t count);

/// Of elements [first, last), relative to the largest of b's.
double largest_difference(const std::vector<double>& a, const std::vector<double>& b, std::size_t first, std::size_t last);

/// The same of 20 unknowns in the order K, D: stiffness and damping each against their own largest element.
double largest_difference_of_case_a1(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace jointid::bench
