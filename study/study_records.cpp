#include "study/study_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/error.hpp"
#include "study/study_options.hpp"

namespace jointid::study {
namespace {

constexpr std::size_t block = 4096;  ///< rows in memory at a time

/// The texts that say what a study is of, and what messages call them.
constexpr std::array<std::pair<const char*, const char*>, 4> named_texts = {
    {{"scene_hash", "scene"}, {"data_hash", "set of data"}, {"seed", "seed"}, {"jointid_version", "version of jointid"}}};

std::string text_of(const frf::TableHeader& header, const std::string& name) {
  const auto found = header.texts.find(name);
  return found == header.texts.end() ? std::string() : found->second;
}

frf::JournalKey key_of(const frf::TableHeader& header) {
  frf::JournalKey key;
  for (const auto& [name, called] : named_texts) key.push_back({called, text_of(header, name)});
  std::string others;
  for (const auto& text : header.texts) {
    const bool named = std::ranges::any_of(named_texts, [&](const auto& of) { return text.first == of.first; });
    if (!named && text.first != "part" && text.first != "provenance") others += text.first + "=" + text.second + "\n";
  }
  for (const frf::TableColumn& column : header.columns) others += column.name + "\n";
  key.push_back({"set of unknowns", others});
  if (header.texts.contains("part")) key.push_back({"part", text_of(header, "part")});
  return key;
}

/// What of a study differs from another, by name.
std::vector<std::string> differences(const frf::TableHeader& one, const frf::TableHeader& other) {
  const frf::JournalKey a = key_of(one), b = key_of(other);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (a[i].text != b[i].text) names.push_back(a[i].name);
  }
  return names;
}

}  // namespace

StudyRecords::StudyRecords(const StudyOptions& options, frf::TableHeader header) : options_(options), header_(std::move(header)) {
  const frf::IndexRange range = trials_of(options.part, options.trials);
  rows_ = range.end - range.first;
  const bool left = std::filesystem::exists(journal_path(options.out));
  const std::size_t finished = options.resume && !left ? finished_trials() : 0;
  if (finished == rows_) return;
  using Start = frf::RecordJournal::Start;
  journal_.emplace(journal_path(options.out), key_of(header_), header_.columns.size(), options.resume ? Start::resume : Start::fresh);
  if (finished > 0) take_over(finished);
}

/// The trials of OUT, which has fewer than are asked for, go into the journal.
void StudyRecords::take_over(std::size_t finished) {
  const frf::TableReader table(options_.out);
  const std::size_t columns = header_.columns.size();
  for (std::size_t first = 0; first < finished; first += block) {
    const std::size_t count = std::min(block, finished - first);
    std::vector<double> rows(count * columns), column(count);
    for (std::size_t c = 0; c < columns; ++c) {
      table.read(c, first, column);
      for (std::size_t i = 0; i < count; ++i) rows[i * columns + c] = column[i];
    }
    for (std::size_t i = 0; i < count; ++i) journal_->put(first + i, std::span(rows).subspan(i * columns, columns));
  }
}

std::vector<frf::IndexRange> StudyRecords::missing() const {
  return journal_ ? journal_->missing(rows_) : std::vector<frf::IndexRange>();
}

void StudyRecords::put(std::size_t trial, std::span<const double> row) { journal_->put(trial, row); }

void StudyRecords::sync() const { journal_->sync(); }

void StudyRecords::finish() {
  if (!journal_) return;
  frf::TableWriter table(options_.out, header_, rows_);
  for (std::size_t first = 0; first < rows_; first += block) {
    table.append(journal_->read(first, std::min(block, rows_ - first)));
  }
  table.finish();
  journal_->remove();
}

/// Trials of this very study that OUT has, 0 where it is not there. Throws InputError when it is another, or has more.
std::size_t StudyRecords::finished_trials() const {
  if (!std::filesystem::exists(options_.out)) return 0;
  const frf::TableReader table(options_.out);
  const std::vector<std::string> others = differences(table.header(), header_);
  if (!others.empty()) refuse("it is complete and belongs to " + frf::named_others(others));
  if (table.rows() > rows_) refuse(fmt::format("it has {} trials already", table.rows()));
  return table.rows();
}

void StudyRecords::refuse(const std::string& problem) const {
  throw InputError({.kind = ErrorKind::usage,
                    .file = options_.out.string(),
                    .place = "--resume",
                    .problem = problem,
                    .remedy = "repeat that run with as many trials or more, or give another --out"});
}

}  // namespace jointid::study
