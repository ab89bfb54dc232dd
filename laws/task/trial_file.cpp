#include "laws/task/trial_file.hpp"

#include <fmt/format.h>

#include <sstream>
#include <vector>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "base/temporary_file.hpp"
#include "frf/hdf5/record_journal.hpp"
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

/// Which of what the second line says differs, by name.
std::string differences(const std::string& text, const std::string& head) {
  const auto word_behind = [](const std::string& of, const std::string& name) {
    const std::size_t at = of.find(" " + name + " ", of.find('\n'));
    const char* const ends = name == "laws" ? "\n" : " \n";
    return at == std::string::npos ? std::string() : of.substr(at, of.find_first_of(ends, at + name.size() + 2) - at);
  };
  std::vector<std::string> others;
  for (const auto& [name, called] : {std::pair{"scene", "scene"}, {"data", "set of data"}, {"seed", "seed"}, {"laws", "list of laws"}}) {
    if (word_behind(text, name) != word_behind(head, name)) others.emplace_back(called);
  }
  return others.empty() ? "another version of jointid" : frf::named_others(others);
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
    fail(path_, "its trials are of " + differences(text, head),
         "leave out --resume to begin anew, or give the scene and seed that it was made with");
  std::istringstream rows(text.substr(head.size(), text.rfind('\n') + 1 - head.size()));
  for (std::string line; std::getline(rows, line);) {
    auto trial = trial_of(line, values_);
    if (trial) known_.push_back(std::move(*trial));
  }
}

void TrialFile::add(const LawTrial& trial) {
  out_ << line_of(trial, values_) << std::flush;
  if (!out_) fail(path_, "cannot be written", "is the disk full?");
}

}  // namespace jointid::laws
