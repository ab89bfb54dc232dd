#include "records/file/npy_header.hpp"

#include <charconv>
#include <set>

#include "base/error.hpp"

namespace jointid::records {
namespace {

constexpr const char* save_again = "write it again with numpy.save()";

/// Takes the literal of a Python dictionary apart, from left to right.
class HeaderText {
 public:
  HeaderText(std::string_view text, const std::filesystem::path& path) : rest_(text), path_(path) {}

  NpyHeader parse() {
    NpyHeader header;
    std::set<std::string> seen;
    expect('{');
    while (!take('}')) {
      const std::string key = quoted();
      if (!seen.insert(key).second) fail("the key '" + key + "' stands twice");
      expect(':');
      if (key == "descr")
        type(header);
      else if (key == "fortran_order")
        header.fortran_order = boolean();
      else if (key == "shape")
        header.shape = shape();
      else
        fail("the key '" + key + "' is none of descr, fortran_order and shape");
      if (!take(',')) {
        expect('}');
        break;
      }
    }
    blanks();
    if (!rest_.empty()) fail("something follows the dictionary");
    if (seen.size() != 3) fail("not all of descr, fortran_order and shape are there");
    return header;
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const { fail_npy(path_, problem, save_again); }

  void blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\n')) rest_.remove_prefix(1);
  }
  bool take(char c) {
    blanks();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(char c) {
    if (!take(c)) fail(std::string("there is no '") + c + "' where one belongs");
  }
  bool take_word(std::string_view word) {
    blanks();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  std::string quoted() {
    expect('\'');
    const std::size_t end = rest_.find('\'');
    if (end == std::string_view::npos || end > 32) fail("a text has no end");
    std::string text(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return text;
  }

  bool boolean() {
    if (take_word("True")) return true;
    if (!take_word("False")) fail("fortran_order is neither True nor False");
    return false;
  }

  void type(NpyHeader& header) {
    blanks();
    if (rest_.starts_with('[')) fail_npy(path_, "holds records with named fields", "save one plain array of real numbers");
    const std::string descr = quoted();
    const auto known = [&](std::string_view kinds, std::string_view widths) {
      return descr.size() == 3 && kinds.find(descr[1]) != std::string_view::npos &&
             widths.find(descr[2]) != std::string_view::npos;
    };
    if (!known("f", "48") && !known("iu", "1248")) fail_npy(path_, "holds numbers of type '" + descr + "'", "save it as float64");
    const char order = descr[0];
    if (order != '<' && order != '>' && !(order == '|' && descr[2] == '1')) fail("the byte order of '" + descr + "' is unknown");
    header.kind = descr[1];
    header.width = static_cast<std::size_t>(descr[2] - '0');
    header.big_endian = order == '>';
  }

  std::vector<std::uint64_t> shape() {
    std::vector<std::uint64_t> out;
    expect('(');
    while (!take(')')) {
      blanks();
      std::uint64_t extent = 0;
      const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), extent);
      if (error != std::errc() || out.size() == 32) fail("the shape is not a list of sizes");
      out.push_back(extent);
      rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
      if (!take(',')) {
        expect(')');
        break;
      }
    }
    return out;
  }

  std::string_view rest_;
  const std::filesystem::path& path_;
};

}  // namespace

NpyHeader parse_npy_header(std::string_view text, const std::filesystem::path& path) { return HeaderText(text, path).parse(); }

void fail_npy(const std::filesystem::path& path, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, path.string(), "npy header", std::move(problem), std::move(remedy)});
}

}  // namespace jointid::records
