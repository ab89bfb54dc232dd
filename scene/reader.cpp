#include "scene/reader.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <type_traits>

#include "base/text.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::scene {
namespace {

/// `joint`, `"assembly.h5"`, `joints[2]`: as the key is written in the file.
std::string written(const std::string& key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
  return bare ? key : '"' + key + '"';
}

struct Describe {
  std::string operator()(bool value) const { return value ? "the boolean true" : "the boolean false"; }
  std::string operator()(std::int64_t value) const { return "the integer " + std::to_string(value); }
  std::string operator()(double value) const { return "the number " + number_text(value); }
  std::string operator()(const std::string& value) const { return "the string \"" + value + "\""; }
  std::string operator()(DateOrTime) const { return "a date or time"; }
  std::string operator()(const Array& value) const { return "an array of " + std::to_string(value.size()); }
  std::string operator()(const Members&) const { return "a table"; }
};

std::string did_you_mean(const std::string& word, std::span<const std::string> valid) {
  std::string near = nearest_word(word, valid);
  for (const std::string& candidate : valid) {
    const bool same = std::equal(word.begin(), word.end(), candidate.begin(), candidate.end(), [](char a, char b) {
      return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    });
    if (same) near = candidate;
  }
  return near.empty() ? "use " + one_of(valid) : "did you mean " + near + "? Valid: " + one_of(valid);
}

}  // namespace

std::string number_text(double number) {
  char buffer[32];
  const int length = std::snprintf(buffer, sizeof buffer, "%.10g", number);
  return std::string(buffer, static_cast<std::size_t>(length));
}

std::string Item::path() const {
  const bool is_table = std::holds_alternative<Members>(value_->content);
  std::string name = key_;
  if (is_table && !key_.empty()) name = "[" + (table_.empty() ? "" : table_ + ".") + key_ + "]";
  if (!is_table && !table_.empty()) name = "[" + table_ + "] " + key_;
  return name;
}

std::string Item::place() const {
  const std::string at = value_->line > 0 ? "line " + std::to_string(value_->line) : "", name = path();
  return name.empty() ? at : at + ", " + name;
}

void Item::fail(const std::string& problem, const std::string& remedy) const {
  throw InputError(
      {.kind = ErrorKind::usage, .file = *file_, .place = place(), .problem = problem, .remedy = remedy});
}

namespace {

bool is_list_of_tables(const Value& value) {
  const auto* list = std::get_if<Array>(&value.content);
  return list != nullptr && !list->empty() &&
         std::ranges::all_of(*list, [](const Value& entry) { return std::holds_alternative<Members>(entry.content); });
}

/// Inner tables that stand in a scene once for each of what they are.
bool stands_as_list(const std::string& header) {
  constexpr std::array lists = {"data.gains", "data.masses", "data.levels", "joint.friction", "couple.joint", "structure.modes"};
  return std::ranges::find(lists, header) != lists.end();
}

}  // namespace

template <class T>
const T& Item::as(const char* expected) const {
  if (const T* content = std::get_if<T>(&value_->content)) return *content;
  const std::string header = table_.empty() ? key_ : table_ + "." + key_;
  std::string remedy;
  if (std::is_same_v<T, Members> && is_list_of_tables(*value_)) remedy = "[[" + header + "]] should be [" + header + "]";
  if (std::is_same_v<T, Array> && is_table() && (table_.empty() || stands_as_list(header)))
    remedy = "[" + header + "] should be [[" + header + "]]";
  fail("expected " + std::string(expected) + ", found " + std::visit(Describe(), value_->content), remedy);
}

double Item::number() const {
  if (const auto* integer = std::get_if<std::int64_t>(&value_->content)) return static_cast<double>(*integer);
  const double number = as<double>("a number");
  if (!std::isfinite(number)) fail("expected a finite number, found " + number_text(number));
  return number;
}

double Item::number_or_infinity() const {
  const auto* number = std::get_if<double>(&value_->content);
  return number != nullptr && std::isinf(*number) ? *number : this->number();
}

double Item::positive() const {
  const double value = number();
  if (!(value > 0.0)) fail("expected a number above 0, found " + number_text(value));
  return value;
}

