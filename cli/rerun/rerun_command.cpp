#include "cli/rerun/rerun_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/options/child_process.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/provenance/digest.hpp"
#include "cli/provenance/provenance.hpp"
#include "cli/rerun/difference.hpp"
#include "cli/text/version.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
namespace {

using Path = std::filesystem::path;
using report::Json;

[[noreturn]] void fail(const Path& file, const std::string& place, const std::string& problem, const std::string& remedy) {
  throw InputError({ErrorKind::data, file.string(), place, problem, remedy});
}

Json read_json(const Path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) fail(file, "", "cannot be read", "check the path");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object()) fail(file, "", "is no JSON result of jointid", "give what --json wrote");
  return json;
}

/// What a result says of how it was made, of the kinds that are asked for here.
struct Made {
  std::string version, commit;
  std::vector<std::string> command;
  Path folder;
  struct Input {
    std::string file, place;
    std::optional<std::string> sha256;
  };
  std::vector<Input> inputs;
};

Made made_of(const Path& file, const Json& result) try {
  const Json& told = result.at("provenance");
  if (told.contains("python")) {
    fail(file, "provenance", "jointid." + told.at("python").get<std::string>() + "() of Python made it",
         "call the function again; rerun repeats what the command wrote");
  }
  Made out{told.at("version"), told.at("commit"), told.at("command"), told.at("folder").get<std::string>(), {}};
  for (const Json& input : told.at("inputs")) {
    out.inputs.push_back({input.at("file"), input.at("place"), {}});
    if (input.at("sha256").is_string()) out.inputs.back().sha256 = input.at("sha256");
  }
  if (out.command.size() < 2) fail(file, "provenance", "names no command", "make the result again");
  return out;
} catch (const Json::exception&) {
  fail(file, "provenance", "does not state how the result was made", "make the result again with --json of this version");
}

enum class InputState { same, changed, missing, unknown };

InputState state_of(const Made::Input& input, const Path& folder) {
  const Path path = folder / input.file;
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown)) return InputState::missing;
  const auto sum = sha256_of(path);
  if (!sum || !input.sha256) return InputState::unknown;
  return *sum == *input.sha256 ? InputState::same : InputState::changed;
}

constexpr std::array state_words = {"same", "changed", "missing", "not compared"};

/// Options that name what is written, and those of runs in several turns: left out of the repetition, with their values.
constexpr std::array output_options = {"--json", "--csv", "--report", "--out", "--output", "--curves", "--history", "--sweep", "--events",
                                       "--shapes", "--plot", "--state", "--stop-before"};

/// What was given by --out; empty: nothing.
Path main_output(const Made& made) {
  for (std::size_t i = 1; i < made.command.size(); ++i) {
    const std::string& word = made.command[i];
    if (word == "--out" && i + 1 < made.command.size()) return made.command[i + 1];
    if (word.starts_with("--out=")) return word.substr(word.find('=') + 1);
  }
  return {};
}

/// The words of the repetition, run in a folder of its own: inputs by their whole paths, its JSON to `json`, --out by its last name.
std::vector<std::string> repetition(const Made& made, const Path& folder, const Path& program, const Path& json) {
  std::vector<std::string> out = {program.string()};
  for (std::size_t i = 1; i < made.command.size(); ++i) {
    const std::string& word = made.command[i];
    const std::string option = word.substr(0, word.find('='));
    const bool writes = std::ranges::find(output_options, option) != output_options.end();
    if (writes && option == word) ++i;
    if (writes || word == "--resume") continue;
    const bool is_input = std::ranges::find(made.inputs, word, &Made::Input::file) != made.inputs.end();
    out.push_back(is_input ? std::filesystem::absolute(folder / word).string() : word);
  }
  if (const Path output = main_output(made); !output.empty()) out.insert(out.end(), {"--out", output.filename().string()});
  out.insert(out.end(), {"--json", json.string()});
  return out;
}

