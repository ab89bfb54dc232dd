#pragma once

#include <filesystem>

namespace jointid::tasks {

/// What a file holds that somebody drops on a window.
enum class FileKind {
  frfs,
  geometry,       ///< a universal file with nodes, and no FRFs
  time_record,    ///< of a universal file, or columns with one of times
  loading_curve,  ///< columns of displacement and force by their names
  other           ///< nothing that is known
};

/// Opens the file: FRFs come first, then curves, time records, nodes. Throws nothing for what is none of them.
FileKind kind_of_file(const std::filesystem::path& file);

}  // namespace jointid::tasks
