#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "frf/hdf5/hdf5_writer.hpp"
#include "input_folder.hpp"
#include "problems/problem.hpp"
#include "run_command.hpp"
#include "terminal.hpp"

namespace jointid::cli {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

const std::string said = "jointid: stopping; keeping the partial result; Ctrl-C again stops at once\n";

/// Writes random FRFs of `count` coordinates among themselves, `lines` lines, piece by piece.
void write_large(const std::filesystem::path& path, std::size_t count, std::size_t lines) {
  frf::FrfHeader header;
  for (std::size_t i = 1; i <= count; ++i) {
    header.response.push_back({.node = static_cast<std::int64_t>(i), .direction = frf::Direction::y});
  }
  header.reference = header.response;
  for (std::size_t i = 1; i <= lines; ++i) header.frequency_hz.push_back(static_cast<double>(i));
  frf::Hdf5Writer writer(path, header);
  std::vector<Complex> values(header.entries());
  for (std::size_t line = 0; line < lines; ++line) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1.0 / static_cast<double>(1 + (i * 7919 + line) % 1009);
    for (std::size_t i = 0; i < count; ++i) values[i * count + i] += 4.0;
    writer.write_lines(line, 1, values);
  }
  writer.finish();
}

/// Two systems of 120 coordinates in one file under two names: Method Two inverts one 120×120 matrix for each line.
void write_long_scene(const InputFolder& folder) {
  write_large(folder.path("parts.h5"), 120, 600);
  std::filesystem::create_hard_link(folder.path("parts.h5"), folder.path("whole.h5"));
  folder.write("long.toml",
               "[data]\nsubstructures = ['parts.h5']\nassembly = ['whole.h5']\n"
               "[joint]\ndofs = ['1:+Y', '2:+Y']\nstiffness.pattern = 'symmetric'\n[identify]\nmethod = 'two'\n");
}

std::vector<std::string> names_in(const InputFolder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(InterruptedCommand, ASolveEndsBetweenChunksAndWritesNothing) {
  const InputFolder folder;
  write_long_scene(folder);
  const auto before = names_in(folder);
  const Terminal terminal;
  Command command(folder.path(), {"solve", "long.toml", "--json", "old.json", "--csv", "new.csv"},
                  {.out = -1, .err = terminal.descriptor()});
  terminal.until("assembling: line ");
  command.interrupt();
  terminal.until("jointid: error: interrupted");
  const Outcome outcome = command.wait();
  EXPECT_EQ(outcome.code, 130);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(folder.text("old.json"), old_output);
  EXPECT_EQ(names_in(folder), before);
}

/// Interrupts a conversion as soon as its temporary file is there; false when it was done before.
bool catch_in_the_act(const InputFolder& folder, const std::vector<std::string>& before) {
  Command command(folder.path(), {"convert", "parts.h5", "new.h5"});
  while (names_in(folder) == before && !command.has_ended()) std::this_thread::yield();
  command.interrupt();
  const Outcome outcome = command.wait();
  if (outcome.code == 0) {
    std::filesystem::remove(folder.path("new.h5"));
    return false;
  }
  EXPECT_EQ(outcome.code, 130);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, said + "jointid: error: interrupted\n");
  return true;
}

TEST(InterruptedCommand, AConversionLeavesNoTemporaryFile) {
  const InputFolder folder;
  write_large(folder.path("parts.h5"), 120, 600);
  const auto before = names_in(folder);
  bool caught = false;
  for (int attempt = 0; attempt < 20 && !caught; ++attempt) caught = catch_in_the_act(folder, before);
  EXPECT_TRUE(caught);
  EXPECT_EQ(names_in(folder), before);
}

/// A command that waits for a file of its scene that another process holds a lease of (longer than the test takes), where nothing asks
/// whether it shall end.
class Hanging {
 public:
  Hanging() {
    std::signal(SIGIO, SIG_IGN);  // that somebody wants the file
    held_ = ::open(folder_.path("A1_assembly.h5").c_str(), O_RDWR | O_CLOEXEC);
    EXPECT_EQ(::fcntl(held_, F_SETLEASE, F_WRLCK), 0);
    command_.emplace(folder_.path(), std::vector<std::string>{"solve", "A1.toml"});
    command_->wait_until_it_catches();
  }
  ~Hanging() {
    command_.reset();
    ::close(held_);
  }
  Hanging(const Hanging&) = delete;
  Hanging& operator=(const Hanging&) = delete;
  Command& operator*() { return *command_; }
  Command* operator->() { return &*command_; }

 private:
  InputFolder folder_;
  int held_ = -1;
  std::optional<Command> command_;
};

TEST(InterruptedCommand, EndsByItselfWhereNothingAsks) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Hanging command;
    command->interrupt(signal);
    const Outcome outcome = command->wait();
    EXPECT_EQ(outcome.code, 130);
    EXPECT_EQ(outcome.err, said + "jointid: error: interrupted\n");
  }
}

/// A pipe that is full and that nobody reads.
class FullPipe {
 public:
  FullPipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC | O_NONBLOCK) != 0) throw std::runtime_error("no pipe");
    const std::array<char, 4096> piece{};
    while (::write(ends_[1], piece.data(), piece.size()) > 0) {
    }
    ::fcntl(ends_[1], F_SETFL, 0);
  }
  ~FullPipe() {
    for (const int end : ends_) ::close(end);
  }
  FullPipe(const FullPipe&) = delete;
  FullPipe& operator=(const FullPipe&) = delete;
  int descriptor() const { return ends_[1]; }

 private:
  std::array<int, 2> ends_{};
};

