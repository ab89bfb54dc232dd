#include <nlohmann/json.hpp>
#include <sstream>

#include "base/temporary_file.hpp"
#include "problems/case/identification_problem.hpp"
#include "problems/case/modal_set.hpp"
#include "problems/case/set_format.hpp"

namespace jointid::problems {
namespace {

using Json = nlohmann::ordered_json;

std::string truth_text(const ModalSet& set) {
  const Json truth = {{"name", set.name},
                      {"description", set.description},
                      {"natural_frequencies_hz", set.modes.frequency_hz},
                      {"loss_factors", set.modes.loss_factor}};
  return truth.dump(1) + "\n";
}

/// Noise-free data as a file: a coherence would speak of noise that is not there.
frf::FrfSet without_noise_record(frf::FrfSet set) {
  set.header.noise = frf::NoiseRecord::none;
  set.header.averages = 0.0;
  set.coherence.clear();
  return set;
}

Measurement data_of(const Problem& problem, const WriteOptions& options) {
  if (!options.clean) return polluted(problem, options.seed, 0);
  Measurement result;
  for (const frf::FrfSet& set : problem.substructures)
    result.substructures.push_back(without_noise_record(set));
  result.assembly = without_noise_record(problem.assembly);
  return result;
}

/// The file name of a set, which ends in .h5 in the scene of the problem, in another format.
std::string file_name(const frf::FrfSet& set, const SetFormat& format) {
  return std::filesystem::path(set.header.file).replace_extension(format.name).string();
}

std::string scene_in_format(const Problem& problem, const SetFormat& format) {
  std::string scene = problem.scene;
  const auto rename = [&](const frf::FrfSet& set) {
    const std::size_t at = scene.find(set.header.file);
    scene.replace(at, set.header.file.size(), file_name(set, format));
  };
  for (const frf::FrfSet& set : problem.substructures) rename(set);
  rename(problem.assembly);
  return scene;
}

/// A scene with another method, without what the problem says of its own: weighting, delta, solver, start.
std::string with_method(std::string scene, const std::string& method) {
  const std::string title = "[identify]\n";
  const std::size_t begin = scene.find(title) + title.size(), end = scene.find("\n[", begin) + 1;
  std::istringstream section(scene.substr(begin, end - begin));
  std::string text = "method = \"" + method + "\"\n";
  for (std::string line; std::getline(section, line);) {
    if (line.starts_with("equations") || line.empty()) text += line + "\n";
  }
  return scene.replace(begin, end - begin, text);
}

std::string truth_text(const Problem& problem) {
  Json truth = {{"name", problem.name}, {"description", problem.description}};
  for (const frf::Dof& dof : problem.joint_dofs) truth["dofs"].push_back(dof.name());
  for (const ExactUnknown& unknown : problem.unknowns) {
    truth["unknowns"].push_back({{"name", unknown.name}, {"value", unknown.value}});
  }
  for (const auto& [kind, matrix] : problem.truth) truth["matrices"][restrictions::key(kind)] = matrix;
  Json& frequencies = truth["natural_frequencies_hz"];
  for (const Modes& part : problem.substructure_modes)
    frequencies["substructures"].push_back(part.frequency_hz);
  frequencies["assembly"] = problem.assembly_modes.frequency_hz;
  return truth.dump(1) + "\n";
}

}  // namespace

std::filesystem::path write(const Problem& problem, const std::filesystem::path& directory,
                            const WriteOptions& options) {
  const SetFormat& format = find_set_format(options.format);
  const Measurement data = data_of(problem, options);
  std::error_code ignored;  // a folder that cannot be made shows when the first file is written
  std::filesystem::create_directories(directory, ignored);
  for (const frf::FrfSet& set : data.substructures) format.write(set, directory / file_name(set, format));
  format.write(data.assembly, directory / file_name(data.assembly, format));
  write_text(directory / "truth.json", truth_text(problem));
  const std::filesystem::path scene = directory / (problem.name + ".toml");
  const std::string text = scene_in_format(problem, format);
  write_text(scene, options.method.empty() ? text : with_method(text, options.method));
  return scene;
}

std::filesystem::path write(const ModalSet& set, const std::filesystem::path& directory, const WriteOptions& options) {
  const SetFormat& format = find_set_format(options.format);
  std::error_code ignored;  // shows when the file is written
  std::filesystem::create_directories(directory, ignored);
  const frf::FrfSet data = options.clean ? set.clean : polluted(set, options.seed, 0);
  const std::filesystem::path file = directory / file_name(set.clean, format);
  format.write(data, file);
  write_text(directory / "truth.json", truth_text(set));
  return file;
}

}  // namespace jointid::problems
