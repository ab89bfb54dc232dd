// Every command that writes files, stopped at the calls by which it does: killed, interrupted, and with the disk full from there on.
// A file of before is whole, or the new one is.
#include <gmock/gmock.h>
#include <sched.h>
#include <sys/mount.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <set>

#include "base/error.hpp"
#include "frf/hdf5/table_file.hpp"
#include "frf/mat/mat_module.hpp"
#include "frf/set/frf_source.hpp"
#include "input_folder.hpp"
#include "problems/case/coupling_problem.hpp"
#include "problems/thesis/loading_curves.hpp"
#include "run_command.hpp"
#include "tests/require.hpp"
#include "tests/test_folder.hpp"

namespace jointid::cli {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

struct Writing {
  std::string name;
  std::vector<std::string> command;
  std::vector<std::string> outputs;  ///< files, or "new/…" for a folder that is made
  Spoil prepare = {};                ///< input that an InputFolder does not have
};

void PrintTo(const Writing& writing, std::ostream* out) { *out << writing.name; }

class Environment {
 public:
  explicit Environment(std::vector<std::pair<std::string, std::string>> set) : set_(std::move(set)) {
    for (const auto& [name, value] : set_) ::setenv(name.c_str(), value.c_str(), 1);
  }
  ~Environment() {
    for (const auto& [name, value] : set_) ::unsetenv(name.c_str());
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::vector<std::pair<std::string, std::string>> set_;
};

/// A folder with right input for all commands, and with outputs of before.
class StoppedFolder : public InputFolder {
 public:
  explicit StoppedFolder(const Writing& writing) {
    if (writing.prepare) writing.prepare(*this);
    for (const std::string& output : writing.outputs) {
      if (!output.starts_with("new/")) write(output, old_output);
    }
    before_ = content();
  }

  Outcome run(const Writing& writing, std::vector<std::pair<std::string, std::string>> how) const {
    how.emplace_back("LD_PRELOAD", STOP_AT_CALL);
    how.emplace_back("ASAN_OPTIONS", "verify_asan_link_order=0");
    const Environment environment(std::move(how));
    return run_command(path(), writing.command);
  }

  const std::map<std::string, std::string>& before() const { return before_; }

 private:
  std::map<std::string, std::string> before_;
};

/// HDF5 files carry the time at which they were made.
/// All that a file of FRFs, or of trials, holds.
void read_hdf5(const std::filesystem::path& path, bool is_table) {
  if (!is_table) {
    frf::load(*frf::open(path));
    return;
  }
  const frf::TableReader table(path);
  std::vector<double> column(table.rows());
  for (std::size_t c = 0; c < table.header().columns.size(); ++c) table.read(c, 0, column);
}

/// Where its inputs lie differs from run to run, as it states how it was made.
bool is_whole_hdf5(const std::string& found, const std::string& reference) {
  const TestFolder folder;
  const auto path = folder / "found.h5";
  std::ofstream(path, std::ios::binary) << found;
  bool ok = found.size() == reference.size();
  try {
    read_hdf5(path, reference.find("jointid-table") != std::string::npos);
  } catch (const InputError&) {
    ok = false;
  }
  return ok;
}

/// Texts with run times differ from run to run: these are whole when they end as they should.
bool is_whole(const std::string& name, const std::string& found, const std::string& reference) {
  if (found == reference) return true;
  if (name.ends_with(".h5")) return is_whole_hdf5(found, reference);
  if (name.ends_with(".json")) return nlohmann::json::accept(found);
  if (name.ends_with(".html")) return found.ends_with(reference.substr(reference.size() - 10));
  if (name.ends_with(".csv")) return std::ranges::count(found, '\n') == std::ranges::count(reference, '\n') && found.ends_with('\n');
  return false;
}

class StoppedCommand : public testing::TestWithParam<Writing> {
 protected:
  /// The command undisturbed: what it leaves, and by how many calls.
  void SetUp() override {
    if (GetParam().name == "ConvertToMat" && !frf::has_matio()) JOINTID_SKIP("this build lacks matio");
    const StoppedFolder folder(GetParam());
    const TestFolder other;
    const std::string count = (other / "calls").string();
    const Outcome outcome = folder.run(GetParam(), {{"STOP_COUNT", count}});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    complete_ = folder.content();
    std::ifstream(count) >> calls_;
    ASSERT_GE(calls_, 3U * GetParam().outputs.size());
  }

