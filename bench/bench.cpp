#include "bench/bench.hpp"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "base/text.hpp"

namespace jointid::bench {
namespace {

constexpr double false_alarm = 1e-5, false_alarm_deviations = 4.265;
constexpr int wrong_use = 2, skipped = 77;

rusage used() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage;
}

/// What a command prints; none when it fails.
std::optional<std::string> output_of(const std::string& command) {
  std::string text;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text.push_back(static_cast<char>(c));
  return pclose(pipe) == 0 ? std::optional(text) : std::nullopt;
}

/// How many words a usage needs and allows.
void check_number(std::size_t words, const std::string& usage) {
  const std::string needed = usage.substr(0, usage.find('['));
  const auto names = [](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++i) count += text[i] != ' ' && (i == 0 || text[i - 1] == ' ');
    return count;
  };
  if (words < names(needed)) throw UsageError("a word is missing");
  if (usage.find("...") == std::string::npos && words > names(usage)) throw UsageError("too many words");
}

}  // namespace

CommandLine::CommandLine(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "--quick") {
      quick_ = true;
    } else if (word.starts_with("-")) {
      throw UsageError(fmt::format("there is no switch {}", word));
    } else {
      words_.push_back(word);
    }
  }
}

std::size_t CommandLine::count(std::size_t place, std::size_t full, std::size_t few) const {
  if (place >= words_.size()) return quick_ ? few : full;
  const std::string& word = words_[place];
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) throw UsageError(fmt::format("{} is no count", word));
  return number;
}

std::string CommandLine::word(std::size_t place, const std::string& otherwise) const {
  return place < words_.size() ? words_[place] : otherwise;
}

std::vector<std::string> CommandLine::choice(std::size_t first, const std::vector<std::string>& known,
                                             const std::vector<std::string>& few) const {
  if (first >= words_.size()) return quick_ ? few : known;
  const std::vector<std::string> chosen(words_.begin() + static_cast<std::ptrdiff_t>(first), words_.end());
  for (const std::string& word : chosen) {
    if (std::ranges::find(known, word) != known.end()) continue;
    throw UsageError(fmt::format("there is no {}, but {}", word, comma_list(known)));
  }
  return chosen;
}

void Promises::judge(const std::string& what, double value, const char* relation, double limit, bool kept) {
  ++judged_;
  if (!kept) missed_.push_back(fmt::format("{}: {:.4g}, promised {} {:.4g}", what, value, relation, limit));
}

void Promises::at_most(const std::string& what, double value, double limit) {
  judge(what, value, "at most", limit, value <= limit);
}

void Promises::at_least(const std::string& what, double value, double limit) {
  judge(what, value, "at least", limit, value >= limit);
}

void Promises::holds(const std::string& what, bool kept) {
  ++judged_;
  if (!kept) missed_.push_back(what + ": not so");
}

void Promises::speed_at_most(const std::string& what, double value, double limit) {
  if (quick_) {
    ++times_not_judged_;
  } else {
    at_most(what, value, limit);
  }
}

void Promises::speed_at_least(const std::string& what, double value, double limit) {
  if (quick_) {
    ++times_not_judged_;
  } else {
    at_least(what, value, limit);
  }
}

int Promises::exit_code() const {
  fmt::print("promises: {} of {} kept", judged_ - missed_.size(), judged_);
  fmt::print("{}\n", times_not_judged_ > 0 ? fmt::format("; {} of speed are for the full run", times_not_judged_) : "");
  for (const std::string& each : missed_) fmt::print("MISSED {}\n", each);
  if (!skipped_.empty()) fmt::print("skipped: {}\n", skipped_);
  if (!missed_.empty()) return 1;
  if (skipped_.empty()) return 0;
  const char* all = std::getenv("JOINTID_REQUIRE_ALL");
  return all != nullptr && std::string(all) == "1" ? 1 : skipped;
}

int run(int argc, char** argv, const std::string& usage, const std::function<void(const CommandLine&, Promises&)>& measure) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // into a file, too, a program that is stopped has told what it measured
  try {
    const CommandLine line({argv + 1, argv + argc});
    check_number(line.words(), usage);
    Promises promises(line.quick());
    measure(line, promises);
    return promises.exit_code();
  } catch (const UsageError& error) {
    const std::string name = std::filesystem::path(argv[0]).filename();
    fmt::print(stderr, "{}\nusage: {} [--quick]{}{}\n", error.what(), name, usage.empty() ? "" : " ", usage);
    return wrong_use;
  }
}

double least(const std::vector<double>& values) { return *std::ranges::min_element(values); }

double processor_seconds() {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  const rusage usage = used();
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peak_megabytes() { return static_cast<double>(used().ru_maxrss) / 1024.0; }

std::optional<std::string> peer_output(const std::string& command, Promises& promises) {
  if (!output_of("/usr/bin/python3 -c 'import numpy' 2>/dev/null")) {
    fmt::print("  numpy is missing (python3-numpy): nothing to compare with\n");
    promises.skip("numpy is missing (python3-numpy)");
    return std::nullopt;
  }
  const auto text = output_of(fmt::format("OPENBLAS_NUM_THREADS=1 /usr/bin/python3 {}/{}", JOINTID_PEER_DIR, command));
  promises.holds("numpy's program gives an answer", text.has_value());
  return text;
}

double least_share(double promised, std::size_t count) {
  const double information = -std::log(false_alarm) / static_cast<double>(count);
  const auto divergence = [promised](double share) {
    const double there = share > 0.0 ? share * std::log(share / promised) : 0.0;
    return there + (1.0 - share) * std::log((1.0 - share) / (1.0 - promised));
  };
  double low = 0.0, high = promised;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (divergence(middle) > information ? low : high) = middle;
  }
  return low;
}

double largest_rms(std::size_t count) {
  const auto n = static_cast<double>(count);
  return std::sqrt(chi_square_quantile(n, false_alarm_deviations) / n);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b, std::size_t first, std::size_t last) {
  double difference = 0.0, largest = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    const double here = std::abs(a[i] - b[i]);
    if (std::isnan(here)) return here;
    difference = std::max(difference, here);
    largest = std::max(largest, std::abs(b[i]));
  }
  return difference / largest;
}

double largest_difference_of_case_a1(const std::vector<double>& a, const std::vector<double>& b) {
  return std::max(largest_difference(a, b, 0, 10), largest_difference(a, b, 10, 20));
}

}  // namespace jointid::bench
