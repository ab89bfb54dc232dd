// Files that are there already: ours are replaced, others only with --force. And forms of outputs: units, quantities, PDF.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "input_folder.hpp"
#include "run_command.hpp"
#include "tests/require.hpp"

namespace jointid::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

struct Target {
  std::vector<std::string> command;  ///< its last word is the target
  std::string foreign;               ///< what somebody else has there
};

std::vector<Target> targets() {
  return {{{"solve", "A1.toml", "--json", "x.json"}, "{\"name\": \"a package\"}\n"},
          {{"solve", "A1.toml", "--csv", "x.csv"}, "time,force\n0,1\n"},
          {{"solve", "A1.toml", "--report", "x.html"}, "<html><body>My thesis</body></html>\n"},
          {{"plan", "A1.toml", "--json", "x.json"}, "notes\n"},
          {{"check", "A1.toml", "--json", "x.json"}, "#!/bin/sh\nrm -rf\n"},
          {{"study", "A1.toml", "--trials", "3", "--json", "x.json"}, "[1, 2, 3]\n"},
          {{"study", "A1.toml", "--trials", "3", "--csv", "x.csv"}, "x;y\n1;2\n"},
          {{"study", "A1.toml", "--trials", "3", "--report", "x.html"}, "%PDF-1.4 of somebody\n"},
          {{"convert", "A1_assembly.h5", "x.uff"}, "    -1\n   151\nmodel\nNONE\nan analyser\n"},
          {{"convert", "A1_assembly.h5", "x.mat"}, "MATLAB 5.0 MAT-file, Platform: PCWIN64\n"},
          {{"convert", "A1_assembly.h5", "x.csv"}, "frequency;re;im\n"},
          {{"convert", "A1_assembly.h5", "x.csv"}, "# quantity = accelerance\nfrequency_hz,1:+Z/1:+Z re,1:+Z/1:+Z im\n1,2,3\n"},
          {{"solve", "A1.toml", "--csv", "x.csv"}, "frequency_hz,1:+Z/1:+Z re\n1,2\n"},
          {{"solve", "A1.toml", "--csv", "x.csv"}, "time [s],force [N]\n0,1\n"},
          {{"study", "A1.toml", "--trials", "3", "--csv", "x.csv"}, "file,status,remark\na,b,c\n"},
          {{"convert", "A1_assembly.h5", "x.h5"}, "\x89HDF\r\n\x1a\n"}};
}

TEST(OwnOutput, FilesOfOthersAreKept) {
  for (const auto& [command, foreign] : targets()) {
    const InputFolder folder;
    const std::string target = command.back();
    folder.write(target, foreign);
    const Outcome refused = run_command(folder.path(), command);
    EXPECT_EQ(refused.code, 2) << command[0] << " " << target << refused.err;
    EXPECT_THAT(refused.err,
                HasSubstr(target + ": is there already and does not look like a file of jointid; give another name, or --force"));
    EXPECT_EQ(folder.text(target), foreign);
  }
}

TEST(OwnOutput, IsReplaced) {
  for (const auto& [command, foreign] : targets()) {
    const InputFolder folder;
    folder.write(command.back(), foreign);
    std::vector<std::string> forced = command;
    forced.emplace_back("--force");
    EXPECT_EQ(run_command(folder.path(), forced).code, 0) << command[0] << " " << command.back();
    EXPECT_FALSE(folder.text(command.back()) == foreign) << command.back();
    const Outcome again = run_command(folder.path(), command);
    EXPECT_EQ(again.code, 0) << command[0] << " " << command.back() << again.err;
  }
}

TEST(OwnOutput, ANameOfAnotherKindIsRefused) {
  const InputFolder folder;
  for (const auto& [option, name] : {std::pair{"--report", "r.docx"},
                                     {"--report", "r.csv"},
                                     {"--report", "r.PNG"},
                                     {"--json", "r.csv"},
                                     {"--csv", "r.html"},
                                     {"--csv", "r.xlsx"}}) {
    const Outcome refused = run_command(folder.path(), {"solve", "A1.toml", option, name});
    EXPECT_EQ(refused.code, 2) << name;
    EXPECT_THAT(refused.err, HasSubstr(std::string(option) + " " + name + ": would not be a file of the kind that ."));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / name));
  }
  for (const auto& [option, name] : {std::pair{"--report", "r.htm"}, {"--report", "r"}, {"--csv", "r.txt"}, {"--json", "r.2024"}})
    EXPECT_EQ(run_command(folder.path(), {"solve", "A1.toml", option, name}).code, 0) << name;
}

