// No command replaces what it reads: every command that writes, every option that names an output, every input, by its name and
// through links.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <functional>

#include "input_folder.hpp"
#include "problems/case/coupling_problem.hpp"
#include "problems/problem.hpp"
#include "problems/thesis/loading_curves.hpp"
#include "problems/thesis/oscillations.hpp"
#include "problems/thesis/two_beams.hpp"
#include "problems/vibration/rig_two.hpp"
#include "run_command.hpp"

namespace jointid::cli {
namespace {

using testing::HasSubstr;

/// A file and what the message says of it.
struct Read {
  std::string file, place;
};

/// A command that reads files and writes where its options say.
struct Reader {
  std::string name;
  std::vector<std::string> command;
  std::vector<std::string> options;  ///< those that name an output; "" for the last argument
  std::vector<Read> inputs;
  Spoil prepare = {};
};

void PrintTo(const Reader& reader, std::ostream* out) { *out << reader.name; }

/// Names under which an input can be named, made in the folder.
std::vector<std::string> names_of(const std::string& input, const InputFolder& folder) {
  namespace fs = std::filesystem;
  fs::create_symlink(input, folder.path("link"));
  fs::create_symlink("link", folder.path("link to a link"));
  fs::create_symlink(".", folder.path("same folder"));
  fs::create_hard_link(folder.path(input), folder.path("hard link"));
  return {input, "./" + input, folder.path(input).string(), "link", "link to a link", "same folder/" + input, "hard link"};
}

void remove_names(const InputFolder& folder) {
  for (const char* name : {"link", "link to a link", "same folder", "hard link"}) std::filesystem::remove(folder.path(name));
}

class KeptInputs : public testing::TestWithParam<Reader> {};

TEST_P(KeptInputs, NoOutputReplacesAnInput) {
  const Reader& reader = GetParam();
  const InputFolder folder;
  if (reader.prepare) reader.prepare(folder);
  const auto before = folder.content();
  for (const auto& [input, place] : reader.inputs) {
    for (const std::string& name : names_of(input, folder)) {
      for (const std::string& option : reader.options) {
        std::vector<std::string> words = reader.command;
        if (!option.empty()) words.push_back(option);
        words.push_back(name);
        const Outcome outcome = run_command(folder.path(), words);
        EXPECT_EQ(outcome.code, 2) << option << " " << name << ": " << outcome.err;
        EXPECT_EQ(outcome.out, "");
        const std::string both = (option.empty() ? "OUT" : option) + " " + name + ": would replace the input " + input + " (" + place + ")";
        EXPECT_THAT(outcome.err, HasSubstr(both));
      }
    }
    remove_names(folder);
  }
  EXPECT_TRUE(folder.content() == before) << "a file was made, changed or removed";
}

const std::vector<Read> a1 = {{"A1.toml", "the scene"},
                              {"A1_substructure_1.h5", "[data] substructures"},
                              {"A1_substructure_2.h5", "[data] substructures"},
                              {"A1_assembly.h5", "[data] assembly"}};

/// A1 with two runs of the assembly.
void repeat_assembly(const InputFolder& folder) {
  std::filesystem::copy(folder.path("A1_assembly.h5"), folder.path("second.h5"));
  folder.replace("A1.toml", "\"A1_assembly.h5\"", "[\"A1_assembly.h5\", \"second.h5\"]");
}

void add_parts(const InputFolder& folder) { problems::write(problems::make_coupling("coupling-A"), folder.path(), {}); }
void add_levels(const InputFolder& folder) { problems::write(problems::make_rig_two("rig2"), folder.path(), {}); }
void add_curves(const InputFolder& folder) {
  problems::write(*problems::find_loading_curve("table2.1-1"), folder.path(), {});
  problems::write(*problems::find_loading_curve("table2.1-2"), folder.path(), {});
}

void add_response(const InputFolder& folder) {
  problems::write(*problems::find_two_beams("beams-B"), folder.path());
  folder.write("push.csv", "time,F\n0,0\n0.01,9\n0.02,1\n");
  folder.replace("beams-B.toml", "[response]",
                 "[transient]\nduration = 0.02\nforces = [{ dof = 5, file = \"push.csv\", column = \"F\" }]\n\n[response]");
}

/// The chain of three masses, reduced on the modes of a record.
void add_chain(const InputFolder& folder) {
  const std::filesystem::path scene = problems::write(*problems::find_oscillation("chain-3"), folder.path());
  folder.write("record.csv", "q1,q2,q3\n1,2,3\n2,1,1\n0,0,1\n1,0,0\n");
  folder.write("chain-3.toml", folder.text("chain-3.toml") + "\n[reduction]\nbases = [\"pod\"]\norders = [2]\nrecord = \"record.csv\"\n");
}

void add_blows(const InputFolder& folder) {
  for (const char* name : {"blow.csv", "second.csv"}) folder.write(name, "time,F,a\n0,0,0\n0.1,9,1\n0.2,0,3\n0.3,0,-2\n");
}

const std::vector<std::string> three = {"--json", "--csv", "--report"};
const std::vector<std::string> with_out = {"--out", "--json", "--csv", "--report"};

const Reader readers[] = {
    {"Solve", {"solve", "A1.toml"}, three, a1},
    {"SolveRepeats",
     {"solve", "A1.toml"},
     three,
     {{"A1_assembly.h5", "[data] assembly"}, {"second.h5", "[data] assembly"}},
     repeat_assembly},
    {"Plan", {"plan", "A1.toml"}, {"--json"}, a1},
    {"PlanBound", {"plan", "A1.toml", "--bound"}, {"--json"}, a1},
    {"Study", {"study", "A1.toml", "--trials", "5"}, with_out, a1},
    {"StudyResumed", {"study", "A1.toml", "--trials", "5", "--resume"}, {"--out"}, a1},
    {"Compare", {"compare", "A1.toml", "--trials", "2"}, three, a1},
    {"Couple",
     {"couple", "coupling-A.toml"},
     with_out,
     {{"coupling-A.toml", "the scene"}, {"coupling-A_part_1.h5", "[data] parts"}, {"coupling-A_part_2.h5", "[data] parts"}},
     add_parts},
    {"CoupleBounds", {"couple", "coupling-A.toml", "--bounds"}, {"--out"}, {{"coupling-A_part_1.h5", "[data] parts"}}, add_parts},
    {"Equivalent",
     {"equivalent", "rig2.toml"},
     {"--json", "--csv"},
     {{"rig2.toml", "the scene"}, {"rig2_parts.h5", "[data] parts"}, {"rig2_level_1.h5", "[equivalent] levels"}},
     add_levels},
    {"Modalfit",
     {"modalfit", "a.h5", "b.uff"},
     {"--regenerate", "--shapes", "--json", "--csv", "--report"},
     {{"a.h5", "FILES"}, {"b.uff", "FILES"}}},
    {"Response",
     {"response", "beams-B.toml"},
     {"--json", "--csv", "--history", "--report", "--out"},
     {{"beams-B.toml", "the scene"},
      {"beams-B_mass.mtx", "[structure] mass"},
      {"beams-B_stiffness.mtx", "[structure] stiffness"},
      {"push.csv", "[transient] forces"}},
     add_response},
    {"Frf",
     {"frf", "blow.csv", "second.csv", "--channel", "2=1:+Z N", "--channel", "3=2:+Z m/s^2"},
     {"--output", "--json", "--csv", "--report"},
     {{"blow.csv", "FILES"}, {"second.csv", "FILES"}},
     add_blows},
    {"LoadingCurve", {"loading-curve", "table2.1-1.csv"}, three, {{"table2.1-1.csv", "FILES"}}, add_curves},
    {"LoadingCurveSpecimen",
     {"loading-curve", "table2.1-1.csv", "--specimen", "table2.1-2.csv"},
     three,
     {{"table2.1-1.csv", "FILES"}, {"table2.1-2.csv", "--specimen"}},
     add_curves},
    {"Pod",
     {"pod", "table2.1-1.csv", "--mass", "table2.1-2.csv"},
     three,
     {{"table2.1-1.csv", "FILES"}, {"table2.1-2.csv", "--mass"}},
     add_curves},
    {"PodStiffness",
     {"pod", "table2.1-1.csv", "--mass", "a.csv", "--stiffness", "table2.1-2.csv"},
     {"--json"},
     {{"table2.1-2.csv", "--stiffness"}},
     add_curves},
    {"PodCompare", {"pod", "table2.1-1.csv", "--compare", "table2.1-2.csv"}, {"--json"}, {{"table2.1-2.csv", "--compare"}}, add_curves},
    {"Oscillate",
     {"oscillate", "chain-3.toml"},
     {"--json", "--csv", "--report", "--sweep", "--events"},
     {{"chain-3.toml", "the scene"}, {"record.csv", "line 39, [reduction] record"}},
     add_chain},
    {"SeriesDelay", {"series", "delay", "table2.1-1.csv", "--channel", "1"}, three, {{"table2.1-1.csv", "FILE"}}, add_curves},
    {"SeriesStrain",
     {"series", "strain", "table2.1-1.csv", "--length", "1", "--thickness", "0.01", "--gauges", "0.1,0.2"},
     {"--output", "--json"},
     {{"table2.1-1.csv", "FILE"}},
     add_curves},
    {"SeriesFriction",
     {"series", "friction", "table2.1-1.csv", "--velocity", "1", "--force", "2", "--load", "1", "--stick-speed", "1"},
     three,
     {{"table2.1-1.csv", "FILE"}},
     add_curves},
    {"SeriesReversal",
     {"series", "reversal", "table2.1-1.csv", "--displacement", "1", "--force", "2"},
     {"--json", "--report"},
     {{"table2.1-1.csv", "FILE"}},
     add_curves},
    {"SeriesAlign",
     {"series", "align", "table2.1-1.csv", "--reference", "1", "--frequency", "1", "--rate", "10"},
     {"--output", "--json"},
     {{"table2.1-1.csv", "FILE"}},
     add_curves},
    {"Correlate", {"correlate", "a.h5", "b.uff"}, {"--json", "--csv"}, {{"a.h5", "ONE"}, {"b.uff", "OTHER"}}},
    {"Expand", {"expand", "a.h5", "b.uff"}, {"--out", "--json"}, {{"a.h5", "PARENT"}, {"b.uff", "MEASURED"}}},
    {"Convert", {"convert", "a.h5"}, {""}, {{"a.h5", "IN"}}},
    {"ConvertText", {"convert", "a.uff"}, {""}, {{"a.uff", "IN"}}},
};
INSTANTIATE_TEST_SUITE_P(Reading, KeptInputs, testing::ValuesIn(readers), [](const auto& row) { return row.param.name; });

/// A command line, exit code 2 and no change.
void expect_refused(const std::vector<std::string>& command, const Spoil& prepare, const std::string& says) {
  const InputFolder folder;
  if (prepare) prepare(folder);
  const auto before = folder.content();
  const Outcome outcome = run_command(folder.path(), command);
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(says));
  EXPECT_TRUE(folder.content() == before) << "a file was made, changed or removed";
}

TEST(KeptOutputs, TwoResultsDoNotGoToOneFile) {
  const auto linked = [](const InputFolder& folder) { std::filesystem::create_symlink("new", folder.path("link")); };
  const auto hard = [](const InputFolder& folder) { std::filesystem::create_hard_link(folder.path("old.json"), folder.path("other")); };
  const auto folder_link = [](const InputFolder& folder) { std::filesystem::create_directory_symlink(".", folder.path("here")); };
  expect_refused({"solve", "A1.toml", "--json", "new", "--csv", "link"}, linked, "--json new --csv link: both want the same file");
  expect_refused({"solve", "A1.toml", "--json", "old.json", "--report", "other"}, hard,
                 "--json old.json --report other: both want the same file");
  expect_refused({"solve", "A1.toml", "--json", "new", "--csv", "here/new"}, folder_link,
                 "--json new --csv here/new: both want the same file");
  expect_refused({"stability", "--json", "new", "--csv", "./new"}, {}, "--json new --csv ./new: both want the same file");
  expect_refused({"modalfit", "a.h5", "--regenerate", "new.h5", "--json", "new.h5"}, {},
                 "--json new.h5 --regenerate new.h5: both want the same file");
  expect_refused({"compare", "--reproduce", "6.3", "--json", "new", "--csv", "new"}, {}, "both want the same file");
}

TEST(KeptOutputs, WhatIsWrittenBesideAResultCountsToo) {
  expect_refused({"study", "A1.toml", "--trials", "5", "--out", "x.h5", "--json", "x.h5.partial"}, {},
                 "x.h5.partial: both want the same file");
  expect_refused({"couple", "coupling-A.toml", "--bounds", "--out", "x.h5", "--json", "x.all.h5"}, add_parts,
                 "x.all.h5: both want the same file");
  const auto renamed = [](const InputFolder& folder) {
    add_parts(folder);
    std::filesystem::rename(folder.path("coupling-A_part_1.h5"), folder.path("x.all.h5"));
    folder.replace("coupling-A.toml", "coupling-A_part_1.h5", "x.all.h5");
  };
  expect_refused({"couple", "coupling-A.toml", "--bounds", "--out", "x.h5"}, renamed,
                 "--bounds x.all.h5: would replace the input x.all.h5 ([data] parts)");
}

TEST(KeptOutputs, StandardOutputIsNotAppendedToAnInput) {
  const InputFolder folder;
  const auto before = folder.content();
  const int output = ::open(folder.path("A1_assembly.h5").c_str(), O_WRONLY | O_APPEND);
  const Outcome outcome = Command(folder.path(), {"solve", "A1.toml"}, {.out = output, .err = -1}).wait();
  ::close(output);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("standard output: would be written into the input A1_assembly.h5 ([data] assembly)"));
  EXPECT_TRUE(folder.content() == before);
}

TEST(KeptOutputs, AProblemIsWrittenOverItsOwnFilesOnly) {
  expect_refused({"problem", "write", "A2", "."}, {}, "truth.json: would perhaps be replaced, and is not of problem A2");
  const auto without_truth = [](const InputFolder& folder) { std::filesystem::remove(folder.path("truth.json")); };
  expect_refused({"problem", "write", "A1", "."}, without_truth, "A1");
  const InputFolder folder;
  const Outcome outcome = run_command(folder.path(), {"problem", "write", "A1", ".", "--seed", "7"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

}  // namespace
}  // namespace jointid::cli
