#include "include_rules.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "function_lines.hpp"
#include "knots.hpp"

namespace jointid::structure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

const std::filesystem::path root = JOINTID_SOURCE_DIR;

/// Headers private to their folder that wrap a library and so have to name it: "frf/hdf5_file.hpp: hdf5.h".
const std::set<std::string> allowed_heavy = {};

IncludeTable table_of_the_docs() {
  std::ifstream markdown(root / "docs/architecture.md");
  return read_table(markdown);
}

/// Rows of folders alone.
IncludeTable folders_of(IncludeTable table) {
  std::erase_if(table, [](const auto& row) { return row.first.find('/') != std::string::npos; });
  return table;
}

std::vector<std::string> violations_in(const std::string& folder, const std::string& text) {
  std::istringstream markdown(
      "| folder | what | may include |\n|---|---|---|\n"
      "| `frf/` | files | – |\n| `weighting/` | rows | frf |\n| `ident/` | all | all above |\n");
  std::istringstream source(text);
  return violations(read_table(markdown), folder, source);
}

TEST(IncludeRules, TheTableIsRead) {
  const IncludeTable table = table_of_the_docs();
  EXPECT_THAT(table.at("base"), IsEmpty());
  EXPECT_THAT(table.at("restrictions"), ElementsAre("base", "dense", "frf"));
  EXPECT_TRUE(table.at("cli").contains("ident"));
}

TEST(IncludeRules, AnIncludeAgainstTheTableIsFound) {
  EXPECT_THAT(violations_in("frf", "#include \"ident/scene.hpp\"\n"),
              ElementsAre("frf may not include ident/scene.hpp"));
  EXPECT_THAT(violations_in("weighting", "  #  include <ident/scene/scene.hpp>  // why\n"),
              ElementsAre("weighting may not include ident/scene/scene.hpp"));
  EXPECT_THAT(violations_in("frf", "#include \"dof.hpp\"\n"), ElementsAre("dof.hpp is included without its folder"));
}

TEST(IncludeRules, AnIncludeAlongTheTableIsNot) {
  EXPECT_THAT(violations_in("ident", "#include \"frf/dof.hpp\"\n#include \"ident/scene.hpp\"\n#include <vector>\n"),
              IsEmpty());
  EXPECT_THAT(violations_in("frf", "// see ident/scene.hpp\n#include <Eigen/Core>\n#include <hdf5.h>\n"), IsEmpty());
}

TEST(IncludeRules, StepsBetweenRoomsAreTold) {
  EXPECT_EQ(room_step("frf/uff/scan.cpp", "frf/set/dof.hpp"), (RoomStep{"frf/uff", "frf/set"}));
  EXPECT_EQ(room_step("frf/open.cpp", "frf/set/dof.hpp"), (RoomStep{"frf/.", "frf/set"}));
  EXPECT_EQ(room_step("ident/likelihood/fit/steps.cpp", "ident/plan/plan.hpp"), (RoomStep{"ident/likelihood", "ident/plan"}));
  EXPECT_EQ(room_step("ident/likelihood/fit/steps.cpp", "ident/likelihood/data/plan.hpp"),
            (RoomStep{"ident/likelihood/fit", "ident/likelihood/data"}));
  EXPECT_EQ(room_step("ident/likelihood/fit/steps.cpp", "ident/likelihood/likelihood.hpp"),
            (RoomStep{"ident/likelihood/fit", "ident/likelihood/."}));
  EXPECT_EQ(room_step("frf/uff/scan.cpp", "frf/uff/scan.hpp"), std::nullopt);
  EXPECT_EQ(room_step("frf/uff/scan.cpp", "base/text.hpp"), std::nullopt);
  EXPECT_EQ(room_step("frf/uff/scan.cpp", "vector"), std::nullopt);
}

