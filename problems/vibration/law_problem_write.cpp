#include <nlohmann/json.hpp>

#include "base/temporary_file.hpp"
#include "base/text.hpp"
#include "friction/law/laws.hpp"
#include "problems/case/set_format.hpp"
#include "problems/vibration/law_problem.hpp"

namespace jointid::problems {
namespace {

std::string number(double value) { return nlohmann::json(value).dump(); }

std::string list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "\"" : ", \"") + word + "\"";
  return "[" + text + "]";
}

std::string joint_text(const LawProblemJoint& joint) {
  std::vector<std::string> dofs = {joint.ends.positive.name()};
  if (joint.ends.negative) dofs.push_back(joint.ends.negative->name());
  return "[[joint.friction]]\nname = \"" + joint.name + "\"\ndofs = " + list(dofs) + "\nlaw = " + list(joint.candidates) +
         "  # one of them\n\n";
}

std::string level_text(const LawProblem& problem, std::size_t level, const std::string& responses, const std::string& forces) {
  const std::string harmonics = comma_list(problem.measured, [](int n) { return std::to_string(n); });
  return "[[data.levels]]\nname = \"" + number(problem.levels[level]) + " N\"\nresponses = \"" + responses + "\"\nforces = \"" +
         forces + "\"\nforce_dofs = [\"" + problem.force.name() + "\"]\nharmonics = [" + harmonics + "]\n\n";
}

nlohmann::ordered_json truth_of(const LawProblem& problem) {
  nlohmann::ordered_json truth = {{"name", problem.name}, {"description", problem.description}};
  for (const LawProblemJoint& joint : problem.joints) {
    const auto element = friction::make_element(joint.law, joint.parameters);
    truth["joints"].push_back({{"name", joint.name},
                               {"law", joint.law},
                               {"parameters", joint.parameters},
                               {"stiffness", element->response(0.0).tangent},
                               {"limit", element->limit()}});
  }
  return truth;
}

}  // namespace

std::filesystem::path write(const LawProblem& problem, const std::filesystem::path& directory, const WriteOptions& options) {
  const SetFormat& format = find_set_format(options.format);
  const LawMeasurement exact = measure(problem);
  const LawMeasurement data = options.clean ? exact : polluted(problem, exact, options.seed);
  std::error_code ignored;  // a folder that cannot be made shows when the first file is written
  std::filesystem::create_directories(directory, ignored);
  const auto write_set = [&](const frf::FrfSet& set) {
    const std::string file = std::filesystem::path(set.header.file).replace_extension(format.name).string();
    format.write(set, directory / file);
    return file;
  };
  std::vector<std::string> parts;
  for (const frf::FrfSet& part : data.parts) parts.push_back(write_set(part));
  std::string scene = "title = \"" + problem.name + ": " + problem.description + "\"\n\n[data]\nparts = " + list(parts) + "\n\n";
  for (std::size_t level = 0; level < problem.levels.size(); ++level) {
    const std::string responses = write_set(data.responses[level]), forces = write_set(data.forces[level]);
    scene += level_text(problem, level, responses, forces);
  }
  for (const LawProblemJoint& joint : problem.joints) scene += joint_text(joint);
  scene += "[frequency]\nrange = [" + number(problem.frequency_hz.front()) + ", " + number(problem.frequency_hz.back()) +
           "]  # Hz, of the force\n\n[errors]\nrelative = " + number(problem.noise) + "  # of phasors whose files have none\n";
  write_text(directory / "truth.json", truth_of(problem).dump(1) + "\n");
  const std::filesystem::path path = directory / (problem.name + ".toml");
  write_text(path, scene);
  return path;
}

}  // namespace jointid::problems
