// Below its result `convert` prints a line for each doubt about a file, as `info` does.
#include <gmock/gmock.h>

#include "input_folder.hpp"
#include "run_command.hpp"

namespace jointid::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string gain = "# gain = 2.5\n";

std::string table(const std::string& remarks, const std::string& dofs) {
  return "# quantity = receptance\n" + remarks + "frequency_hz," + dofs + " re," + dofs + " im\n10,1,-0.1\n20,2,-0.3\n30,3,-0.2\n";
}

std::size_t notes_in(const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find("note: "); at != std::string::npos; at = text.find("note: ", at + 1)) ++count;
  return count;
}

TEST(ConvertNotes, AreThoseOfInfo) {
  const InputFolder folder;
  folder.write("gain.csv", table(gain, "1:+Z/1:+Z"));
  const Outcome info = run_command(folder.path(), {"info", "gain.csv"});
  const Outcome converted = run_command(folder.path(), {"convert", "gain.csv", "gain.h5"});
  const std::string note = "  note: line 2 states 'gain = 2.5', which is not applied to the FRFs\n";
  EXPECT_EQ(converted.code, 0) << converted.err;
  EXPECT_THAT(converted.out, AllOf(StartsWith("wrote gain.h5: 3 lines, 1 × 1 FRFs\n"), HasSubstr(note)));
  EXPECT_THAT(info.out, HasSubstr(note));
  EXPECT_EQ(notes_in(converted.out), 1U);
}

TEST(ConvertNotes, NoneWhereNothingIsDoubtful) {
  const InputFolder folder;
  folder.write("plain.csv", table("", "1:+Z/1:+Z"));
  EXPECT_EQ(run_command(folder.path(), {"convert", "plain.csv", "plain.h5"}).out, "wrote plain.h5: 3 lines, 1 × 1 FRFs\n");
}

TEST(ConvertNotes, OfEveryFileThatIsJoined) {
  const InputFolder folder;
  folder.write("first.csv", table("", "1:+Z/1:+Z"));
  folder.write("second.csv", table(gain, "2:+Z/1:+Z"));
  const Outcome converted = run_command(folder.path(), {"convert", "first.csv", "second.csv", "both.h5"});
  EXPECT_EQ(converted.code, 0) << converted.err;
  EXPECT_THAT(converted.out, AllOf(HasSubstr("2 × 1 FRFs"), HasSubstr("gain = 2.5"), HasSubstr("second.csv")));
  EXPECT_EQ(notes_in(converted.out), 1U);
}

/// Conjugates of FRFs, into files that are written line by line and at once: the line of `info`.
TEST(ConvertNotes, OfDrivingPointsThatAreNotPassive) {
  const InputFolder folder;
  folder.write("turned.csv", "# quantity = receptance\nfrequency_hz,1:+Z/1:+Z re,1:+Z/1:+Z im\n10,1,0.1\n20,2,0.3\n30,3,0.2\n");
  const std::string note = "note: The driving point 1:+Z is not passive";
  EXPECT_THAT(run_command(folder.path(), {"info", "turned.csv"}).out, HasSubstr(note));
  for (const char* out : {"turned.h5", "turned.uff", "again.csv"}) {
    const Outcome converted = run_command(folder.path(), {"convert", "turned.csv", out});
    EXPECT_EQ(converted.code, 0) << converted.err;
    EXPECT_THAT(converted.out, HasSubstr("  " + note)) << out;
    EXPECT_EQ(notes_in(converted.out), 1U) << out;
  }
}

/// A control byte of a file must not reach the terminal, whether the file is read or refused.
TEST(ConvertNotes, ArePrintable) {
  const InputFolder folder;
  folder.write("odd.csv", table("# ga\x1B[31min gain = 2.5\n", "1:+Z/1:+Z"));
  const Outcome converted = run_command(folder.path(), {"convert", "odd.csv", "odd.h5"});
  EXPECT_THAT(converted.out + converted.err, Not(HasSubstr("\x1B")));
}

/// What UFF has no place for, and what a table leaves out.
TEST(ConvertNotes, OfUniversalFiles) {
  const InputFolder folder;
  folder.replace("a.uff", "Displacement         m ", "Displacement         mm");
  const Outcome info = run_command(folder.path(), {"info", "a.uff"}), converted = run_command(folder.path(), {"convert", "a.uff", "x.csv"});
  EXPECT_EQ(converted.code, 0) << converted.err;
  EXPECT_EQ(notes_in(converted.out), notes_in(info.out));
}

}  // namespace
}  // namespace jointid::cli