TEST(IncludeRules, AnIncludeUpwardsInsideAFolderIsFound) {
  std::istringstream markdown(
      "| folder | what | may include |\n|---|---|---|\n"
      "| `frf/set/` | sets | – |\n| `frf/uff/` | files | set |\n| `frf/./` | opening | all above |\n"
      "| `frf/uff/old/` | old files | – |\n| `frf/uff/new/` | new files | old |\n| `frf/uff/./` | files | all above |\n");
  const IncludeTable table = read_table(markdown);
  const auto found = [&](const std::string& file, const std::string& text) {
    std::istringstream source(text);
    return room_violations(table, file, source);
  };
  EXPECT_THAT(found("frf/uff/old/scan.hpp", "#include \"frf/uff/new/scan.hpp\"\n"),
              ElementsAre("frf/uff/old may not include frf/uff/new/scan.hpp"));
  EXPECT_THAT(found("frf/uff/new/scan.hpp", "#include \"frf/uff/uff.hpp\"\n"), ElementsAre("frf/uff/new may not include frf/uff/uff.hpp"));
  EXPECT_THAT(found("frf/uff/uff.hpp", "#include \"frf/uff/new/scan.hpp\"\n#include \"frf/set/dof.hpp\"\n"), IsEmpty());
  EXPECT_THAT(found("frf/set/dof.hpp", "#include \"frf/uff/scan.hpp\"\n"), ElementsAre("frf/set may not include frf/uff/scan.hpp"));
  EXPECT_THAT(found("frf/uff/scan.hpp", "#include \"frf/open.hpp\"\n"), ElementsAre("frf/uff may not include frf/open.hpp"));
  EXPECT_THAT(found("frf/uff/scan.hpp", "#include \"frf/set/dof.hpp\"\n#include \"base/text.hpp\"\n"), IsEmpty());
  EXPECT_THAT(found("frf/open.hpp", "#include \"frf/set/dof.hpp\"\n#include \"frf/uff/scan.hpp\"\n"), IsEmpty());
}

/// Directories below `folder`, it included, that hold sources or directories with them; the vendored ones are of others.
std::vector<std::string> directories(const std::string& folder) {
  std::vector<std::string> found = {folder};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
    if (!entry.is_directory() || sources(entry.path()).empty()) continue;
    found.push_back(std::filesystem::relative(entry.path(), root).generic_string());
  }
  return found;
}

TEST(IncludeRules, TheRoomsKeepThem) {
  const IncludeTable table = table_of_the_docs();
  std::size_t files = 0;
  for (const auto& row : folders_of(table)) {
    for (const std::string& directory : directories(row.first)) EXPECT_TRUE(table.contains(directory)) << directory;
    for (const auto& path : sources(root / row.first)) {
      std::ifstream source(path);
      EXPECT_THAT(room_violations(table, std::filesystem::relative(path, root).generic_string(), source), IsEmpty()) << path;
      ++files;
    }
  }
  EXPECT_GT(files, 0U);
}

std::size_t files_in(const std::filesystem::path& directory) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) files += entry.is_regular_file() ? 1U : 0U;
  return files;
}

TEST(Folders, HaveAtMostFortyFiles) {
  auto folders = folders_of(table_of_the_docs());
  folders["tests"];
  for (const auto& row : folders) {
    for (const std::string& directory : directories(row.first)) EXPECT_LE(files_in(root / directory), 40U) << directory;
  }
}

TEST(IncludeRules, AHeavyIncludeIsFound) {
  std::istringstream header("#include <Eigen/Core>\n#include <Eigen/Dense>\n#include <CLI/CLI.hpp>\n");
  EXPECT_THAT(heavy_includes(header), UnorderedElementsAre("Eigen/Dense", "CLI/CLI.hpp"));
}

TEST(IncludeRules, EveryFolderWithHeadersStandsInTheTable) {
  const IncludeTable table = table_of_the_docs();
  for (const auto& entry : std::filesystem::directory_iterator(root)) {
    const std::string folder = entry.path().filename();
    if (!entry.is_directory() || folder.starts_with('.')) continue;
    if (std::set<std::string>{"build", "tests", "bench", "examples"}.contains(folder)) continue;
    EXPECT_TRUE(sources(entry).empty() || table.contains(folder)) << folder;
  }
  for (const auto& row : table) EXPECT_TRUE(std::filesystem::is_directory(root / row.first)) << row.first;  // rooms, too
}

TEST(IncludeRules, TheSourcesKeepThem) {
  const IncludeTable table = folders_of(table_of_the_docs());
  std::size_t files = 0;
  for (const auto& row : table) {
    for (const auto& path : sources(root / row.first)) {
      std::ifstream source(path);
      EXPECT_THAT(violations(table, row.first, source), IsEmpty()) << path;
      ++files;
    }
  }
  EXPECT_GT(files, 0U);
}

TEST(IncludeRules, NoHeaderIsHeavy) {
  for (const auto& row : folders_of(table_of_the_docs())) {
    for (const auto& path : sources(root / row.first)) {
      if (path.extension() != ".hpp") continue;
      std::ifstream header(path);
      for (const auto& include : heavy_includes(header)) {
        const std::string name = std::filesystem::relative(path, root).string() + ": " + include;
        EXPECT_TRUE(allowed_heavy.contains(name)) << name;
      }
    }
  }
}

/// Of 50 digits, which dense/ does not have.
const std::set<std::string> own_decompositions = {"stability/exact_number.cpp", "stability/exact_responses.cpp"};

