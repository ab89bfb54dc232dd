#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "correlation/expanded_frfs.hpp"
#include "ident/scene/scene_files.hpp"

namespace jointid::tasks {

/// FRFs of two files, and source_doubts() of what was measured, each with the name of its file.
struct ComparedFrfs {
  frf::FrfSet one, other;
  std::vector<std::string> notes;
};

/// FRFs of two files. One of them may be the description of a model (docs/model-parts.md): it has the lines of the other. Throws
/// InputError as frf::open_as_one() and models::open_model(), and where both are models.
ComparedFrfs read_compared(const std::filesystem::path& one, const std::filesystem::path& other);

/// Modes of a file: dataset 55, or the JSON of `jointid modalfit`. Throws InputError as frf::read_uff55() and modes_of_result().
correlation::ModeFile read_modes(const std::filesystem::path& file);

/// What was expanded, and source_doubts() of the file that was measured and of a parent that is one of FRFs.
struct ExpandedFiles {
  correlation::ExpandedFrfs expanded;
  std::vector<std::string> notes;
};

/// correlation::expanded() by way "extended" or "semm", whose parent has FRFs or is the description of a model, or "serep", whose
/// parent has modes, of which so many are kept (0: all).
ExpandedFiles expanded_files(const std::filesystem::path& parent, const std::filesystem::path& measured, const std::string& way,
                             std::size_t modes);

/// A file of a comparison with those that it names, if it is the description of a model: none may be written to.
std::vector<ident::NamedFile> compared_inputs(const std::filesystem::path& file, const std::string& place);

}  // namespace jointid::tasks
