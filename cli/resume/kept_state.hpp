#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ident/scene/scene_files.hpp"

namespace jointid::cli {

/// The file with what an interrupted command found so far, for `--resume`.
///
/// Layout: a line "jointid-state 1"; a line of JSON with `command`, `version`, `scene` (SHA-256 of what it asks for, see
/// scene::contents_of()), `inputs` with their `file` and `sha256`, and `bytes` and `checksum` (64-bit FNV-1a) of what follows; the state
/// itself. A build without OpenSSL has FNV-1a in place of SHA-256.
class KeptState {
 public:
  /// `inputs`: ident::files_of() of the scene, itself first. They are read when a state is read or put for the first time.
  KeptState(std::filesystem::path file, std::string command, std::string scene_text, std::vector<ident::NamedFile> inputs);

  const std::filesystem::path& file() const { return file_; }

  /// What a run before put; nothing where no file is. Throws InputError that names what differs for a state of another command, version,
  /// scene or input (usage), and for a file that is damaged or no state (data).
  std::optional<std::string> read();

  /// Whole or not at all. Throws InputError where the folder does not take it.
  void put(const std::string& state);

  /// The same; why it was not put, or nothing.
  std::string why_not_put(const std::string& state);

  /// Of a run that is complete: removes what read() found or put() wrote.
  void remove();

 private:
  struct Sum {
    std::string file, sum;
  };
  const std::string& scene_sum();
  const std::vector<Sum>& sums();
  std::vector<std::string> others(const std::string& header);

  std::filesystem::path file_;
  std::string command_, scene_text_, scene_sum_;
  std::vector<ident::NamedFile> inputs_;
  std::vector<Sum> sums_;
  bool is_own_ = false;  ///< read or put
};

}  // namespace jointid::cli
