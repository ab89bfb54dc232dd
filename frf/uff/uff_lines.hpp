#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// Two nodes with a line between them.
using NodeLine = std::array<std::int64_t, 2>;

/// What a universal file draws of its structure: trace lines (dataset 82) and the edges of elements (2412: rods and beams, plane
/// elements round their edge, linear tetrahedra, wedges and bricks; others are left out), each line once. Throws InputError for
/// a file that is none, and for a record that is no number; the nodes need not be there.
std::vector<NodeLine> read_uff_lines(const std::filesystem::path& path);

/// The nodes of a universal file (datasets 15 and 2411), which need not have FRFs; positions in m. Throws InputError as read_uff_lines().
std::vector<Node> read_uff_nodes(const std::filesystem::path& path);

}  // namespace jointid::frf