  /// All calls, or twelve of them from the first to the last.
  std::set<std::size_t> moments() const {
    std::set<std::size_t> moments;
    for (std::size_t i = 0; i < 12; ++i) moments.insert(1 + i * (calls_ - 1) / 11);
    return moments;
  }

  /// Every file is as it was before or as it is after an undisturbed run; `others` says which more may be there.
  void expect_whole(const StoppedFolder& folder, const std::function<bool(const std::string&)>& others) const {
    auto found = folder.content();
    for (const auto& [name, bytes] : folder.before()) {
      ASSERT_TRUE(found.contains(name)) << name << " is gone";
      const bool is_output = std::ranges::find(GetParam().outputs, name) != GetParam().outputs.end();
      EXPECT_TRUE(found[name] == bytes || (is_output && is_whole(name, found[name], complete_.at(name))))
          << name << " is neither the old file nor the new one";
    }
    for (const auto& [name, bytes] : found) {
      if (folder.before().contains(name) || others(name)) continue;
      ASSERT_TRUE(complete_.contains(name)) << name << " is left over";
      EXPECT_TRUE(is_whole(name, bytes, complete_.at(name))) << name << " is not whole";
    }
  }

  std::map<std::string, std::string> complete_;
  std::size_t calls_ = 0;
};

/// What goes on after --resume.
bool is_journal(const std::string& name) { return name.ends_with(".partial"); }

TEST_P(StoppedCommand, KilledItLeavesOldOrNewFiles) {
  for (const std::size_t moment : moments()) {
    const StoppedFolder folder(GetParam());
    const Outcome outcome = folder.run(GetParam(), {{"STOP_AT", std::to_string(moment)}, {"STOP_HOW", "kill"}});
    EXPECT_EQ(outcome.code, 128 + SIGKILL) << "at call " << moment;
    expect_whole(folder, [](const std::string& name) {
      return is_journal(name) || std::filesystem::path(name).filename().string().starts_with('.');
    });
  }
}

TEST_P(StoppedCommand, InterruptedItLeavesNothingElse) {
  for (const std::size_t moment : moments()) {
    const StoppedFolder folder(GetParam());
    const Outcome outcome = folder.run(GetParam(), {{"STOP_AT", std::to_string(moment)}, {"STOP_HOW", "interrupt"}});
    EXPECT_EQ(outcome.code, 130) << "at call " << moment << ": " << outcome.err;
    EXPECT_THAT(outcome.err, testing::AllOf(StartsWith("jointid: stopping; "), HasSubstr("\njointid: error: interrupted")));
    expect_whole(folder, is_journal);
  }
}

TEST_P(StoppedCommand, InterruptedTwiceItLeavesNothingElse) {
  for (const std::size_t moment : moments()) {
    const StoppedFolder folder(GetParam());
    const Outcome outcome = folder.run(GetParam(), {{"STOP_AT", std::to_string(moment)}, {"STOP_HOW", "insist"}});
    EXPECT_EQ(outcome.code, 130) << "at call " << moment << ": " << outcome.err;
    expect_whole(folder, is_journal);
  }
}

TEST_P(StoppedCommand, OnAFullDiskItSaysSoAndLeavesNothingElse) {
  for (const std::size_t moment : moments()) {
    const StoppedFolder folder(GetParam());
    const Outcome outcome = folder.run(GetParam(), {{"STOP_AT", std::to_string(moment)}, {"STOP_HOW", "full"}});
    EXPECT_THAT(outcome.code, AnyOf(0, 3)) << "at call " << moment << ": " << outcome.err;  // 0: nothing was left to write
    if (outcome.code == 3) {
      EXPECT_THAT(outcome.err, StartsWith("jointid: error: "));
      EXPECT_THAT(outcome.err, AnyOf(HasSubstr("No space left on device"), HasSubstr("matio did not write all of it")));
      EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    }
    expect_whole(folder, is_journal);
  }
}

/// A disk of its own in a folder, of some kilobytes and full but for `free` bytes; it goes with the process's view of the disks.
class FullDisk {
 public:
  /// False when this user may not mount.
  static bool may_mount() {
    static const bool may = ::unshare(CLONE_NEWNS) == 0 || ::unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0;
    return may && ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
  }

