#include "frf/csv/csv_nodes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "base/error.hpp"
#include "frf/text/number_text.hpp"

namespace jointid::frf {
namespace {

constexpr std::string_view node_key = "node ";

[[noreturn]] void fail_node(const CsvTable& table, const std::string& key, std::string problem) {
  throw InputError({.kind = ErrorKind::data,
                    .file = table.file,
                    .place = "# " + key,
                    .problem = std::move(problem),
                    .remedy = "write node number and position in m, e.g. # node 4 = 0.5 0 0"});
}

std::int64_t node_number(const CsvTable& table, const std::string& key) {
  const std::string_view text = trimmed(std::string_view(key).substr(node_key.size()));
  std::int64_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc() || end != text.data() + text.size() || id < 0)
    fail_node(table, key, "'" + std::string(text) + "' is not a node number");
  return id;
}

Node node_of(const CsvTable& table, const std::string& key, std::string text) {
  Node node{node_number(table, key), {}};
  std::ranges::replace_if(text, [](char c) { return c == ',' || c == ';' || c == '\t'; }, ' ');
  const std::vector<std::string_view> parts = split(text, ' ');
  if (parts.size() != node.position.size()) fail_node(table, key, "has " + std::to_string(parts.size()) + " numbers, not three");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parse_cell(parts[i], false, node.position[i]) || std::isnan(node.position[i])) {
      fail_node(table, key, "'" + std::string(parts[i]) + "' is not a number");
    }
  }
  return node;
}

std::string shortest(double value) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), end};
}

}  // namespace

std::vector<Node> read_csv_nodes(const CsvTable& table) {
  std::vector<Node> nodes;
  for (auto key = table.keys.lower_bound(node_key); key != table.keys.end() && key->first.starts_with(node_key); ++key) {
    nodes.push_back(node_of(table, key->first, key->second));
  }
  std::ranges::sort(nodes, {}, &Node::id);
  return nodes;
}

std::string csv_nodes_text(const std::vector<Node>& nodes) {
  std::string text;
  for (const Node& node : nodes) {
    text += "# node " + std::to_string(node.id) + " =";
    for (const double x : node.position) text += " " + shortest(x);
    text += "\n";
  }
  return text;
}

}  // namespace jointid::frf
