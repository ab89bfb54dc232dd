#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace jointid {

/// Who has to act on bad input; the command maps it to its exit code.
enum class ErrorKind {
  usage,  ///< wrong use or a wrong scene (exit code 2)
  data    ///< unreadable or inconsistent data (exit code 3)
};

/// The one exception for bad input: what is wrong, where, with which value, what to do about it. what() is one line, printable().
class InputError : public std::runtime_error {
 public:
  struct Parts {
    ErrorKind kind = ErrorKind::data;
    std::string file;     ///< file name, or empty
    std::string place;    ///< e.g. "line 12", "dataset frf", "[joint] dofs"
    std::string problem;  ///< with the offending value
    std::string remedy;   ///< what the user can do, or empty
  };

  explicit InputError(Parts parts);

  const Parts& parts() const { return parts_; }
  ErrorKind kind() const { return parts_.kind; }

 private:
  Parts parts_;
};

/// Throws InputError (usage) of a value that a caller of the library gave; who knows file and place catches it and adds them.
[[noreturn]] void refuse(std::string problem, std::string remedy = {});

/// Levenshtein distance of two words.
std::size_t edit_distance(const std::string& a, const std::string& b);

/// The word of `valid` nearest to `word` by edit distance (for "did you mean"), or empty if none is near.
template <class Range>
std::string nearest_word(const std::string& word, const Range& valid) {
  std::string best;
  std::size_t best_distance = word.size() / 2 + 2;
  for (const auto& candidate : valid) {
    const std::size_t distance = edit_distance(word, std::string(candidate));
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

/// The place of `text` among `words`; throws InputError (usage) "'text' is no `what`" with the nearest word and all of them.
std::size_t find_word(const std::string& text, const std::vector<std::string>& words, const std::string& what);

}  // namespace jointid
