#include "knots.hpp"

#include <algorithm>
#include <fstream>
#include <functional>

#include "include_rules.hpp"

namespace jointid::structure {
namespace {

std::string unit_of(const std::filesystem::path& file) { return std::filesystem::path(file).replace_extension().generic_string(); }

/// Tarjan's strongly connected components.
class Components {
 public:
  explicit Components(const UnitGraph& graph) : graph_(graph) {
    for (const auto& [unit, includes] : graph) {
      if (!number_.contains(unit)) visit(unit);
    }
  }
  std::vector<std::set<std::string>> found;

 private:
  std::size_t visit(const std::string& unit) {
    const std::size_t own = number_[unit] = ++count_;
    std::size_t lowest = own;
    path_.push_back(unit);
    for (const std::string& next : graph_.at(unit)) {
      if (!number_.contains(next)) {
        lowest = std::min(lowest, visit(next));
      } else if (std::ranges::find(path_, next) != path_.end()) {
        lowest = std::min(lowest, number_[next]);
      }
    }
    if (lowest < own) return lowest;
    const auto first = std::ranges::find(path_, unit);
    if (path_.end() - first > 1) found.emplace_back(first, path_.end());
    path_.erase(first, path_.end());
    return lowest;
  }

  const UnitGraph& graph_;
  std::map<std::string, std::size_t> number_;
  std::vector<std::string> path_;
  std::size_t count_ = 0;
};

}  // namespace

UnitGraph units(const std::filesystem::path& root, const std::vector<std::string>& folders) {
  UnitGraph graph;
  std::map<std::string, std::vector<std::string>> included;
  for (const std::string& folder : folders) {
    for (const auto& path : sources(root / folder)) {
      std::ifstream source(path);
      const std::string unit = unit_of(std::filesystem::relative(path, root));
      graph[unit];
      for (const std::string& include : includes(source)) included[unit].push_back(unit_of(include));
    }
  }
  for (const auto& [unit, all] : included) {
    for (const std::string& other : all) {
      if (other != unit && graph.contains(other)) graph[unit].insert(other);
    }
  }
  return graph;
}

std::vector<std::set<std::string>> knots(const UnitGraph& graph) {
  std::vector<std::set<std::string>> found = Components(graph).found;
  std::ranges::stable_sort(found, std::ranges::greater{}, &std::set<std::string>::size);
  return found;
}

}  // namespace jointid::structure
