#include "cli/provenance/provenance.hpp"

#include <link.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/provenance/digest.hpp"
#include "report/json_value.hpp"
#include "report/page/escape.hpp"

namespace jointid::cli {
namespace {

struct Run {
  std::vector<std::string> command;
  std::vector<ident::NamedFile> inputs;
  std::optional<report::Json> told_inputs;  ///< with their sums, once they were asked for
};

Run run;

report::Json input_json(const ident::NamedFile& input) {
  std::error_code unknown;
  const auto bytes = std::filesystem::file_size(input.path, unknown);
  const auto sum = sha256_of(input.path);
  return {{"file", input.path.string()},
          {"place", input.place},
          {"bytes", unknown ? report::Json() : report::Json(bytes)},
          {"sha256", sum ? report::Json(*sum) : report::Json()}};
}

/// Read once, for JSON and page.
const report::Json& told_inputs() {
  if (!run.told_inputs) {
    run.told_inputs = report::Json::array();
    for (const ident::NamedFile& input : run.inputs) run.told_inputs->push_back(input_json(input));
  }
  return *run.told_inputs;
}

/// Names of files: "libhdf5_serial.so.103.3.0".
std::vector<std::string> loaded_libraries() {
  std::vector<std::string> out;
  const auto add = [](dl_phdr_info* info, std::size_t, void* to) {
    std::error_code unknown;
    const std::filesystem::path file = std::filesystem::canonical(info->dlpi_name, unknown);
    if (!unknown && *info->dlpi_name != '\0') static_cast<std::vector<std::string>*>(to)->push_back(file.filename().string());
    return 0;
  };
  dl_iterate_phdr(add, &out);
  std::ranges::sort(out);
  return out;
}

report::Json provenance_json() {
  std::error_code unknown;
  report::Json out = {{"version", JOINTID_VERSION},
                      {"commit", built_from()},
                      {"command", run.command},
                      {"folder", std::filesystem::current_path(unknown).string()},
                      {"inputs", told_inputs()}};
  out["libraries"] = loaded_libraries();
  return out;
}

std::string text_of(const report::Json& json) { return json.dump(-1, ' ', false, report::Json::error_handler_t::replace); }

/// As the text's own keys are indented.
std::string as_last_key(const std::string& object) {
  std::string text = provenance_json().dump(2), out;
  for (const char each : text) {
    out += each;
    if (each == '\n') out += "  ";
  }
  const std::size_t end = object.find_last_of('}');
  const std::size_t last = object.find_last_not_of(" \n", end - 1);
  return object.substr(0, last + 1) + (object[last] == '{' ? "" : ",") + "\n  \"provenance\": " + out + "\n}" + object.substr(end + 1);
}

}  // namespace

void begin_provenance(int argc, const char* const* argv) {
  run = {};
  run.command.assign(argv, argv + argc);
  if (!run.command.empty()) run.command.front() = "jointid";
}

void add_provenance_inputs(const std::vector<ident::NamedFile>& inputs) {
  for (const ident::NamedFile& input : inputs) {
    if (std::ranges::find(run.inputs, input.path, &ident::NamedFile::path) == run.inputs.end()) run.inputs.push_back(input);
  }
  run.told_inputs.reset();
}

std::string provenance_text() { return text_of(provenance_json()); }

std::string study_provenance(const std::vector<std::string>& command) {
  return text_of({{"version", JOINTID_VERSION}, {"commit", built_from()}, {"command", command}, {"inputs", told_inputs()}});
}

std::string with_provenance(std::string text) {
  if (text.starts_with('{')) return as_last_key(text);
  const std::size_t footer = text.starts_with("<!DOCTYPE html>") ? text.rfind("</footer>") : std::string::npos;
  if (footer == std::string::npos) return text;
  const std::string made = "<pre>" + report::html(provenance_json().dump(2)) + "</pre>";
  return text.insert(footer, "<details><summary>How this page was made</summary>" + made + "</details>\n");
}

}  // namespace jointid::cli