std::string solved(const InputFolder& folder, std::vector<std::string> options) {
  std::vector<std::string> arguments = {"solve", "A1.toml"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = run_command(folder.path(), arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.out;
}

/// The fields of the line of a table that begins with `name`.
std::vector<std::string> fields(const std::string& csv, const std::string& name) {
  std::vector<std::string> out;
  const std::size_t begin = csv.find(name);
  std::string line = begin == std::string::npos ? "" : csv.substr(begin + name.size(), csv.find('\n', begin) - begin - name.size());
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) out.push_back(field);
  return out;
}

TEST(Units, OfTextTableAndPageJsonStaysSi) {
  const InputFolder folder;
  const std::string si = solved(folder, {"--csv", "-"}), mm = solved(folder, {"--csv", "-", "--units", "mm"});
  struct Pair {
    std::string name, unit;
    double factor;
  };
  for (const auto& [name, unit, factor] :
       {Pair{"\"K(1,1)\",", "N/mm", 1e-3}, Pair{"\"K(1,2)\",", "N/rad", 1.0}, Pair{"\"K(2,2)\",", "N*mm/rad", 1e3}}) {
    const auto is = fields(mm, name), was = fields(si, name);
    ASSERT_GE(is.size(), 2U) << mm;
    ASSERT_GE(was.size(), 2U) << si;
    EXPECT_NEAR(std::stod(is[0]), factor * std::stod(was[0]), 1e-12 * std::abs(std::stod(is[0])));
    EXPECT_EQ(is[1], unit);
  }
  EXPECT_THAT(solved(folder, {"--units", "mm"}), HasSubstr("stiffness K (N, mm, s)"));
  const auto values = [&](std::vector<std::string> options) {
    return nlohmann::json::parse(solved(folder, std::move(options)))["unknowns"];
  };
  EXPECT_EQ(values({"--json", "-", "--units", "mm"}), values({"--json", "-"}));
  const std::string page = solved(folder, {"--report", "-", "--units", "mm", "--quantity", "accelerance"});
  EXPECT_THAT(page, HasSubstr("accelerance (mm/s²/N)"));
  EXPECT_THAT(page, Not(HasSubstr("receptance (")));
  EXPECT_THAT(solved(folder, {"--plot", "1:+Y/1:+Y", "--quantity", "measured"}), HasSubstr("dB re 1 m/N"));
  EXPECT_THAT(run_command(folder.path(), {"solve", "A1.toml", "--units", "cm"}).err, HasSubstr("--units: 'cm' is no system of units"));
  EXPECT_THAT(run_command(folder.path(), {"solve", "A1.toml", "--quantity", "mobilty"}).err, HasSubstr("did you mean 'mobility'?"));
}

TEST(Units, OfAStudyJsonStaysSi) {
  const InputFolder folder;
  const auto study = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"study", "A1.toml", "--trials", "20", "--threads", "1", "--resume", "--out", "trials.h5"});
    const Outcome outcome = run_command(folder.path(), options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  };
  const std::string si = study({"--csv", "-"}), mm = study({"--csv", "-", "--units", "mm"});
  const auto is = fields(mm, "\"K(1,1)\","), was = fields(si, "\"K(1,1)\",");
  ASSERT_EQ(is.size(), was.size()) << mm;
  ASSERT_GE(is.size(), 2U) << mm;
  EXPECT_EQ(is[0], "N/mm");
  for (std::size_t i = 1; i < is.size(); ++i) {
    if (is[i].empty() || i + 1 == is.size()) continue;  // the last is a share
    EXPECT_NEAR(std::stod(is[i]), 1e-3 * std::stod(was[i]), 1e-12 * std::abs(std::stod(is[i]))) << i;
  }
  EXPECT_THAT(study({"--units", "mm"}), HasSubstr("N*mm/rad"));
  EXPECT_THAT(study({"--report", "-", "--units", "mm"}), testing::AllOf(HasSubstr("N*mm/rad"), Not(HasSubstr("N*m/rad"))));
  const auto unknowns = [](const std::string& json) { return nlohmann::json::parse(json)["unknowns"]; };
  EXPECT_EQ(unknowns(study({"--json", "-", "--units", "mm"})), unknowns(study({"--json", "-"})));
  for (const char* command : {"study", "equivalent", "couple"})
    EXPECT_EQ(run_command(folder.path(), {command, "A1.toml", "--units", "cm"}).code, 2) << command;
}

/// The first screen.
TEST(Page, BeginsWithVerdictValuesAndWorstFrf) {
  const InputFolder folder;
  const std::string page = solved(folder, {"--report", "-"});
  std::size_t at = 0;
  for (const char* part :
       {"class=\"verdict", "<h2>Identified values</h2>", "<h2>Worst FRF, measured and synthesised</h2>", "<h2>Summary</h2>"}) {
    const std::size_t next = page.find(part, at);
    ASSERT_NE(next, std::string::npos) << part;
    at = next;
  }
}

TEST(Pdf, NeedsABrowserAndSaysSo) {
  const InputFolder folder;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const Outcome outcome = run_command(folder.path(), {"solve", "A1.toml", "--report", "r.pdf"});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--report r.pdf: a PDF is printed by Chromium, which is not on the PATH; write it as .html"));
}

TEST(Pdf, IsOne) {
  if (std::system("command -v chromium chromium-browser google-chrome >/dev/null") != 0) {
    JOINTID_SKIP("no Chromium (Debian package chromium)");
  }
  const InputFolder folder;
  solved(folder, {"--report", "r.pdf"});
  const std::string pdf = folder.text("r.pdf");
  EXPECT_THAT(pdf, StartsWith("%PDF-"));
  EXPECT_GT(pdf.size(), 20'000U);
  EXPECT_TRUE(pdf.ends_with("% jointid report\n"));
}

}  // namespace
}  // namespace jointid::cli