TEST(IncludeRules, ADecompositionIsFound) {
  std::istringstream source("#include <Eigen/Core>\n#include <Eigen/LU>\n#include <Eigen/Sparse>\n");
  EXPECT_THAT(decomposition_includes(source), ElementsAre("Eigen/LU"));
}

TEST(IncludeRules, DecompositionsStandInDense) {
  for (const auto& row : folders_of(table_of_the_docs())) {
    if (row.first == "dense") continue;
    for (const auto& path : sources(root / row.first)) {
      if (own_decompositions.contains(std::filesystem::relative(path, root).string())) continue;
      std::ifstream source(path);
      EXPECT_THAT(decomposition_includes(source), IsEmpty()) << path;
    }
  }
}

TEST(Knots, ACircleOfUnitsIsFound) {
  const UnitGraph graph = {{"a", {"b", "e"}}, {"b", {"c"}}, {"c", {"a", "d"}}, {"d", {}}, {"e", {"f"}}, {"f", {"e"}}};
  EXPECT_THAT(knots(graph), ElementsAre(std::set<std::string>{"a", "b", "c"}, std::set<std::string>{"e", "f"}));
}

TEST(Knots, ThereAreNone) {
  std::vector<std::string> folders;
  for (const auto& row : folders_of(table_of_the_docs())) folders.push_back(row.first);
  const UnitGraph graph = units(root, folders);
  EXPECT_GT(graph.size(), 0U);
  EXPECT_THAT(knots(graph), IsEmpty());
}

/// Rooms of the same folder that include each other in circles, at every level.
std::vector<std::set<std::string>> room_knots(const std::vector<std::pair<std::string, std::string>>& includes_of_files) {
  UnitGraph graph;
  for (const auto& [file, include] : includes_of_files) {
    const auto step = room_step(file, include);
    if (!step) continue;
    graph[step->to];
    graph[step->from].insert(step->to);
  }
  return knots(graph);
}

TEST(Knots, ACircleOfRoomsTwoLevelsDownIsFound) {
  EXPECT_THAT(room_knots({{"ident/likelihood/errors/a.cpp", "ident/likelihood/findings/b.hpp"},
                          {"ident/likelihood/findings/c.hpp", "ident/likelihood/errors/d.hpp"},
                          {"ident/likelihood/findings/c.hpp", "ident/plan/plan.hpp"}}),
              ElementsAre(std::set<std::string>{"ident/likelihood/errors", "ident/likelihood/findings"}));
}

TEST(Knots, OfRoomsThereAreNone) {
  auto folders = folders_of(table_of_the_docs());
  folders["tests"];
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& row : folders) {
    for (const auto& path : sources(root / row.first)) {
      std::ifstream source(path);
      for (const std::string& include : includes(source)) all.emplace_back(std::filesystem::relative(path, root).generic_string(), include);
    }
  }
  EXPECT_GT(all.size(), 0U);
  EXPECT_THAT(room_knots(all), IsEmpty());
}

/// GCC 12 destroys the members of a list inside a list twice where the inner one ends in {} and what follows it throws:
/// `return {{folder / name, {}}, item.positive()};`
std::vector<std::string> twice_destroyed(const std::string& source) {
  static const std::regex pattern(R"(\{\{[^{};]*,\s*\{\}\s*\},[^{};]*\w\()");
  std::vector<std::string> found;
  for (std::sregex_iterator at(source.begin(), source.end(), pattern); at != std::sregex_iterator(); ++at) found.push_back(at->str());
  return found;
}

TEST(NestedLists, ThatAreDestroyedTwiceAreFound) {
  EXPECT_THAT(twice_destroyed("return {{folder / names.back(), {}}, table.require(\"displacement\").positive()};"), testing::SizeIs(1));
  EXPECT_THAT(twice_destroyed("return {{folder / names.back(), {}}, displacement};"), IsEmpty());
}

TEST(NestedLists, ThereAreNone) {
  for (const auto& row : folders_of(table_of_the_docs())) {
    for (const auto& path : sources(root / row.first)) {
      std::ifstream source(path);
      const std::string text((std::istreambuf_iterator<char>(source)), {});
      EXPECT_THAT(twice_destroyed(text), IsEmpty()) << path;
    }
  }
}

/// Bad input is InputError, with a remedy where there is one; these say neither place nor who has to act.
const std::regex nameless_error(R"(std::(invalid_argument|domain_error|length_error|out_of_range|range_error|runtime_error)\b)");

std::vector<std::string> nameless_errors(std::istream& source) {
  std::vector<std::string> found;
  for (std::string line; std::getline(source, line);) {
    if (std::regex_search(line, nameless_error)) found.push_back(line);
  }
  return found;
}

