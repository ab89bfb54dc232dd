#include "cli/options/output.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/temporary_file.hpp"
#include "frf/text/unit_names.hpp"
#include "cli/options/own_file.hpp"
#include "cli/options/pdf.hpp"
#include "cli/provenance/provenance.hpp"

namespace jointid::cli {

namespace {

using Path = std::filesystem::path;

[[noreturn]] void refuse(const std::string& target, const std::string& why, const std::string& remedy) {
  throw InputError({ErrorKind::data, target, "", why, remedy});
}

[[noreturn]] void refuse_use(const std::string& options, const std::string& why, const std::string& remedy) {
  throw InputError({ErrorKind::usage, "", options, why, remedy});
}

void require_folder(const std::string& target) {
  std::error_code ignored;
  if (std::filesystem::is_directory(target, ignored)) {
    refuse(target, "cannot be written: it is a folder", "name a file in it");
  }
  const std::filesystem::file_status status = std::filesystem::status(target, ignored);
  if (exists(status) && !is_regular_file(status)) {
    const Path file = std::filesystem::canonical(target, ignored);
    refuse(file.empty() ? target : file.filename().string(), "cannot be written: there is something else than a file",
           "name a file");
  }
  const Path folder = Path(target).parent_path();
  if (folder.empty() || std::filesystem::is_directory(folder, ignored)) return;
  const bool exists = std::filesystem::exists(folder, ignored);
  refuse(target, "cannot be written: " + folder.string() + (exists ? " is no folder" : " does not exist"),
         exists ? "name a file in a folder" : "make the folder first");
}

/// Device and inode of what is there.
using FileInode = std::optional<std::pair<dev_t, ino_t>>;

FileInode inode_of(const Path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return std::pair(status.st_dev, status.st_ino);
}

/// Of standard output where it goes to a file.
FileInode inode_of_output() {
  struct stat status {};
  if (::fstat(STDOUT_FILENO, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return std::pair(status.st_dev, status.st_ino);
}

/// The path behind all links, those included that lead to nothing yet.
Path behind_links(const Path& name) {
  constexpr int most_links = 40;  // as the kernel follows
  std::error_code error;
  Path path = std::filesystem::absolute(name, error);
  for (int links = 0; links < most_links && std::filesystem::is_symlink(path, error); ++links) {
    path = path.parent_path() / std::filesystem::read_symlink(path, error);
  }
  const Path canonical = std::filesystem::weakly_canonical(path, error);
  return error ? path.lexically_normal() : canonical;
}

/// What a name stands for.
struct FileIdentity {
  Path path;
  FileInode inode;

  bool operator==(const FileIdentity& other) const { return path == other.path || (inode && inode == other.inode); }
};

FileIdentity identity_of(const Path& name) { return {behind_links(name), inode_of(name)}; }

/// A file that is written.
struct OutputFile {
  std::string option, target;
  FileIdentity identity;

  std::string words() const { return option + " " + target; }
};

void require_different(const OutputFile& one, const OutputFile& other) {
  const std::string options = one.words() + " " + other.words();
  if (one.target == "-" && other.target == "-") refuse_use(options, "both want standard output", "give one of them a file");
  if (one.identity == other.identity) refuse_use(options, "both want the same file", "give each its own");
}

void require_no_input(const OutputFile& output, const std::vector<ident::NamedFile>& inputs) {
  for (const ident::NamedFile& input : inputs) {
    if (output.identity != identity_of(input.path)) continue;
    refuse_use(output.words(), "would replace the input " + input.path.string() + " (" + input.place + ")", "give another name");
  }
}

/// What the shell has opened for standard output is no input.
void require_output_apart(const std::vector<ident::NamedFile>& inputs) {
  const FileInode output = inode_of_output();
  for (const ident::NamedFile& input : inputs) {
    if (!output || output != inode_of(input.path)) continue;
    refuse_use("standard output", "would be written into the input " + input.path.string() + " (" + input.place + ")",
               "redirect it to another file");
  }
}

bool overwriting = false;  ///< --force was given

void require_own(const OutputFile& output, bool record) {
  std::error_code ignored;
  if (overwriting || !std::filesystem::is_regular_file(output.target, ignored) || is_own_file(output.target, record)) return;
  refuse_use(output.words(), "is there already and does not look like a file of jointid",
             "give another name, or --force (--overwrite, where that names a column) to replace it");
}

/// What the ending of a file says that it is, where an option writes something else.
void require_ending(const OutputFile& output) {
  static const std::map<std::string, std::vector<std::string>> own = {
      {"--report", {".html", ".htm", ".xhtml", ".pdf"}}, {"--json", {".json"}}, {"--csv", {".csv", ".txt", ".tsv", ".dat"}}};
  static const std::set<std::string> telling = {".html", ".htm", ".pdf",  ".json", ".csv", ".h5",  ".hdf5", ".uff", ".unv", ".mat",
                                                ".npy",  ".npz", ".toml", ".doc",  ".docx", ".odt", ".rtf",  ".xls", ".xlsx", ".ods",
                                                ".ppt",  ".pptx", ".tex", ".md",   ".png", ".svg", ".jpg",  ".jpeg", ".ps", ".eps"};
  const std::string ending = frf::lower_case(Path(output.target).extension().string());
  const auto kind = own.find(output.option);
  if (kind == own.end() || !telling.contains(ending) || std::ranges::find(kind->second, ending) != kind->second.end()) return;
  std::string names;
  for (const std::string& each : kind->second) names += " " + each;
  refuse_use(output.words(), "would not be a file of the kind that " + ending + " names", "name it" + names);
}

/// "-" is standard output, a file where the shell says so.
FileIdentity target_identity(const std::string& target) {
  if (target == "-") return {"-", inode_of_output()};
  return identity_of(target);
}

}  // namespace

void check_targets(const std::vector<ident::NamedFile>& inputs, const std::vector<OptionTarget>& targets, bool records) {
  for (const ident::NamedFile& input : inputs) require_regular_file(input.path);
  require_output_apart(inputs);
  add_provenance_inputs(inputs);
  std::vector<OutputFile> outputs;
  for (const auto& [option, target] : targets) {
    if (!target) continue;
    if (target->empty()) refuse_use(option, "the name is empty", "name a file");
    const OutputFile output{option, *target, target_identity(*target)};
    for (const OutputFile& other : outputs) require_different(other, output);
    outputs.push_back(output);
    if (*target == "-") continue;
    require_no_input(output, inputs);
    require_folder(*target);
  }
  for (const OutputFile& output : outputs) {
    if (output.target == "-") continue;
    require_ending(output);
    require_own(output, records);
    if (output.option == "--report" && is_pdf(output.target)) require_browser(output.words());
  }
}

void allow_overwriting() { overwriting = true; }

bool takes_output(const std::vector<std::optional<std::string>>& targets) {
  return std::ranges::find(targets, "-") != targets.end();
}

void write_target(const std::string& target, const std::string& result, std::ostream& out) {
  const std::string text = with_provenance(result);
  if (target == "-") {
    out << text;
  } else {
    write_text(target, is_pdf(target) && text.starts_with("<!DOCTYPE html>") ? printed(text, target) : text);
  }
}

}  // namespace jointid::cli
