#pragma once

#include <string>
#include <vector>

#include "ident/scene/scene_files.hpp"

namespace jointid::cli {

/// How a result was made: version and commit of the program, its command line and folder, every input with its size and SHA-256, and the
/// shared libraries that were loaded. It has no date and no time: the same run gives the same bytes.

/// The run begins: what is told of it comes from this command line, without inputs.
void begin_provenance(int argc, const char* const* argv);

/// Files that the run reads. A file that is named twice counts once.
void add_provenance_inputs(const std::vector<ident::NamedFile>& inputs);

/// A JSON object with the key `provenance` at its end, or a page with it in its footer; other texts as they are. Reads the inputs.
std::string with_provenance(std::string text);

/// The same as a JSON text of one line, for the attribute of HDF5 files.
std::string provenance_text();

/// Of a study: with these words as its command, and without folder and libraries, so that its file has the same bytes in one run, in
/// parts, resumed or under mpirun.
std::string study_provenance(const std::vector<std::string>& command);

/// The commit that the program was built from, 40 digits, with "-dirty" for changed sources; "unknown" outside of a clone.
std::string built_from();

}  // namespace jointid::cli