TEST(Errors, ThatAreNamelessAreFound) {
  std::istringstream source("if (wrong) throw std::invalid_argument(\"wrong\");\nreturn found != std::errc::invalid_argument;\n");
  EXPECT_THAT(nameless_errors(source), SizeIs(1));
}

TEST(Errors, OfProductSourcesAreInputErrors) {
  const std::set<std::string> bases = {"base/error.hpp", "base/error.cpp", "base/control.hpp"};
  for (const auto& [folder, allowed] : folders_of(table_of_the_docs())) {
    for (const auto& path : sources(root / folder)) {
      if (bases.contains(path.lexically_relative(root).string())) continue;
      std::ifstream source(path);
      EXPECT_THAT(nameless_errors(source), IsEmpty()) << path;
    }
  }
}

TEST(Lines, AreNotAbove140Characters) {
  std::size_t lines = 0;
  for (const auto& row : folders_of(table_of_the_docs())) {
    for (const auto& path : sources(root / row.first)) {
      std::ifstream source(path);
      for (std::string line; std::getline(source, line); ++lines) {
        const auto characters = std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
        EXPECT_LE(characters, 140) << path << ": " << line;
      }
    }
  }
  EXPECT_GT(lines, 0U);
}

std::string function_of(std::size_t lines, const std::string& first = "  work();") {
  std::string text = "int f(int a,\n      int b = 0) {\n" + first + "\n";
  for (std::size_t i = 4; i < lines; ++i) text += i % 2 == 0 ? "  if (a) {\n" : "  }\n";
  return text + "}\n";
}

TEST(Functions, AreCounted) {
  std::istringstream source("struct A {\n  int g() const {\n    return 0;\n  }\n  int value = 0;\n};\n\n" +
                            std::string("constexpr auto list = make({\n  1,\n});\n") + function_of(61) +
                            function_of(62, "  static const int all = {") + "int h() { return 1; }\n");
  const std::vector<FunctionLines> found = functions_of(source);
  ASSERT_THAT(found, SizeIs(3));
  EXPECT_EQ(found[0].lines, 3U);
  EXPECT_EQ(found[1].lines, 61U);
  EXPECT_EQ(found[2].lines, 62U);
  EXPECT_FALSE(found[1].is_list);
  EXPECT_TRUE(found[2].is_list);
}

TEST(Functions, HaveAtMostSixtyLines) {
  std::size_t functions = 0;
  for (const auto& row : folders_of(table_of_the_docs())) {
    for (const auto& path : sources(root / row.first)) {
      std::ifstream source(path);
      for (const FunctionLines& each : functions_of(source)) {
        EXPECT_TRUE(each.lines <= 60 || each.is_list) << path << ": " << each.begin << ": " << each.lines << " lines";
        ++functions;
      }
    }
  }
  EXPECT_GT(functions, 5000U);
}

/// Headers of the table of docs/library.md.
std::set<std::string> public_headers() {
  std::ifstream docs(root / "docs/library.md");
  std::set<std::string> out;
  for (std::string line; std::getline(docs, line);) {
    if (line.starts_with("| `")) out.insert(line.substr(3, line.find('`', 3) - 3));
  }
  return out;
}

/// Those of ours that a text includes.
std::set<std::string> own_includes(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::set<std::string> out;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("#include \"") || line.find('/') == std::string::npos) continue;  // of its own folder
    out.insert(line.substr(10, line.rfind('"') - 10));
  }
  return out;
}

TEST(PublicHeaders, AreThereAndInstalled) {
  EXPECT_GT(public_headers().size(), 50U);
  EXPECT_LT(public_headers().size(), 120U);
  for (const std::string& header : public_headers()) {
    EXPECT_TRUE(std::filesystem::exists(root / header)) << header;
    const std::string folder = header.substr(0, header.find('/'));
    std::ifstream lists(root / folder / "CMakeLists.txt");
    const std::string text{std::istreambuf_iterator<char>(lists), {}};
    EXPECT_THAT(text, ::testing::HasSubstr(" " + header.substr(folder.size() + 1) + "\n")) << "not installed";
  }
}

TEST(PublicHeaders, AreAllThatOutsidersUse) {
  std::vector<std::filesystem::path> outsiders = {root / "tests/install/outside/main.cpp", root / "docs/library.md"};
  for (const auto& example : sources(root / "examples")) outsiders.push_back(example);
  for (const auto& outside : outsiders) {
    EXPECT_FALSE(own_includes(outside).empty()) << outside;
    for (const std::string& header : own_includes(outside)) {
      EXPECT_TRUE(public_headers().contains(header)) << outside << ": " << header;
    }
  }
}

TEST(Base, HasAtMostFourteenUnits) { EXPECT_LE(units(root, {"base"}).size(), 14U); }

}  // namespace
}  // namespace jointid::structure