  explicit FullDisk(const std::filesystem::path& folder) : folder_(folder) {
    if (::mount("none", folder.c_str(), "tmpfs", 0, "size=128k") != 0) throw std::runtime_error("cannot mount a tmpfs");
  }
  ~FullDisk() { ::umount(folder_.c_str()); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

  void fill() const {
    std::ofstream ballast(folder_ / "ballast", std::ios::binary);
    while (ballast.put('.').flush()) {
    }
  }

 private:
  std::filesystem::path folder_;
};

/// The same command with its outputs in the folder "small".
Writing into_small(Writing writing) {
  for (std::string& word : writing.command) {
    if (word.starts_with("x.") || word == "new") word = "small/" + word;
  }
  for (std::string& output : writing.outputs) output = "small/" + output;
  return writing;
}

TEST_P(StoppedCommand, OnASmallDiskThatIsFullNothingChanges) {
  if (!FullDisk::may_mount()) GTEST_SKIP() << "this user may not mount a tmpfs";  // a right of the user: no package brings it
  const Writing writing = into_small(GetParam());
  Writing without_old = writing;
  without_old.outputs.clear();
  const StoppedFolder folder(without_old);
  std::filesystem::create_directory(folder.path("small"));
  const FullDisk disk(folder.path("small"));
  for (const std::string& output : writing.outputs) {
    if (!output.starts_with("small/new")) folder.write(output, old_output);
  }
  disk.fill();
  auto before = folder.content();
  const Outcome outcome = folder.run(writing, {});
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  EXPECT_THAT(outcome.err, StartsWith("jointid: error: small/"));
  auto after = folder.content();
  for (auto* content : {&before, &after})
    std::erase_if(*content, [](const auto& file) { return is_journal(file.first) || file.first == "small/new"; });
  EXPECT_EQ(after, before);
}

void add_coupling(const InputFolder& folder) { problems::write(problems::make_coupling("coupling-A"), folder.path(), {}); }
void add_curve(const InputFolder& folder) { problems::write(*problems::find_loading_curve("table2.1-1"), folder.path(), {}); }

const Writing writings[] = {
    {"Solve", {"solve", "A1.toml", "--json", "x.json", "--csv", "x.csv", "--report", "x.html"}, {"x.json", "x.csv", "x.html"}},
    {"Plan", {"plan", "A1.toml", "--json", "x.json"}, {"x.json"}},
    {"PlanBound", {"plan", "A1.toml", "--bound", "--json", "x.json"}, {"x.json"}},
    {"Compare",
     {"compare", "A1.toml", "--trials", "3", "--json", "x.json", "--csv", "x.csv", "--report", "x.html"},
     {"x.json", "x.csv", "x.html"}},
    {"Study",
     {"study", "A1.toml", "--trials", "20", "--threads", "1", "--out", "x.h5", "--json", "x.json", "--csv", "x.csv", "--report",
      "x.html"},
     {"x.h5", "x.json", "x.csv", "x.html"}},
    {"Couple",
     {"couple", "coupling-A.toml", "--out", "x.h5", "--json", "x.json", "--csv", "x.csv"},
     {"x.h5", "x.json", "x.csv"},
     add_coupling},
    {"Modalfit",
     {"modalfit", "A1_substructure_1.h5", "--regenerate", "x.h5", "--shapes", "x.uff", "--json", "x.json", "--csv", "x.csv"},
     {"x.h5", "x.uff", "x.json", "x.csv"}},
    {"LoadingCurve",
     {"loading-curve", "table2.1-1.csv", "--json", "x.json", "--csv", "x.csv", "--report", "x.html"},
     {"x.json", "x.csv", "x.html"},
     add_curve},
    {"ConvertToHdf5", {"convert", "a.uff", "x.h5"}, {"x.h5"}},
    {"ConvertToUff", {"convert", "a.h5", "x.uff"}, {"x.uff"}},
    {"ConvertToCsv", {"convert", "a.h5", "x.csv"}, {"x.csv"}},
    {"ConvertToMat", {"convert", "a.h5", "x.mat"}, {"x.mat"}},
    {"ProblemWrite", {"problem", "write", "A1", "new"}, {"new/A1.toml"}},
};
INSTANTIATE_TEST_SUITE_P(Writing, StoppedCommand, testing::ValuesIn(writings), [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace jointid::cli
