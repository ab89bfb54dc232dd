#pragma once

#include <string>
#include <vector>

#include "scene/reader.hpp"

namespace jointid::scene {

/// The text of a scene of any kind, parsed, with its sections. What is read of it refers to it.
class Document {
 public:
  /// `sections`: the keys of this kind of scene at the top; every kind has a title beside them. Throws InputError (usage) with line and
  /// place for what is no TOML, and for any other key.
  Document(const std::string& text, const Path& file, std::vector<std::string> sections);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  const Table& table() const { return table_; }
  const Item& root() const { return root_; }
  /// Empty where there is none.
  std::string title() const;

 private:
  std::string file_;
  Value value_;
  Item root_;
  Table table_;
};

}  // namespace jointid::scene
