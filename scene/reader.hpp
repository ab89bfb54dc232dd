#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "frf/set/dof.hpp"
#include "scene/value.hpp"

namespace jointid::scene {

/// Ten digits at most: "0.05".
std::string number_text(double number);

class Table;

/// A value of the scene with its name, for strict typed access. Everything that is wrong throws InputError (usage) with
/// the place "line 12, [frequency] range", the value found, and what was expected. Refers to the Value it was made of.
class Item {
 public:
  /// `table` is the path of the table around it ("" at the top), `key` its key with indices from 1: "exclude[2]".
  Item(const Value& value, const std::string& file, std::string table, std::string key)
      : value_(&value), file_(&file), table_(std::move(table)), key_(std::move(key)) {}

  double number() const;         ///< integer or float, finite
  double number_or_infinity() const;  ///< a number, inf or -inf
  double positive() const;       ///< a number > 0
  double not_negative() const;   ///< a number ≥ 0
  int whole(int least, int most) const;  ///< a whole number from `least` to `most`
  bool boolean() const;
  const std::string& text() const;
  std::string text_not_empty() const;
  std::string word(std::span<const std::string> valid) const;  ///< one of `valid`, else an error with the nearest
  std::vector<Item> list() const;                         ///< an array, perhaps empty
  std::vector<Item> list_not_empty() const;
  Table table(std::vector<std::string> valid_keys) const;  ///< a table with no other keys
  Table open_table() const;                                ///< a table with any keys

  /// An interval [lo, hi] with 0 ≤ lo < hi.
  Range interval() const;
  /// A matrix of numbers of the given number of rows and columns.
  Matrix square_matrix(std::size_t size) const;
  frf::Dof dof() const;
  /// At least one DOF, no coordinate twice.
  std::vector<frf::Dof> dofs() const;

  bool is_text() const { return std::holds_alternative<std::string>(value_->content); }
  bool is_table() const { return std::holds_alternative<Members>(value_->content); }
  bool is_list() const { return std::holds_alternative<Array>(value_->content); }
  std::string path() const;   ///< "[frequency] range"
  std::string place() const;  ///< "line 12, [frequency] range"
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy = {}) const;

  /// Runs `check`; an InputError of it gets this item's place.
  template <class Check>
  auto here(Check check) const {
    try {
      return check();
    } catch (const InputError& error) {
      fail(error.parts().problem, error.parts().remedy);
    }
  }

 private:
  template <class T>
  const T& as(const char* expected) const;

  const Value* value_;
  const std::string* file_;
  std::string table_;
  std::string key_;
};

/// A table of the scene whose keys are known to be valid.
class Table {
 public:
  Table(Item itself, std::vector<std::pair<std::string, Item>> members)
      : itself_(std::move(itself)), members_(std::move(members)) {}

  std::optional<Item> find(const std::string& key) const;
  Item require(const std::string& key) const;  ///< an error when the key is not there
  const std::vector<std::pair<std::string, Item>>& members() const { return members_; }
  const Item& itself() const { return itself_; }

 private:
  Item itself_;
  std::vector<std::pair<std::string, Item>> members_;
};

}  // namespace jointid::scene
