#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "tests/test_folder.hpp"

namespace jointid::cli {

/// What an output of before holds: jointid replaces files that it wrote.
inline const std::string old_output = "# jointid: an output of before\n";


/// A temporary folder with right input for tests to spoil; it goes with the object. It holds
///   - case A1 as written by `problem write`: A1.toml, A1_assembly.h5, A1_substructure_1.h5, A1_substructure_2.h5;
///   - small_set() as a.h5, a.uff (text), b.uff (binary) and a.csv;
///   - old.json, an output of before.
class InputFolder {
 public:
  InputFolder();

  std::filesystem::path path(const std::string& name = "") const { return folder_ / name; }
  std::string text(const std::string& name) const;
  void write(const std::string& name, const std::string& text) const;
  /// Replaces the first `from` of a file; throws when there is none.
  void replace(const std::string& name, const std::string& from, const std::string& to) const;

  /// Everything in it: relative name and bytes ("/" for folders, "link to …", "no file" for pipes).
  std::map<std::string, std::string> content() const;

 private:
  TestFolder folder_;
};

/// Lines 10, 20 and 30 Hz, responses 1:+Y and 2:+Y, reference 1:+Y.
frf::FrfSet small_set();

/// What spoils a folder.
using Spoil = std::function<void(const InputFolder&)>;

/// Replaces the first `from` in a file, or in the scene A1.toml.
Spoil edit(std::string file, std::string from, std::string to);
Spoil scene(std::string from, std::string to);

/// Rewrites an HDF5 set of the folder as `change` leaves it.
Spoil with_set(std::string file, std::function<void(frf::FrfSet&)> change);

/// Cuts a file to `bytes`.
Spoil cut(std::string file, std::size_t bytes);

/// One after the other.
Spoil both(Spoil first, Spoil second);

}  // namespace jointid::cli
