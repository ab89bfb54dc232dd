#include "cli/options/whole_number.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/parallel.hpp"

namespace jointid::cli {
namespace {

/// Whether the whole text is a number; says in `error` what is wrong with one that is too large for its type.
template <class Number>
bool reads_as(const std::string& text, Number& value, std::errc& error) {
  const auto [end, found] = std::from_chars(text.data(), text.data() + text.size(), value);
  error = found;
  return end == text.data() + text.size() && found != std::errc::invalid_argument;
}

/// As much of it as fits in a line.
std::string shortened(const std::string& text) {
  constexpr std::size_t most = 30;
  return text.size() <= most ? text : text.substr(0, most) + "…";
}

[[noreturn]] void refuse_number(const std::string& name, const std::string& text, const std::string& why) {
  throw CLI::ValidationError(name, "'" + shortened(text) + "' " + why);
}

[[noreturn]] void refuse_large(const std::string& name, const std::string& text, const WholeNumbers& allowed) {
  refuse_number(name, text, "is more than " + std::to_string(allowed.most) + (allowed.remedy.empty() ? "" : "; " + allowed.remedy));
}

}  // namespace

std::uint64_t parse_whole_number(const std::string& name, const std::string& text, const WholeNumbers& allowed) {
  constexpr double exact = 9007199254740992.0;  // 2⁵³: whole numbers up to here are exact in floating point
  std::uint64_t whole = 0;
  double real = 0.0;
  std::errc error{};
  const std::string not_whole = "is not a whole number of at least " + std::to_string(allowed.least);
  if (reads_as(text, whole, error)) {
    if (error == std::errc::result_out_of_range) refuse_large(name, text, allowed);
  } else {
    if (!reads_as(text, real, error) || !(real >= 0.0) || real != std::floor(real) || real > exact) refuse_number(name, text, not_whole);
    whole = static_cast<std::uint64_t>(real);
  }
  if (whole < allowed.least) refuse_number(name, text, not_whole);
  if (whole > allowed.most) refuse_large(name, text, allowed);
  return whole;
}

CLI::Option* add_whole_number(CLI::App* command, const std::string& name, std::function<void(std::uint64_t)> store, const std::string& what,
                              const WholeNumbers& allowed) {
  const auto take = [name, store = std::move(store), allowed](const std::string& text) { store(parse_whole_number(name, text, allowed)); };
  return command->add_option_function<std::string>(name, take, what)->type_name("UINT");
}

WholeNumbers counts_of_trials() { return {.least = 0, .most = 1'000'000'000, .remedy = {}}; }

WholeNumbers counts_of_threads() {
  constexpr std::uint64_t always = 64;
  const std::uint64_t cores = threads_or_cores(0);
  return {.least = 0, .most = std::max(always, 4 * cores), .remedy = "0 takes all " + std::to_string(cores) + " cores"};
}

}  // namespace jointid::cli
