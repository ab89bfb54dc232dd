#include <sys/stat.h>

#include "wrong_input.hpp"

namespace jointid::cli {
namespace {

/// What stands on the command line.
const Wrong command_lines[] = {
    {"Nothing", {}, {}, 2, {"no command", "`jointid --help`"}},
    {"UnknownCommand", {}, {"sovle", "A1.toml"}, 2, {"'sovle' is no command", "did you mean 'solve'?"}},
    {"UnknownCommandUnlikeAny", {}, {"xxxxxxxxxxxx"}, 2, {"'xxxxxxxxxxxx' is no command", "`jointid --help`"}},
    {"UnknownSubcommand", {}, {"problem", "wirte", "A1", "new"}, 2,
     {"'wirte' is no command of `jointid problem`", "did you mean 'write'?", "`jointid problem --help`"}},
    {"NoSubcommand", {}, {"problem"}, 2, {"no command", "`jointid problem --help`"}},
    {"UnknownOption", {}, {"solve", "A1.toml", "--jsn", "new"}, 2,
     {"`jointid solve` has no option '--jsn'", "did you mean '--json'?", "`jointid solve --help`"}},
    {"OptionOfNoCommand", {}, {"--frobnicate"}, 2, {"--frobnicate", "`jointid --help`"}},
    {"ArgumentTooMany", {}, {"solve", "A1.toml", "B.toml"}, 2, {"'B.toml'", "not expected", "`jointid solve --help`"}},
    {"NoScene", {}, {"solve"}, 2, {"SCENE is required", "`jointid solve --help`"}},
    {"NoOut", {}, {"convert", "a.h5"}, 2, {"OUT is required", "`jointid convert --help`"}},
    {"OptionWithoutValue", {}, {"solve", "A1.toml", "--json"}, 2, {"--json", "needs a value", "`jointid solve --help`"}},
    {"BothToStdout", {}, {"solve", "A1.toml", "--json", "-", "--csv", "-"}, 2,
     {"--json - --csv -", "both want standard output", "give one of them a file"}},
    {"BothToOneFile", {}, {"solve", "A1.toml", "--json", "new", "--csv", "./new"}, 2,
     {"--json new --csv ./new", "both want the same file", "give each its own"}},
    {"OutputOverTheScene", {}, {"solve", "A1.toml", "--json", "A1.toml"}, 2,
     {"--json A1.toml", "would replace the input A1.toml (the scene)", "give another name"}},
    {"EmptyOutputName", {}, {"solve", "A1.toml", "--json", ""}, 2, {"--json", "empty", "name a file"}},
    {"OutputFolderAbsent", {}, {"solve", "A1.toml", "--json", "absent/a.json"}, 3,
     {"absent/a.json: ", "cannot be written", "absent does not exist", "make the folder"}},
    {"OutputIsAFolder", [](const auto& folder) { std::filesystem::create_directory(folder.path("new")); },
     {"solve", "A1.toml", "--csv", "new"}, 3, {"new: ", "is a folder", "name a file in it"}},
    {"OutputInAFile", {}, {"plan", "A1.toml", "--json", "A1.toml/a.json"}, 3,
     {"A1.toml/a.json: ", "cannot be written", "A1.toml is no folder", "name a file in a folder"}},
    {"SecondOutputUnwritable", {}, {"solve", "A1.toml", "--json", "old.json", "--csv", "absent/a.csv"}, 3,
     {"absent/a.csv: ", "cannot be written", "make the folder"}},
    {"UnwritableFolder", {}, {"solve", "A1.toml", "--json", "/proc/a.json"}, 3, {"/proc/a.json: ", "cannot be written", "check the folder"}},
    {"OutputIsAPipe", [](const auto& folder) { ::mkfifo(folder.path("new").c_str(), 0600); }, {"solve", "A1.toml", "--json", "new"}, 3,
     {"new: ", "cannot be written: there is something else than a file"}},
    {"OutputIsALinkToAPipe", [](const auto& folder) {
       ::mkfifo(folder.path("pipe").c_str(), 0600);
       std::filesystem::create_symlink("pipe", folder.path("new"));
     }, {"solve", "A1.toml", "--json", "new"}, 3, {"pipe: ", "cannot be written: there is something else than a file"}},
    {"UnknownFormat", {}, {"convert", "a.h5", "new.xls"}, 2, {"new.xls: ", "'xls' is no format", ".h5, .uff, .mat or .csv"}},
    {"NoFormat", {}, {"convert", "a.h5", "new"}, 2, {"new: ", "no extension", ".h5, .uff, .mat or .csv"}},
    {"UffToAnAbsentFolder", {}, {"convert", "a.h5", "absent/new.uff"}, 3,
     {"absent/new.uff: ", "cannot be written", "absent does not exist", "make the folder"}},
    {"Hdf5ToAnAbsentFolder", {}, {"convert", "a.h5", "absent/new.h5"}, 3,
     {"absent/new.h5: ", "cannot be written", "absent does not exist", "make the folder"}},
    {"ConvertToAFolder", [](const auto& folder) { std::filesystem::create_directory(folder.path("new.h5")); },
     {"convert", "a.h5", "new.h5"}, 3, {"new.h5: ", "cannot be written", "is a folder", "name a file in it"}},
    {"PlotWithoutSlash", {}, {"solve", "A1.toml", "--plot", "1:+Y"}, 2,
     {"--plot", "'1:+Y' is not RESPONSE/REFERENCE", "write e.g. 1:+Y/5:+Y"}},
    {"PlotOfNoDof", {}, {"solve", "A1.toml", "--plot", "1:+Y/5:+W"}, 2, {"--plot", "'5:+W' is not a DOF", "write node:direction"}},
    {"PlotOfNoFrf", {}, {"solve", "A1.toml", "--plot", "1:+Y/9:+Y"}, 2,
     {"--plot", "no FRF 1:+Y/9:+Y", "`jointid plan` lists"}},
    {"ReportFolderAbsent", {}, {"solve", "A1.toml", "--report", "absent/a.html"}, 3,
     {"absent/a.html: ", "absent does not exist", "make the folder"}},
    {"StudyOutputFolderAbsent", {}, {"study", "A1.toml", "--trials", "2", "--csv", "absent/a.csv"}, 3,
     {"absent/a.csv: ", "absent does not exist", "make the folder"}},
    {"StudyOutputsTheSame", {}, {"study", "A1.toml", "--trials", "2", "--out", "new", "--json", "new"}, 2,
     {"--json new --out new", "both want the same file", "give each its own"}},
    {"StudyWithoutTrials", {}, {"study", "A1.toml", "--trials", "0"}, 2, {"--trials", "0", "give 1 or more"}},
    {"QuantityWord", {}, {"info", "a.h5", "--quantity", "volts"}, 2, {"--quantity", "'volts'", "receptance, mobility or accelerance"}},
    {"DofWord", {}, {"info", "a.h5", "--response", "1:+Y,4:+Q"}, 2, {"--response", "'4:+Q' is not a DOF", "write node:direction"}},
    {"ProblemFormat", {}, {"problem", "write", "A1", "new", "--format", "xls"}, 2, {"--format", "xls", "h5", "uff"}},
    {"Seed", {}, {"problem", "write", "A1", "new", "--seed", "-1"}, 2, {"--seed", "'-1' is not a whole number of at least 0"}},
    {"SeedBeyond64Bits", {}, {"study", "A1.toml", "--seed", "18446744073709551616"}, 2,
     {"--seed", "'18446744073709551616' is more than 18446744073709551615", "`jointid study --help`"}},
    {"TrialsNegative", {}, {"study", "A1.toml", "--trials", "-5"}, 2, {"--trials", "'-5' is not a whole number of at least 0"}},
    {"TrialsInParts", {}, {"compare", "A1.toml", "--trials", "1.5"}, 2, {"--trials", "'1.5' is not a whole number of at least 0"}},
    {"TrialsWithoutEnd", {}, {"study", "A1.toml", "--trials", "1e300"}, 2, {"--trials", "'1e300' is not a whole number"}},
    {"TrialsOfManyDigits", {}, {"study", "A1.toml", "--trials", std::string(400, '9')}, 2, {"--trials", "99…' is more than 1000000000"}},
    {"TooManyThreads", {}, {"study", "A1.toml", "--threads", "10000"}, 2, {"--threads", "'10000' is more than ", "0 takes all", "cores"}},
    {"TooManyThreadsToCouple", {}, {"couple", "A1.toml", "--threads", "1e4"}, 2, {"--threads", "'1e4' is more than "}},
    {"ScenesInWords", {}, {"stability", "--scenes", "many"}, 2, {"--scenes", "'many' is not a whole number"}},
    {"NoModes", {}, {"modalfit", "a.h5", "--modes", "0"}, 2, {"--modes", "'0' is not a whole number of at least 1"}},
    {"OptionBehindAStrayWord", {}, {"solve", "A1.toml", "B.toml", "--json", "new"}, 2, {"'B.toml' was not expected", "`jointid solve --help`"}},
    {"OptionBeforeTheCommand", {}, {"--json", "new", "solve", "A1.toml"}, 2, {"'--json'", "put it behind `jointid solve`"}},
    {"ProblemName", {}, {"problem", "write", "A99", "new"}, 2, {"problem: ", "no problem 'A99'", "did you mean A9?"}},
    {"ProblemIntoAFile", {}, {"problem", "write", "A1", "a.csv"}, 3, {"a.csv", "cannot be written", "check the folder"}},
};
INSTANTIATE_TEST_SUITE_P(CommandLine, WrongInput, testing::ValuesIn(command_lines), name_of);

}  // namespace
}  // namespace jointid::cli