TEST(InterruptedCommand, EndsAlthoughNobodyReadsWhatItPrints) {
  const InputFolder folder;
  const FullPipe pipe;
  for (const bool both : {false, true}) {
    Command command(folder.path(), {"info", "A1_assembly.h5"}, {.out = pipe.descriptor(), .err = both ? pipe.descriptor() : -1});
    command.wait_until_it_catches();
    ::usleep(300'000);  // now it waits for the pipe
    ASSERT_FALSE(command.has_ended());
    command.interrupt();
    for (int tenths = 0; tenths < 50 && !command.has_ended(); ++tenths) ::usleep(100'000);
    ASSERT_TRUE(command.has_ended()) << both;
    const Outcome outcome = command.wait();
    EXPECT_EQ(outcome.code, 130);
    EXPECT_EQ(outcome.err, both ? "" : said + "jointid: error: interrupted\n");
  }
}

TEST(InterruptedCommand, EndsAtOnceWhenItIsAskedTwice) {
  Hanging command;
  command->interrupt(SIGTERM);
  ::usleep(200000);  // two signals at a time are one
  command->interrupt();
  const Outcome outcome = command->wait();
  EXPECT_EQ(outcome.code, 130);
  EXPECT_EQ(outcome.err, said);
}

TEST(InterruptedCommand, TheLikelihoodLeavesItsBestJointMarked) {
  const InputFolder folder;
  problems::write(problems::make("rig1"), folder.path(), {});
  folder.replace("rig1.toml", "method = \"one\"", "method = \"likelihood\"\nbootstrap = 100000");
  const Terminal terminal;
  Command command(folder.path(), {"solve", "rig1.toml", "--json", "x.json", "--csv", "x.csv", "--report", "x.html"},
                  {.out = -1, .err = terminal.descriptor()});
  terminal.until("iteration 4: line ");
  command.interrupt();
  const std::string shown = terminal.until("jointid: error: interrupted; the best values so far are written, the page is not");
  const Outcome outcome = command.wait();
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(shown, HasSubstr("jointid: stopping; "));
  EXPECT_THAT(outcome.out, HasSubstr("Interrupted after "));
  EXPECT_FALSE(std::filesystem::exists(folder.path("x.html")));
  const Json solution = Json::parse(folder.text("x.json"));
  EXPECT_EQ(solution["status"], "not_converged");
  EXPECT_THAT(solution["message"].get<std::string>(), HasSubstr("Interrupted after "));
  ASSERT_FALSE(solution["unknowns"].empty());
  for (const Json& unknown : solution["unknowns"]) EXPECT_TRUE(unknown["value"].is_number());
  EXPECT_GT(folder.text("x.csv").size(), 10U);
}

TEST(InterruptedCommand, ABoundKeepsWhatWasPredicted) {
  const InputFolder folder;
  problems::write(problems::make("rig1"), folder.path(), {});
  const Terminal terminal;
  Command command(folder.path(), {"plan", "rig1.toml", "--bound", "--json", "x.json"}, {.out = -1, .err = terminal.descriptor()});
  terminal.until("predicting errors, data set 2 of ");
  command.interrupt();
  terminal.until("jointid: error: interrupted; what was predicted so far is written");
  const Outcome outcome = command.wait();
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.out, HasSubstr("INTERRUPTED"));
  const Json plan = Json::parse(folder.text("x.json"));
  EXPECT_EQ(plan["bound"]["interrupted"], true);
  EXPECT_FALSE(plan["bound"]["unknowns"].empty());
}

TEST(InterruptedCommand, AComparisonKeepsTheWaysThatWereFinished) {
  const InputFolder folder;
  const Terminal terminal;
  const std::string deltas = "0,0.01,0.02,0.03,0.04,0.05,0.06,0.07,0.08,0.09,0.1,0.11,0.12,0.13";
  Command command(folder.path(), {"compare", "A1.toml", "--trials", "200", "--deltas", deltas, "--json", "x.json"},
                  {.out = -1, .err = terminal.descriptor()});
  terminal.until("trial 450 of 2800");
  command.interrupt();
  terminal.until("ways that were finished are written");
  EXPECT_EQ(command.wait().code, 130);
  const Json comparison = Json::parse(folder.text("x.json"));
  EXPECT_EQ(comparison["interrupted"], true);
  EXPECT_GE(comparison["combinations"].size(), 2U);
  EXPECT_LT(comparison["combinations"].size(), 14U);
}

TEST(InterruptedCommand, StabilityKeepsWhatWasMeasured) {
  const InputFolder folder;
  const Terminal terminal;
  Command command(folder.path(), {"stability", "--sweeps", "laeuchli", "--scenes", "1e6", "--json", "x.json"},
                  {.out = -1, .err = terminal.descriptor()});
  terminal.until("scene 3 of 1000000");
  command.interrupt();
  terminal.until("jointid: error: interrupted; what was measured so far is written");
  EXPECT_EQ(command.wait().code, 130);
  const Json measured = Json::parse(folder.text("x.json"));
  EXPECT_EQ(measured["interrupted"], true);
  EXPECT_FALSE(measured["rows"].empty());
  EXPECT_GE(measured["random_scenes"]["scenes"].get<int>(), 2);
}

}  // namespace
}  // namespace jointid::cli
