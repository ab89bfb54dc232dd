#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace jointid::structure {

/// Unit (a source with its header: its path without extension) → units that it includes.
using UnitGraph = std::map<std::string, std::set<std::string>>;

/// The units of the folders below `root` and what they include of each other.
UnitGraph units(const std::filesystem::path& root, const std::vector<std::string>& folders);

/// Units that include each other in circles, one set per knot (strongly connected components of two units and more), largest first.
std::vector<std::set<std::string>> knots(const UnitGraph& graph);

}  // namespace jointid::structure
