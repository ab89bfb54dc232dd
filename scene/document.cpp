#include "scene/document.hpp"

#include <utility>

namespace jointid::scene {
namespace {

std::vector<std::string> with_title(std::vector<std::string> sections) {
  sections.insert(sections.begin(), "title");
  return sections;
}

}  // namespace

Document::Document(const std::string& text, const Path& file, std::vector<std::string> sections)
    : file_(file.string()),
      value_(parse_toml(text, file)),
      root_(value_, file_, {}, {}),
      table_(root_.table(with_title(std::move(sections)))) {}

std::string Document::title() const {
  const auto title = table_.find("title");
  return title ? title->text() : std::string();
}

}  // namespace jointid::scene
