#pragma once

#include <filesystem>
#include <istream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace jointid::structure {

/// Folder → folders beside it that it may include. Rooms inside a folder are "frf/uff", and what lies in it beside them "frf/.".
using IncludeTable = std::map<std::string, std::set<std::string>>;

/// Reads the rows "| `folder/` | … | may include |" of a Markdown table; the last column is "–", "all above" or names
/// separated by commas.
IncludeTable read_table(std::istream& markdown);

/// What stands between the quotes or brackets of each #include, in order.
std::vector<std::string> includes(std::istream& source);

/// One sentence per include of `source`, a file of `folder`, that runs against the table or names no folder.
std::vector<std::string> violations(const IncludeTable& table, const std::string& folder, std::istream& source);

/// An include from one room into another of the same folder, in the deepest folder that holds both files: "frf/uff" → "frf/set" of
/// "frf/uff/scan.cpp" and "frf/set/dof.hpp"; "frf/." is what lies in the folder itself.
struct RoomStep {
  std::string from, to;
  bool operator==(const RoomStep&) const = default;
};

/// That of a file that includes another; none inside one room, or between top folders.
std::optional<RoomStep> room_step(const std::string& file, const std::string& include);

/// One sentence per include of `source` of another room of its folder that the table does not give the room of `file`.
std::vector<std::string> room_violations(const IncludeTable& table, const std::string& file, std::istream& source);

/// Includes of a header that cost its users much build time or a dependency.
std::vector<std::string> heavy_includes(std::istream& header);

/// Includes of a source that instantiate Eigen's decompositions.
std::vector<std::string> decomposition_includes(std::istream& source);

/// The .hpp and .cpp files below a folder, sorted.
std::vector<std::filesystem::path> sources(const std::filesystem::path& folder);

}  // namespace jointid::structure
