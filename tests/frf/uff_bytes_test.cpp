#include "frf/uff/uff_bytes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

#include "tests/frf/uff_samples.hpp"

namespace jointid::frf::uff {
namespace {

std::string without_carriage_return(std::string line) {
  if (line.ends_with('\r')) line.pop_back();
  return line;
}

/// Lines of up to a few blocks, of which some are empty and some end with CR LF; the last may have no end.
rc::Gen<std::string> text_of_lines() {
  return rc::gen::map(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 9000)), [](const std::vector<int>& lengths) {
    std::string text;
    for (const int length : lengths) {
      text += std::string(static_cast<std::size_t>(length % 3 == 0 ? length % 81 : length), static_cast<char>('a' + length % 26));
      text += length % 5 == 0 ? "\r\n" : "\n";
    }
    if (!lengths.empty() && lengths.back() % 2 == 0) text.pop_back();
    return text;
  });
}

RC_GTEST_PROP(ByteFile, LinesAreThoseOfGetlineFromAnyPlace, ()) {
  const std::string text = *text_of_lines();
  const samples::TemporaryUff stored(text);
  ByteFile file(stored);
  RC_ASSERT(file.size() == text.size());
  const auto places = *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, text.size() + 2));
  std::string_view line;
  for (std::size_t place : places) {
    file.seek(place);
    std::istringstream stream(text.substr(std::min(place, text.size())));
    for (int count = 0; count < 5; ++count) {
      std::string expected;
      const bool is_there = static_cast<bool>(std::getline(stream, expected));
      RC_ASSERT(file.next_line(line) == is_there);
      if (!is_there) break;
      place += expected.size() + (stream.eof() ? 0 : 1);
      RC_ASSERT(line == without_carriage_return(expected));
      RC_ASSERT(file.position() == place);
    }
  }
}

}  // namespace
}  // namespace jointid::frf::uff