double Item::not_negative() const {
  const double value = number();
  if (!(value >= 0.0)) fail("expected a number of at least 0, found " + number_text(value));
  return value;
}

int Item::whole(int least, int most) const {
  const double found = number();
  if (found != std::floor(found) || found < least || found > most) {
    fail(number_text(found) + " is not a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return static_cast<int>(found);
}

bool Item::boolean() const { return as<bool>("true or false"); }

const std::string& Item::text() const { return as<std::string>("a string"); }

std::string Item::text_not_empty() const {
  if (text().empty()) fail("the string is empty", "leave the key out or name something");
  return text();
}

std::string Item::word(std::span<const std::string> valid) const {
  if (std::find(valid.begin(), valid.end(), text()) == valid.end()) {
    fail("'" + text() + "' is not a valid word", did_you_mean(text(), valid));
  }
  return text();
}

std::vector<Item> Item::list() const {
  std::vector<Item> items;
  for (const Value& value : as<Array>("an array")) {
    items.emplace_back(value, *file_, table_, key_ + "[" + std::to_string(items.size() + 1) + "]");
  }
  return items;
}

std::vector<Item> Item::list_not_empty() const {
  std::vector<Item> items = list();
  if (items.empty()) fail("the list is empty", "leave the key out or name something");
  return items;
}

Table Item::open_table() const {
  const std::string path = table_.empty() ? key_ : table_ + "." + key_;
  std::vector<std::pair<std::string, Item>> members;
  for (const Member& member : as<Members>("a table")) {
    members.emplace_back(member.key, Item(member.value, *file_, path, written(member.key)));
  }
  return {*this, std::move(members)};
}

Table Item::table(std::vector<std::string> valid_keys) const {
  Table result = open_table();
  for (const auto& [key, item] : result.members()) {
    if (std::find(valid_keys.begin(), valid_keys.end(), key) != valid_keys.end()) continue;
    item.fail("the key '" + key + "' is not known here", did_you_mean(key, valid_keys));
  }
  return result;
}

Range Item::interval() const {
  if (!std::holds_alternative<Array>(value_->content)) as<Array>("[lo, hi]");
  const std::vector<Item> items = list();
  if (items.size() != 2) fail("expected [lo, hi], found an array of " + std::to_string(items.size()));
  const Range range = {items[0].not_negative(), items[1].not_negative()};
  if (!(range[0] < range[1])) {
    fail("expected lo < hi, found [" + number_text(range[0]) + ", " + number_text(range[1]) + "]");
  }
  return range;
}

Matrix Item::square_matrix(std::size_t size) const {
  const auto check = [&](const Item& item, std::size_t found, const char* what) {
    if (found == size) return;
    item.fail("found " + std::to_string(found) + " " + what + ", expected " + std::to_string(size),
              "the matrix has a row and a column for each joint DOF");
  };
  Matrix matrix;
  const std::vector<Item> rows = list();
  check(*this, rows.size(), "rows");
  for (const Item& row : rows) {
    const std::vector<Item> elements = row.list();
    check(row, elements.size(), "elements");
    matrix.emplace_back();
    for (const Item& element : elements) matrix.back().push_back(element.number());
  }
  return matrix;
}

frf::Dof Item::dof() const {
  const std::string& name = text();
  return here([&] { return frf::Dof::parse(name); });
}

std::vector<frf::Dof> Item::dofs() const {
  std::vector<frf::Dof> result;
  for (const Item& item : list_not_empty()) {
    const frf::Dof dof = item.dof();
    if (frf::has(result, dof))
      item.fail("the coordinate of " + dof.name() + " is here twice", "name each coordinate once, with one sign");
    result.push_back(dof);
  }
  return result;
}

std::optional<Item> Table::find(const std::string& key) const {
  for (const auto& [name, item] : members_) {
    if (name == key) return item;
  }
  return std::nullopt;
}

Item Table::require(const std::string& key) const {
  if (const auto item = find(key)) return *item;
  itself_.fail("the key '" + key + "' is missing", "add it");
}

}  // namespace jointid::scene
