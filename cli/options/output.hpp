#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "ident/scene/scene_files.hpp"

namespace jointid::cli {

/// An option and the target that it was given, if any.
using OptionTarget = std::pair<std::string, std::optional<std::string>>;

/// Throws InputError for what would go wrong after a long run, or would cost somebody a file, and can be seen before anything is
/// read or written: an empty name, one file for two results, an input as a target (usage; the message names both); a folder, or a
/// folder that is not there; a pipe or a device as input or target, which a reader would wait for. Two names are of one file when
/// they lead to one path behind all links, or to one file (device and inode): hard links count. Standard output counts where the
/// shell sends it to a file. `inputs`: all that the command reads, e.g. ident::files_of(scene); `targets`: all that it writes,
/// those that go beside a result of another name included. A file that is there already is replaced only if it looks like one of
/// jointid's own (own_file.hpp), unless allow_overwriting() was called. A page as PDF needs a browser (pdf.hpp). `records`: the
/// command writes records or motions, of which any is taken for one of its own. A name that ends in that of another format than
/// --report, --json or --csv write (--report r.docx) is an error of use.
void check_targets(const std::vector<ident::NamedFile>& inputs, const std::vector<OptionTarget>& targets, bool records = false);

/// From now on check_targets() lets any file be replaced but inputs: --force.
void allow_overwriting();

/// Whether one of the targets is standard output, so that nothing else may go there.
bool takes_output(const std::vector<std::optional<std::string>>& targets);

/// Writes to `out` when the target is "-", else to the file of that name, whole or not at all; a page to a file .pdf is printed. JSON and
/// pages say how they were made (with_provenance()).
void write_target(const std::string& target, const std::string& result, std::ostream& out);

}  // namespace jointid::cli
