#include "laws/data/level_states.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <numbers>

#include "base/error.hpp"
#include "ident/plan/data_source.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "tests/frf/uff_samples.hpp"
#include "tests/test_folder.hpp"

namespace jointid::laws {
namespace {

using testing::HasSubstr;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The states are those that were simulated: a file of two harmonics, forces with phases.
TEST(LevelStates, AreThoseOfTheFiles) {
  const TestFolder folder;
  const auto problem = problems::make_law_problem("sdof-iwan");
  const auto exact = problems::measure(problem);
  const LevelStates data = read_level_states(read_law_scene(problems::write(problem, folder, {.clean = true})));
  ASSERT_EQ(data.states.size(), problem.levels.size() * problem.frequency_hz.size());
  const response::MeasuredState& state = data.states[13];  // second line of the second level
  EXPECT_EQ(data.level[13], 1u);
  EXPECT_NEAR(state.omega, angular(problem.frequency_hz[1]), 1e-9);
  EXPECT_EQ(state.harmonics, (std::vector<int>{1, 3}));
  EXPECT_EQ(state.force.harmonics, (std::vector<int>{1, 3}));
  EXPECT_NEAR(std::abs(state.force.amplitudes(0, 0)), problem.levels[1], 1e-12);
  EXPECT_EQ(state.response(0, 0), exact.responses[1].values[1]);
  EXPECT_NEAR(state.deviation(0, 0), 0.01 * std::abs(state.response(0, 0)) / std::sqrt(2.0), 1e-12 * state.deviation(0, 0));
}

TEST(LevelStates, VariancesOfFilesCount) {
  const TestFolder folder;
  const auto problem = problems::make_law_problem("sdof-iwan");
  const LevelStates data = read_level_states(read_law_scene(problems::write(problem, folder, {})));
  EXPECT_TRUE(data.structure->knows_errors());
  EXPECT_TRUE(data.notes.empty());
  EXPECT_NEAR(data.states[0].deviation(0, 0) / std::abs(data.states[0].response(0, 0)), 0.01 / std::sqrt(2.0), 1e-6);
}

/// One phasor of every line of a set, as a record of its own.
frf::samples::Record spectrum(const frf::FrfSet& set, std::size_t response, int type, const std::string& unit, double factor, int power) {
  std::vector<double> numbers;
  const std::size_t responses = set.header.response.size();
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    const double omega = angular(set.header.frequency_hz[line]);
    const Complex value = factor * std::pow(Complex(0.0, omega), power) * set.values[line * responses + response];
    numbers.insert(numbers.end(), {set.header.frequency_hz[line], value.real(), value.imag()});
  }
  frf::samples::Record record = frf::samples::binary_record(6, numbers);
  record.function_type = 12;
  record.points = static_cast<long>(set.header.lines());
  record.even = 0;
  record.response_node = set.header.response[response].node;
  record.response_direction = static_cast<int>(set.header.response[response].direction);
  record.reference_node = record.reference_direction = record.denominator_type = 0;
  record.numerator_type = type;
  record.numerator_unit = unit;
  return record;
}

/// What an analyser exports: one file with the spectra of accelerometers and force cell, root mean squares, in units of its own.
TEST(LevelStates, AreThoseOfSpectraInUniversalFiles) {
  const TestFolder folder;
  const auto problem = problems::make_law_problem("sdof-iwan");
  const auto exact = problems::measure(problem);
  const auto path = problems::write(problem, folder, {.clean = true});
  const LevelStates expected = read_level_states(read_law_scene(path));
  std::string text = text_of(path);
  for (std::size_t level = 0; level < problem.levels.size(); ++level) {
    const frf::FrfSet &responses = exact.responses[level], &forces = exact.forces[level];
    const std::string name = "spectra_" + std::to_string(level) + ".uff";
    std::string bytes;
    for (std::size_t r = 0; r < responses.header.response.size(); ++r)
      bytes += spectrum(responses, r, 12, "mm/s^2", 1e3 / std::numbers::sqrt2, 2).str();
    for (std::size_t f = 0; f < forces.header.response.size(); ++f)
      bytes += spectrum(forces, f, 13, "kN", 1e-3 / std::numbers::sqrt2, 0).str();
    std::ofstream(folder / name, std::ios::binary) << bytes;
    for (const frf::FrfSet* set : {&responses, &forces}) {
      const std::string old = std::filesystem::path(set->header.file).replace_extension("h5").string();
      const std::size_t place = text.find("\"" + old + "\"");
      ASSERT_NE(place, std::string::npos) << old;
      text.replace(place, old.size() + 2, "\"" + name + "\"");
    }
  }
  for (std::size_t place = 0; (place = text.find("force_dofs", place)) != std::string::npos; place += 30)
    text.insert(place, "amplitudes = \"rms\"\n");
  const LevelStates data = read_level_states(parse_law_scene(text, path));
  ASSERT_EQ(data.states.size(), expected.states.size());
  for (std::size_t i = 0; i < data.states.size(); ++i) {
    const response::MeasuredState &one = data.states[i], &other = expected.states[i];
    EXPECT_LE((one.response - other.response).norm(), 1e-14 * other.response.norm());
    EXPECT_LE((one.force.amplitudes - other.force.amplitudes).norm(), 1e-14 * other.force.amplitudes.norm());
    EXPECT_LE((one.deviation - other.deviation).norm(), 1e-12 * other.deviation.norm());
  }
}

/// Two harmonics in one file: it is opened once, parsed once, and asked for its DOFs besides.
TEST(LevelStates, OpenEveryFileOnce) {
  const TestFolder folder;
  const auto problem = problems::make_law_problem("sdof-iwan");
  const LawScene scene = read_law_scene(problems::write(problem, folder, {.clean = true}));
  std::map<std::filesystem::path, int> opened;
  read_level_states(scene, PhasorFiles([&](const std::vector<ident::DataFile>& files) {
                      for (const ident::DataFile& file : files) ++opened[file.path];
                      return ident::open_all(files);
                    }));
  EXPECT_EQ(opened.size(), 2 * problem.levels.size());
  for (const auto& [file, count] : opened) EXPECT_EQ(count, 1) << file;
}

/// The phasors of all harmonics are read in one go.
TEST(LevelStates, ReadEveryFileOnce) {
  const TestFolder folder;
  const LawScene scene = read_law_scene(problems::write(problems::make_law_problem("sdof-iwan"), folder, {.clean = true}));
  PhasorFiles files;
  const ForceLevel& level = scene.levels.front();
  const auto first = files.read(level.harmonics[0].responses, files.dofs(level.harmonics[0].responses));
  EXPECT_EQ(first, files.read(level.harmonics[1].responses, files.dofs(level.harmonics[1].responses)));
}

TEST(LevelStates, SayWhatIsNotThere) {
  const TestFolder folder;
  const auto path = problems::write(problems::make_law_problem("sdof-iwan"), folder, {.clean = true});
  const std::string text = text_of(path);
  const auto error_with = [&](const std::string& what, const std::string& by) -> std::string {
    std::string changed = text;
    const std::size_t place = changed.find(what);
    EXPECT_NE(place, std::string::npos) << what;
    changed.replace(place, what.size(), by);
    try {
      read_level_states(parse_law_scene(changed, path));
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_THAT(error_with("[errors]\nrelative = 0.01", ""), HasSubstr("nothing states how exact they are"));
  EXPECT_THAT(error_with("[80.0, 135.0]", "[1.0, 2.0]"), HasSubstr("no line of any level can be used"));
  EXPECT_THAT(error_with("dofs = [\"1:+Y\"]\nlaw", "dofs = [\"7:+Y\"]\nlaw"), HasSubstr("7:+Y"));
  EXPECT_THAT(error_with("level_2.h5", "level_9.h5"), HasSubstr("level_9.h5"));
}

}  // namespace
}  // namespace jointid::laws
