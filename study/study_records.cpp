#include "study/study_records.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "study/study_options.hpp"

namespace jointid::study {
namespace {

std::string key_of(const frf::TableHeader& header) {
  std::string key;
  for (const auto& [name, text] : header.texts) key += name + "=" + text + "\n";
  for (const frf::TableColumn& column : header.columns) key += column.name + "\n";
  return key;
}

}  // namespace

StudyRecords::StudyRecords(const StudyOptions& options, frf::TableHeader header) : options_(options), header_(std::move(header)) {
  if (options.resume && !std::filesystem::exists(journal_path(options.out)) && is_complete()) return;
  using Start = frf::RecordJournal::Start;
  journal_.emplace(journal_path(options.out), key_of(header_), header_.columns.size(), options.resume ? Start::resume : Start::fresh);
}

std::vector<frf::IndexRange> StudyRecords::missing() const {
  return journal_ ? journal_->missing(options_.trials) : std::vector<frf::IndexRange>();
}

void StudyRecords::put(std::size_t trial, std::span<const double> row) { journal_->put(trial, row); }

void StudyRecords::sync() const { journal_->sync(); }

void StudyRecords::finish() {
  if (!journal_) return;
  constexpr std::size_t block = 4096;
  frf::TableWriter table(options_.out, header_, options_.trials);
  for (std::size_t first = 0; first < options_.trials; first += block) {
    table.append(journal_->read(first, std::min(block, options_.trials - first)));
  }
  table.finish();
  journal_->remove();
}

/// Whether OUT is this very study. Throws InputError when it is another.
bool StudyRecords::is_complete() const {
  if (!std::filesystem::exists(options_.out)) return false;
  const frf::TableReader table(options_.out);
  if (key_of(table.header()) == key_of(header_) && table.rows() == options_.trials) return true;
  throw InputError({.kind = ErrorKind::usage,
                    .file = options_.out.string(),
                    .place = "--resume",
                    .problem = "it is complete and belongs to another scene, seed, version or number of trials",
                    .remedy = "repeat that run, or give another --out"});
}

}  // namespace jointid::study
