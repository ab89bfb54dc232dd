#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/text/failure.hpp"

// scene_answers: what the commands answer to scenes, for docs/site/scene_keys.py. It asks more than a thousand questions; to start the
// command for each of them took 100 s of processor time. A line of the input is
// {"arguments": ["plan", "s.toml"], "files": {"s.toml": "…"}}. The files are written into the working directory. Each question is
// answered by one line, a JSON string: the error, "" where there is none.

namespace {

using jointid::cli::ChosenCommand;
using jointid::cli::Notice;

std::string answer(const nlohmann::json& question) {
  for (const auto& file : question.at("files").items()) std::ofstream(file.key()) << file.value().get<std::string>();
  const auto words = question.at("arguments").get<std::vector<std::string>>();
  std::vector<const char*> arguments = {"jointid"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  try {
    const auto parsed = jointid::cli::parse_all(static_cast<int>(arguments.size()), arguments.data());
    if (const auto* notice = std::get_if<Notice>(&parsed)) return notice->text;
    std::ostringstream report;
    std::get<ChosenCommand>(parsed).execute(report);
    return "";
  } catch (...) {
    return jointid::cli::explain(std::current_exception()).line;
  }
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) std::cout << nlohmann::json(answer(nlohmann::json::parse(line))) << std::endl;
}
