#include "problems/thesis/pulses.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/temporary_file.hpp"
#include "base/text.hpp"
#include "problems/thesis/shortest_text.hpp"

namespace jointid::problems {
namespace {

std::string scene_text(const PulseProblem& problem) {
  const std::string values = comma_list(problem.parameters, shortest_text);
  return "title = \"" + problem.name + ": " + problem.description() +
         "\"\n\n[structure]\nmass = [[1.0, 0.0, 0.0], [0.0, 1.2, 0.0], [0.0, 0.0, 0.9]]\n"
         "stiffness = [[500.0, -200.0, 0.0], [-200.0, 250.0, -50.0], [0.0, -50.0, 150.0]]\n"
         "damping = [[0.5, -0.16, 0.0], [-0.16, 0.32, -0.04], [0.0, -0.04, 0.21]]\n\n"
         "[[joints]]\ndofs = [2, 3]\nlaw = \"" +
         problem.law + "\"\nparameters = [" + values + "]\n\n[transient]\nduration = " + shortest_text(16.0 * pulse_length) +
         "  # s\nstep = " + shortest_text(pulse_length / 50.0) +
         "\npulses = [{ dof = 1, amplitude = 36.0, length = " + shortest_text(pulse_length) + " }]\n\n[response]\ndofs = [1, 2, 3]\n";
}

}  // namespace

const std::vector<PulseProblem>& list_pulses() {
  static const std::vector<PulseProblem> all = {
      {"pulse-bilinear",
       "bilinear",
       {0.01, 150.0},
       {{{-0.00246658531406, 0.0562419182312, 0.0693035295476},
         {0.0463926777824, -0.0719200340093, -0.0596873340361},
         {-0.0680590981941, -0.0253043931015, -0.0215503103395},
         {-0.0129411104616, -0.017263712979, -0.00672229587552}}}},
      {"pulse-ren",
       "ren",
       {0.004, 1.5, 150.0},
       {{{-0.00199465577836, 0.0565983618322, 0.0688212261735},
         {0.0474515639806, -0.0714601665844, -0.0614890017528},
         {-0.0698858280835, -0.025370828075, -0.0206628443695},
         {-0.0144645873883, -0.0159498338055, -0.00772828500734}}}},
      {"pulse-shoukry",
       "shoukry",
       {1.5, 100.0},
       {{{-0.0021955687163, 0.0555695505839, 0.0704035172539},
         {0.0474990283066, -0.071922810383, -0.0605126509207},
         {-0.0698878428898, -0.0235639273233, -0.0241807370283},
         {-0.0138740425947, -0.0131672182196, -0.0107720950029}}}},
      {"pulse-burdekin",
       "burdekin",
       {150.0, -3500.0},
       {{{-0.00280024298844, 0.0553872158624, 0.0706154966438},
         {0.0458674727639, -0.0724963253266, -0.0581650549706},
         {-0.0673000117422, -0.0240828916938, -0.0238913885795},
         {-0.0108718586478, -0.0158432834084, -0.0079864667823}}}},
      {"pulse-iwan",
       "iwan",
       {1.5, 150.0, -0.5, 0.3},
       {{{-0.00233808024228, 0.0556366721162, 0.0703225683473},
         {0.046985227212, -0.0720605633313, -0.0599707682442},
         {-0.0690892378699, -0.0238792670628, -0.0239496520039},
         {-0.0122851460844, -0.0146393373233, -0.00932174092499}}}},
  };
  return all;
}

const PulseProblem* find_pulse(const std::string& name) {
  const auto found = std::ranges::find(list_pulses(), name, &PulseProblem::name);
  return found == list_pulses().end() ? nullptr : &*found;
}

std::filesystem::path write(const PulseProblem& problem, const std::filesystem::path& directory) {
  std::error_code ignored;  // a folder that cannot be made shows when the first file is written
  std::filesystem::create_directories(directory, ignored);
  nlohmann::ordered_json truth = {{"name", problem.name}, {"description", problem.description()}};
  truth["times"] = pulse_times;
  truth["displacements"] = problem.displacements;
  write_text(directory / "truth.json", truth.dump(1) + "\n");
  const std::filesystem::path scene = directory / (problem.name + ".toml");
  write_text(scene, scene_text(problem));
  return scene;
}

}  // namespace jointid::problems