/// Names of files as the first run had them: relative to its folder, and the whole name of --out.
void name_as_before(Json& value, const std::string& folder, const Path& output) {
  if (value.is_structured()) {
    for (Json& each : value) name_as_before(each, folder, output);
  } else if (value.is_string()) {
    std::string text = value;
    if (!output.empty() && text == output.filename()) text = output.string();
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at)) text.erase(at, folder.size());
    value = text;
  }
}

Json repeated(const Path& file, const Made& made, const Path& folder) {
  const WorkFolder work;
  if (work.path().empty()) fail(file, "", "no temporary folder can be made to repeat the run in", "check the folder for temporary files");
  std::error_code unknown;
  const Path program = std::filesystem::read_symlink("/proc/self/exe", unknown), json = work.path() / "result.json";
  const Ended ended = run_program(repetition(made, folder, program, json), work.path(), true);
  if (!std::filesystem::exists(json, unknown))
    fail(file, "provenance.command", "its repetition ended with " + std::to_string(ended.exit_code) + " and without a result",
         "see the message above");
  Json result = read_json(json);
  name_as_before(result, std::filesystem::absolute(folder).string() + "/", main_output(made));
  return result;
}

Json answer_json(const Difference& difference) {
  Json out = {{"same", difference.same()}, {"values", difference.values}, {"different", difference.other}};
  if (!difference.same())
    out.update({{"largest_difference", difference.largest},
                {"at", difference.at},
                {"before", difference.before},
                {"after", difference.after}});
  return out;
}

std::string answer_text(const Difference& difference) {
  if (difference.same()) return "answers: the same to the last bit, " + std::to_string(difference.values) + " values\n";
  return "answers: " + std::to_string(difference.other) + " of " + std::to_string(difference.values) + " values differ, by " +
         report::number(difference.largest) + " at most (relative), at " + difference.at + ": " + difference.before + " before, " +
         difference.after + " now\n";
}

}  // namespace

void add_rerun(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<RerunArguments>(
      app, chosen, "rerun", "Repeat the run that made a JSON result: are inputs and answers the same?");
  command->add_option("RESULT", arguments->result, "What --json wrote")->required();
  command->add_option("--folder", arguments->folder, "Where the inputs are; default: the folder in which the result was made");
  command->add_option("--json", arguments->json, "Write what was found as JSON to a file, or - for stdout");
  add_force(command);
  command->footer("Examples:\n  jointid solve joint.toml --json joint.json && jointid rerun joint.json");
}

ExitCode execute(const RerunArguments& arguments, std::ostream& out) {
  const Json before = read_json(arguments.result);
  const Made made = made_of(arguments.result, before);
  const Path folder = arguments.folder.empty() ? made.folder : arguments.folder;
  check_targets({{arguments.result, "RESULT"}}, {{"--json", arguments.json}});
  report::Table table({{"input", report::Align::left}, {"", report::Align::left}});
  Json inputs = Json::array();
  std::string missing;
  for (const Made::Input& input : made.inputs) {
    const InputState state = state_of(input, folder);
    table.add({input.file, state_words[static_cast<std::size_t>(state)]});
    inputs.push_back({{"file", input.file}, {"place", input.place}, {"state", state_words[static_cast<std::size_t>(state)]}});
    if (state == InputState::missing && missing.empty()) missing = (folder / input.file).string();
  }
  if (!missing.empty()) fail(missing, "", "an input of " + arguments.result.string() + " is not there", "give its folder by --folder");
  const Difference difference = difference_of(before, repeated(arguments.result, made, folder));
  if (arguments.json)
    write_target(*arguments.json,
                 report::json_text({{"made_by", {{"version", made.version}, {"commit", made.commit}}},
                                    {"inputs", inputs},
                                    {"answers", answer_json(difference)}}),
                 out);
  if (!takes_output({arguments.json})) {
    out << "made by jointid " << made.version << " (" << made.commit << "), repeated by " << version_number() << " (" << built_from()
        << ")\n\n"
        << table.text() << "\n"
        << answer_text(difference);
  }
  return difference.same() ? ExitCode::done : ExitCode::unusable;
}

}  // namespace jointid::cli
