#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace jointid::frf {

/// Indices first … end−1.
struct IndexRange {
  std::size_t first = 0, end = 0;

  bool operator==(const IndexRange&) const = default;
};

/// What records belong to: named things that their numbers depend on, such as the scene and the seed, in any text.
struct JournalPart {
  std::string name, text;
};
using JournalKey = std::vector<JournalPart>;  ///< at most 6

/// Records of C numbers, each at the place of its index in a plain file and with a checksum: whoever dies at any moment
/// leaves every record that was put whole, and a record that was cut short counts as not there. put() may be called from
/// several threads at once; two processes on one journal keep each other out.
///
/// Layout: 72 bytes: "jointid-journa2\n", C, and the checksums of six parts of the key. Record i stands at
/// 72 + i·8·(C+1): C numbers and a checksum of index and numbers.
class RecordJournal {
 public:
  enum class Start { fresh, resume };

  /// Fresh: throws InputError (usage) when the file is there already. Resume: takes up what a journal of the same key holds,
  /// starts one when there is none; throws InputError (usage) that names the parts of the key that differ.
  RecordJournal(std::filesystem::path path, const JournalKey& key, std::size_t columns, Start start);
  ~RecordJournal();
  RecordJournal(const RecordJournal&) = delete;
  RecordJournal& operator=(const RecordJournal&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Which of the records [0, count) are not there or not whole, ascending, with records between any two ranges.
  std::vector<IndexRange> missing(std::size_t count) const;

  /// Throws InputError when the disk does not take it.
  void put(std::size_t index, std::span<const double> record);

  /// Numbers of the records [first, first + count), all of which must be whole.
  std::vector<double> read(std::size_t first, std::size_t count) const;

  /// Asks the disk to keep what was put even when the power fails.
  void sync() const;

  /// Removes the file.
  void remove();

 private:
  [[noreturn]] void fail(const std::string& problem) const;
  [[noreturn]] void refuse(const std::string& problem) const;
  void start_file(const JournalKey& key);
  void check_file(const JournalKey& key);
  std::size_t load(std::size_t first, std::vector<double>& slots) const;
  bool is_whole(std::size_t index, const double* slot) const;

  std::filesystem::path path_;
  std::size_t columns_;
  int file_ = -1;
};

/// "another scene and another seed" of these names; throws nothing.
std::string named_others(const std::vector<std::string>& names);

/// 64-bit FNV-1a.
std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t start = 0xcbf29ce484222325ULL);

}  // namespace jointid::frf
