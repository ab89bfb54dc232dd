#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace jointid::cli {

/// Which whole numbers an option takes.
struct WholeNumbers {
  std::uint64_t least = 0, most = std::numeric_limits<std::uint64_t>::max();
  std::string remedy{};  ///< for more than `most`
};

/// "1000", "1e3" or "1.5e3", all digits of a number without exponent counting. Throws CLI::ValidationError for the option `name`
/// otherwise, and for what is not allowed.
std::uint64_t parse_whole_number(const std::string& name, const std::string& text, const WholeNumbers& allowed);

/// An option that takes such a number.
CLI::Option* add_whole_number(CLI::App* command, const std::string& name, std::function<void(std::uint64_t)> store, const std::string& what,
                              const WholeNumbers& allowed);

/// The same, kept in `to`, whose value is the default.
template <class Number>
CLI::Option* add_whole_number(CLI::App* command, const std::string& name, Number& to, const std::string& what,
                              const WholeNumbers& allowed) {
  const std::string otherwise = std::to_string(to);
  return add_whole_number(
             command, name, [&to](std::uint64_t value) { to = static_cast<Number>(value); }, what, allowed)
      ->default_str(otherwise);
}

/// What --trials, --scenes and --threads take.
WholeNumbers counts_of_trials();
WholeNumbers counts_of_threads();

}  // namespace jointid::cli
