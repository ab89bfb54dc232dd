#pragma once

#include <filesystem>
#include <istream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace jointid::structure {

/// Folder → folders it may include besides itself. Rooms inside a folder are "frf/uff", and what lies in it beside them "frf/.".
using IncludeTable = std::map<std::string, std::set<std::string>>;

/// Reads the rows "| `folder/` | … | may include |" of a Markdown table; the last column is "–", "all above" or names
/// separated by commas.
IncludeTable read_table(std::istream& markdown);

/// What stands between the quotes or brackets of each #include, in order.
std::vector<std::string> includes(std::istream& source);

/// One sentence per include of `source`, a file of `folder`, that runs against the table or names no folder.
std::vector<std::string> violations(const IncludeTable& table, const std::string& folder, std::istream& source);

/// Folder and room of a file or include: "frf/uff" of "frf/uff/scan.hpp", "frf/." of "frf/open.hpp".
std::string room_of(const std::string& path);

/// One sentence per include of `source`, a file of `room`, of another room of its folder that the table does not give it.
std::vector<std::string> room_violations(const IncludeTable& table, const std::string& room, std::istream& source);

/// Includes of a header that cost its users much build time or a dependency.
std::vector<std::string> heavy_includes(std::istream& header);

/// Includes of a source that instantiate Eigen's decompositions.
std::vector<std::string> decomposition_includes(std::istream& source);

/// The .hpp and .cpp files below a folder, sorted.
std::vector<std::filesystem::path> sources(const std::filesystem::path& folder);

}  // namespace jointid::structure
