#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "frf/hdf5/table_file.hpp"
#include "study/study_records.hpp"

namespace jointid::study {
namespace {

constexpr std::size_t most_parts = 100000, rows_at_once = 4096;

[[noreturn]] void fail(const std::string& file, const std::string& place, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::usage, file, place, std::move(problem), std::move(remedy)});
}

std::optional<std::size_t> whole(std::string_view text) {
  std::size_t out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return out;
}

struct PartFile {
  ident::Path path;
  std::unique_ptr<frf::TableReader> table;
  StudyPart part;
  std::size_t trials = 0;  ///< of the whole study
};

std::string part_text(const frf::TableHeader& header, const std::string& name) {
  const auto found = header.texts.find(name);
  return found == header.texts.end() ? std::string() : found->second;
}

PartFile read_part(const ident::Path& path) {
  PartFile out{.path = path, .table = std::make_unique<frf::TableReader>(path), .part = {}, .trials = 0};
  const frf::TableHeader& header = out.table->header();
  const auto trials = whole(part_text(header, "part_trials"));
  if (!trials) fail(path.string(), "", "it is no part of a study", "give files of `jointid study --part`");
  out.part = parse_part(part_text(header, "part"));
  out.trials = *trials;
  const frf::IndexRange range = trials_of(out.part, out.trials);
  if (out.table->rows() != range.end - range.first)
    fail(path.string(), "", fmt::format("it has {} trials, not {}", out.table->rows(), range.end - range.first),
         "run this part again");
  return out;
}

/// Of the whole study: without what is of a part.
frf::TableHeader whole_header(frf::TableHeader header) {
  for (const char* name : {"part", "part_trials", "part_title", "part_notes"}) header.texts.erase(name);
  return header;
}

bool is_same(const frf::TableColumn& a, const frf::TableColumn& b) {
  return a.name == b.name && a.unit == b.unit && std::bit_cast<std::uint64_t>(a.truth) == std::bit_cast<std::uint64_t>(b.truth);
}

/// What two parts differ in, in words; empty where they are of one study.
std::string difference(const PartFile& one, const PartFile& other) {
  frf::TableHeader a = whole_header(one.table->header()), b = whole_header(other.table->header());
  for (frf::TableHeader* each : {&a, &b}) each->texts.erase("provenance");
  for (const auto& [name, called] : {std::pair("scene_hash", "scene"),
                                     {"data_hash", "set of data"},
                                     {"seed", "seed"},
                                     {"jointid_version", "version of jointid"}}) {
    if (part_text(a, name) != part_text(b, name)) return called;
  }
  if (one.part.count != other.part.count) return "number of parts";
  if (one.trials != other.trials) return "number of trials";
  const bool same = a.texts == b.texts && std::ranges::equal(a.columns, b.columns, is_same);
  return same ? "" : "set of unknowns";
}

std::string name_of(const StudyPart& part) { return fmt::format("{}/{}", part.number, part.count); }

void require_one_study(const std::vector<PartFile>& parts) {
  for (const PartFile& each : parts) {
    const std::string other = difference(parts.front(), each);
    if (!other.empty())
      fail(each.path.string(), "--merge", "it is of another " + other + " than " + parts.front().path.string(),
           "merge parts of one study");
  }
}

/// `parts` is in order.
void require_each_once(const std::vector<PartFile>& parts) {
  const std::size_t count = parts.front().part.count;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].part.number == parts[i - 1].part.number)
      fail(parts[i].path.string(), "--merge",
           "part " + name_of(parts[i].part) + " is there twice, also in " + parts[i - 1].path.string(), "give each part once");
  }
  std::string missing;
  std::size_t next = 0;
  for (std::size_t number = 1; number <= count; ++number) {
    if (next < parts.size() && parts[next].part.number == number) {
      ++next;
    } else if (missing.size() < 60) {
      missing += (missing.empty() ? "" : ", ") + name_of({number, count});
    }
  }
  if (!missing.empty()) {
    fail("", "--merge", "parts are missing: " + missing, "run them by `jointid study SCENE --part`, and give all files");
  }
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(text.size(), end == std::string_view::npos ? text.size() : end + 1));
  }
  return out;
}

void append(const PartFile& part, frf::TableWriter& to) {
  const std::size_t columns = part.table->header().columns.size();
  for (std::size_t first = 0; first < part.table->rows(); first += rows_at_once) {
    const std::size_t count = std::min(rows_at_once, part.table->rows() - first);
    std::vector<double> rows(count * columns), column(count);
    for (std::size_t c = 0; c < columns; ++c) {
      part.table->read(c, first, column);
      for (std::size_t i = 0; i < count; ++i) rows[i * columns + c] = column[i];
    }
    to.append(rows);
  }
}

}  // namespace

StudyPart parse_part(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto number = whole(std::string_view(text).substr(0, slash));
  const auto count = slash == std::string::npos ? std::nullopt : whole(std::string_view(text).substr(slash + 1));
  if (!number || !count || *number < 1 || *number > *count || *count > most_parts) {
    fail("", "--part", "'" + text + "' is no part of a study",
         fmt::format("give e.g. 3/16, the third of 16 parts, {} at most", most_parts));
  }
  return {*number, *count};
}

frf::IndexRange trials_of(const StudyPart& part, std::size_t trials) {
  const std::size_t each = trials / part.count, more = trials % part.count;  // n·k/K would overflow
  const auto begin = [&](std::size_t before) { return each * before + more * before / part.count; };
  return {begin(part.number - 1), begin(part.number)};
}

std::map<std::string, std::string> texts_of(const StudyPart& part, std::size_t trials, const std::string& title,
                                            const std::vector<std::string>& notes) {
  if (part.count == 1) return {};
  std::string lines;
  for (const std::string& note : notes) lines += note + "\n";
  return {{"part", name_of(part)}, {"part_trials", std::to_string(trials)}, {"part_title", title}, {"part_notes", lines}};
}

MergedStudy merge_parts(std::span<const ident::Path> files, const ident::Path& out) {
  if (files.empty()) fail("", "--merge", "there are no parts", "give the files of `jointid study --part`");
  std::vector<PartFile> parts;
  for (const ident::Path& file : files) parts.push_back(read_part(file));
  require_one_study(parts);
  std::ranges::stable_sort(parts, {}, [](const PartFile& each) { return each.part.number; });
  require_each_once(parts);
  const frf::TableHeader& first = parts.front().table->header();
  frf::TableWriter table(out, whole_header(first), parts.front().trials);
  for (const PartFile& part : parts) append(part, table);
  table.finish();
  return {.title = part_text(first, "part_title"),
          .scene_hash = part_text(first, "scene_hash"),
          .notes = lines_of(part_text(first, "part_notes")),
          .seed = std::stoull(part_text(first, "seed")),
          .trials = parts.front().trials};
}

}  // namespace jointid::study
