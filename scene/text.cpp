#include "scene/text.hpp"

#include <array>
#include <fstream>
#include <string_view>
#include <system_error>

#include "base/error.hpp"
#include "base/temporary_file.hpp"

namespace jointid::scene {
namespace {

constexpr std::size_t largest_scene = std::size_t{16} << 20;  // bytes
constexpr int most_key_parts = 32;

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& problem, const std::string& remedy) {
  throw InputError(
      {.kind = ErrorKind::usage, .file = file.string(), .place = {}, .problem = problem, .remedy = remedy});
}

/// Steps over strings and comments exactly as TOML delimits them.
class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  bool at_end() const { return at_ >= text_.size(); }
  std::size_t line() const { return line_; }

  /// The next character that is in no string and no comment; a string gives its opening quote, a comment '#'.
  char next() {
    const char c = text_[at_];
    if (c == '"' || c == '\'') {
      skip_string(c);
    } else if (c == '#') {
      while (!at_end() && text_[at_] != '\n') ++at_;
    } else {
      step();
    }
    return c;
  }

 private:
  void step() {
    if (text_[at_] == '\n') ++line_;
    ++at_;
  }

  void skip_string(char quote) {
    const std::string triple(3, quote);
    const bool multiline = text_.substr(at_, 3) == triple;
    at_ += multiline ? 3 : 1;
    while (!at_end()) {
      if (!multiline && text_[at_] == '\n') return;  // an error that the parser reports
      if (multiline ? text_.substr(at_, 3) == triple : text_[at_] == quote) break;
      if (quote == '"' && text_[at_] == '\\') step();
      if (!at_end()) step();
    }
    if (at_end()) return;
    at_ += multiline ? 3 : 1;
    // Up to two more quotes may stand right before the closing three.
    for (int i = 0; multiline && i < 2 && !at_end() && text_[at_] == quote; ++i) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

}  // namespace

std::string read_text(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) fail(file, "there is no such scene file", "check the path");
  if (std::filesystem::is_directory(status)) fail(file, "this is a folder", "name the scene file in it");
  require_regular_file(file, ErrorKind::usage);
  std::ifstream in(file, std::ios::binary);
  if (!in) fail(file, "the scene file cannot be opened", "check its permissions");
  std::string text;
  std::array<char, 65536> chunk;
  while (in && text.size() <= largest_scene) {
    in.read(chunk.data(), chunk.size());
    text.append(chunk.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) fail(file, "the scene file cannot be read", "check its permissions and the disk");
  if (text.size() > largest_scene) fail(file, "the file is larger than 16 MiB", "is it a scene?");
  return text;
}

void check_key_depth(const std::string& text, const std::filesystem::path& file) {
  Lexer lexer(text);
  int dots = 0;
  while (!lexer.at_end()) {
    const std::size_t line = lexer.line();
    const char c = lexer.next();
    if (c == '.') ++dots;
    if (std::string_view("=,[]{}#\n").find(c) != std::string_view::npos) dots = 0;
    if (dots < most_key_parts) continue;
    throw InputError({.kind = ErrorKind::usage,
                      .file = file.string(),
                      .place = "line " + std::to_string(line),
                      .problem = "a key has more than " + std::to_string(most_key_parts) + " parts",
                      .remedy = "no key of a scene is nested that deep"});
  }
}

}  // namespace jointid::scene
