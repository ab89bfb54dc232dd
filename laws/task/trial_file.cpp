#include "laws/task/trial_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <sstream>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "base/temporary_file.hpp"
#include "laws/task/identify_laws.hpp"

namespace jointid::laws {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, path.string(), {}, std::move(problem), std::move(remedy)});
}

/// FNV-1a, the same on every machine.
std::uint64_t fingerprint(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

/// The lines before the trials, which say what they are of.
std::string head_of(const TrialFileKey& key) {
  std::string numbers, columns = "trial,status,laws,usable,contradicts,undecided,missed,chi_square";
  for (const StudiedValue& value : key.plan.values) {
    numbers += fmt::format(" {} {}", value.truth, value.bound);
    const std::string name = value.joint + " " + value.name;
    columns += fmt::format(",{0},{0} low,{0} high", name.find(',') == std::string::npos ? name : "value");
  }
  return fmt::format("# jointid study of friction laws, version 1\n# scene {:016x} data {:016x} seed {} laws {}\n{}\n",
                     fingerprint(key.scene), fingerprint(numbers), key.seed, laws_text(key.plan.laws), columns);
}

std::string line_of(const LawTrial& trial, std::size_t values) {
  std::string text = fmt::format("{},{},{},{:d},{:d},{:d},{:d},{}", trial.trial, trial.status, trial.laws, trial.usable,
                                 trial.contradicts, trial.undecided, trial.missed, trial.chi_square);
  for (std::size_t i = 0; i < values; ++i) {
    const LawTrial::Value value = i < trial.values.size() ? trial.values[i] : LawTrial::Value{nan, nan, nan};
    text += fmt::format(",{},{},{}", value.value, value.low, value.high);
  }
  return text + "\n";
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

std::optional<LawTrial> parse(const std::string& line, std::size_t values) {
  constexpr std::size_t before = 8;
  const std::vector<std::string> cells = cells_of(line);
  if (cells.size() != before + 3 * values) return std::nullopt;
  const auto number = [](const std::string& cell) {
    double value = nan;
    if (cell != "nan" && cell != "-nan" && std::from_chars(cell.data(), cell.data() + cell.size(), value).ec != std::errc())
      value = nan;
    return value;
  };
  LawTrial out;
  if (std::from_chars(cells[0].data(), cells[0].data() + cells[0].size(), out.trial).ec != std::errc()) return std::nullopt;
  out.status = cells[1];
  out.laws = cells[2];
  out.usable = cells[3] == "1";
  out.contradicts = cells[4] == "1";
  out.undecided = cells[5] == "1";
  out.missed = cells[6] == "1";
  out.chi_square = number(cells[7]);
  for (std::size_t i = 0; i < values; ++i)
    out.values.push_back({number(cells[before + 3 * i]), number(cells[before + 3 * i + 1]), number(cells[before + 3 * i + 2])});
  return out;
}

}  // namespace

TrialFile::TrialFile(std::filesystem::path path, const TrialFileKey& key, bool resume)
    : path_(std::move(path)), values_(key.plan.values.size()) {
  const std::string head = head_of(key);
  if (resume && std::filesystem::exists(path_)) {
    read(head);
    std::string text = head;
    for (const LawTrial& trial : known_) text += line_of(trial, values_);
    write_text(path_, text);
    out_.open(path_, std::ios::app);
  } else {
    out_.open(path_, std::ios::trunc);
    out_ << head << std::flush;
  }
  if (!out_) fail(path_, "cannot be written", "name another file by --out");
}

void TrialFile::read(const std::string& head) {
  std::ifstream in(path_);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  if (!text.starts_with(head))
    fail(path_, "its trials are of another scene, seed or data",
         "leave out --resume to begin anew, or give the scene and seed that it was made with");
  std::istringstream rows(text.substr(head.size(), text.rfind('\n') + 1 - head.size()));
  for (std::string line; std::getline(rows, line);) {
    auto trial = parse(line, values_);
    if (trial) known_.push_back(std::move(*trial));
  }
}

void TrialFile::add(const LawTrial& trial) {
  out_ << line_of(trial, values_) << std::flush;
  if (!out_) fail(path_, "cannot be written", "is the disk full?");
}

}  // namespace jointid::laws
