#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "base/error.hpp"
#include "cli/loading_curve/loading_curve_command.hpp"
#include "tasks/loading_curve/loading_curve_data.hpp"
#include "friction/law/laws.hpp"
#include "tests/test_folder.hpp"

namespace jointid::cli {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<double> ren = {3.43e-8, 2.79, 5.7e8};

class LoadingCurveCommand : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  /// Rows of two or three numbers under a header.
  std::filesystem::path table(const std::string& name, const std::string& header, const std::vector<std::vector<double>>& rows) const {
    std::string text = header + "\n";
    for (const auto& row : rows) {
      for (std::size_t i = 0; i < row.size(); ++i) text += fmt::format("{}{}", i == 0 ? "" : ",", row[i]);
      text += "\n";
    }
    return write(name, text);
  }

  static LoadingCurveArguments arguments(std::vector<std::filesystem::path> files) {
    LoadingCurveArguments out;
    out.files = std::move(files);
    return out;
  }

  /// Of laws named in `arguments`, as JSON.
  static nlohmann::json solve(LoadingCurveArguments arguments) {
    arguments.json = "-";
    std::ostringstream out;
    EXPECT_EQ(execute(arguments, out), ExitCode::done);
    return nlohmann::json::parse(out.str());
  }

  static std::string error(const LoadingCurveArguments& arguments) {
    try {
      std::ostringstream out;
      execute(arguments, out);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  static double parameter(const nlohmann::json& fit, std::size_t i, std::size_t curve = 0) {
    return fit["curves"][curve]["parameters"][i]["value"];
  }

  TestFolder folder_;
};

TEST_F(LoadingCurveCommand, UnitsOfTheHeaderOrOfTheOptionsMakeTheSameCurve) {
  const auto header = table("a.csv", "x [um],F [kN]", {{1, 2}, {2, 3}});
  const auto plain = table("b.csv", "x,F", {{1, 2}, {2, 3}});
  auto given = arguments({plain});
  given.unit = "um";
  given.force_unit = "kN";
  for (const auto& each : {arguments({header}), given}) {
    const friction::Curve curve = read_curves(each).curves.at(0);
    EXPECT_THAT(curve.u, ElementsAre(1e-6, 2e-6));
    EXPECT_THAT(curve.value, ElementsAre(2000.0, 3000.0));
  }
}

TEST_F(LoadingCurveCommand, VelocitiesAreIntegratedAndForcesTurned) {
  const auto file = table("a.csv", "Time [ms],Velocity [mm/s],Normal force,Force", {{0, 2, 9, -1}, {1000, 2, 9, -2}, {3000, 4, 9, -3}});
  auto given = arguments({file});
  given.velocity = true;
  const auto data = read_curves(given);
  EXPECT_THAT(data.curves.at(0).u, ElementsAre(0.0, testing::DoubleNear(2e-3, 1e-15), testing::DoubleNear(8e-3, 1e-15)));
  EXPECT_THAT(data.curves.at(0).value, ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(data.notes, ElementsAre(HasSubstr("forces times -1")));
  given.sign = "1";
  EXPECT_THAT(read_curves(given).curves.at(0).value, ElementsAre(-1.0, -2.0, -3.0));
}

TEST_F(LoadingCurveCommand, TheSpecimenIsSubtracted) {
  const auto file = table("a.csv", "u,F", {{3.0, 10.0}, {6.0, 20.0}});
  auto stiffness = arguments({file}), curve = stiffness;
  stiffness.specimen_stiffness = 10.0;
  curve.specimen = table("s.csv", "u,F", {{1.0, 10.0}, {2.0, 20.0}});
  for (const auto& each : {stiffness, curve}) EXPECT_THAT(read_curves(each).curves.at(0).u, ElementsAre(2.0, 4.0));
}

TEST_F(LoadingCurveCommand, ARecordWithCyclesIsCutIntoLoops) {
  const auto element = friction::make_element("ren", ren);
  const double amplitude = 6e-7;
  std::vector<std::vector<double>> rows;
  for (int i = 0; i <= 500; ++i) {
    const double u = amplitude * std::sin(2.0 * std::numbers::pi * i / 100.0);
    const bool rising = i % 100 < 25 || i % 100 >= 75;
    const double end = element->response(amplitude).force;
    const double force = i < 25 ? element->response(u).force
                                : (rising ? 2.0 * element->response(0.5 * (amplitude + u)).force - end
                                          : end - 2.0 * element->response(0.5 * (amplitude - u)).force);
    rows.push_back({u + 1e-3, force + 5.0});
  }
  auto given = arguments({table("a.csv", "position,friction", rows)});
  given.laws = {"ren", "bilinear"};
  const auto json = solve(given);
  EXPECT_EQ(json["best_law"], "ren");
  EXPECT_EQ(json["curves"].size(), 4u);
  EXPECT_EQ(json["loops"].size(), 8u);
  EXPECT_NEAR(parameter(json["fits"][0], 1), 2.79, 0.05);
  EXPECT_NEAR(json["fits"][0]["curves"][0]["friction_limit"]["value"].get<double>() / element->limit(), 1.0, 0.01);
  EXPECT_LT(std::abs(json["loops"][0]["energy_error"].get<double>()), 0.01);
}

TEST_F(LoadingCurveCommand, EnergiesAndEquivalentsOverAmplitudeAreFitted) {
  const auto element = friction::make_element("ren", ren);
  std::vector<std::vector<double>> rows;
  for (int i = 1; i <= 10; ++i) {
    const double x = 7e-8 * i, energy = element->cycle_energy(x);
    rows.push_back({x, energy, element->equivalent_stiffness(x), energy / (std::numbers::pi * x * x)});
  }
  const auto file = table("a.csv", "amplitude,E,ke,de", rows);
  auto energies = arguments({file}), equivalents = energies;
  energies.energy = "E";
  equivalents.stiffness = "ke";
  equivalents.damping = "de";
  for (auto each : {energies, equivalents}) {
    each.laws = {"ren"};
    const auto json = solve(each);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(parameter(json["fits"][0], i) / ren[i], 1.0, 1e-4) << i;
  }
}

TEST_F(LoadingCurveCommand, SeveralFilesShareAShapeAndAFrictionCoefficient) {
  auto given = arguments({});
  for (const double load : {500.0, 1000.0}) {
    const double a = load * 5e-11, b = 3.0, limit = 0.2 * load;
    const auto element = friction::make_element("ren", std::vector{a, b, limit * b / (a * std::expm1(b))});
    std::vector<std::vector<double>> rows;
    for (int i = 1; i <= 40; ++i)
      rows.push_back({0.8 * a * std::exp(b) * i / 40.0, element->response(0.8 * a * std::exp(b) * i / 40.0).force});
    given.files.push_back(table(fmt::format("{}N.csv", load), "u,F", rows));
  }
  given.laws = {"ren"};
  given.normal_loads = {500.0, 1000.0};
  given.shared = {"b"};
  given.friction_coefficient = true;
  const auto json = solve(given);
  EXPECT_THAT(json["fits"][0]["unknowns"], ElementsAre("mu", "b", "k of 500N", "k of 1000N"));
  for (std::size_t curve = 0; curve < 2; ++curve) {
    EXPECT_NEAR(json["fits"][0]["curves"][curve]["mu"]["value"].get<double>(), 0.2, 1e-6);
    EXPECT_NEAR(parameter(json["fits"][0], 1, curve), 3.0, 1e-5);
  }
}

TEST_F(LoadingCurveCommand, NumbersThatCannotBeUsedAreExitCode4AndWritten) {
  auto given = arguments({table("a.csv", "u,F", {{1, 2}, {2, 3}})});
  given.laws = {"ren"};
  given.json = "-";
  std::ostringstream out;
  EXPECT_EQ(execute(given, out), ExitCode::unusable);
  EXPECT_EQ(nlohmann::json::parse(out.str())["status"], "too_few_points");
}

TEST_F(LoadingCurveCommand, WrongFilesAndOptionsAreToldByName) {
  const auto file = table("a.csv", "u,F", {{1, 2}, {2, 3}, {3, 3.5}});
  const auto odd = table("b.csv", "alpha,beta", {{1, 2}});
  const auto with = [&](const auto& change, const std::filesystem::path& path) {
    auto given = arguments({path});
    change(given);
    return error(given);
  };
  using A = LoadingCurveArguments;
  EXPECT_THAT(with([](A&) {}, odd), AllOf(HasSubstr("b.csv"), HasSubstr("no column is named as a displacement"),
                                          HasSubstr("--displacement"), HasSubstr("alpha, beta")));
  EXPECT_THAT(with([](A& a) { a.velocity = true; }, file), HasSubstr("no column is named as a velocity"));
  EXPECT_THAT(with([](A& a) { a.unit = "N"; }, file), AllOf(HasSubstr("--unit"), HasSubstr("'N' is no unit")));
  EXPECT_THAT(with([](A& a) { a.shared = {"z"}; a.laws = {"ren"}; }, file), AllOf(HasSubstr("no parameter 'z'"), HasSubstr("a, b, k")));
  EXPECT_THAT(with([](A& a) { a.limit = 1.0; a.laws = {"spring"}; }, file), HasSubstr("no friction limit to preset"));
  EXPECT_THAT(with([](A& a) { a.limit = -1.0; }, file), HasSubstr("--limit"));
  EXPECT_THAT(with([](A& a) { a.friction_coefficient = true; }, file), HasSubstr("--normal-load"));
  EXPECT_THAT(with([](A& a) { a.ring = {2.0, 1.0}; }, file), HasSubstr("--ring"));
  EXPECT_THAT(with([](A& a) { a.energy = "F"; a.stiffness = "u"; }, file), HasSubstr("--energy"));
  EXPECT_THAT(with([](A& a) { a.stiffness = "u"; }, file), HasSubstr("--stiffness"));
  EXPECT_THAT(with([](A& a) { a.energy = "F"; a.velocity = true; }, file), HasSubstr("amplitude series"));
  EXPECT_THAT(with([](A& a) { a.specimen_stiffness = 0.0; }, file), HasSubstr("--specimen-stiffness"));
  EXPECT_THAT(with([](A&) {}, table("c.csv", "u,F", {{1, 0}, {2, 0}})), AllOf(HasSubstr("c.csv"), HasSubstr("all values are zero")));
}

TEST_F(LoadingCurveCommand, NumbersBeyondAllMeasureAreOneLineForEveryLaw) {
  std::vector<std::vector<double>> rows;
  for (int i = 1; i <= 30; ++i) rows.push_back({i * 1e-8, 100.0 * (1.0 - std::exp(-i / 10.0))});
  for (const double wild : {1e308, -1e308, 3e30}) {
    for (const std::size_t column : {0u, 1u}) {
      auto spoilt = rows;
      spoilt[20][column] = wild;
      for (const auto& law : friction::laws()) {
        LoadingCurveArguments wanted = arguments({table("wild.csv", "u,F", spoilt)});
        wanted.laws = {std::string(law.name)};
        EXPECT_THAT(error(wanted),
                    AllOf(HasSubstr(column == 0 ? "column u: sample 21 is" : "column F: sample 21 is"), HasSubstr("above 1e30")))
            << law.name;
      }
    }
  }
  // Missing ones are left out; nothing but zeros or hardly anything is no curve.
  auto gaps = rows;
  gaps[3][0] = gaps[5][1] = std::nan("");
  LoadingCurveArguments fine = arguments({table("gaps.csv", "u,F", gaps)});
  fine.laws = {"ren"};
  EXPECT_EQ(error(fine), "");
  for (auto& row : rows) row[1] = 0.0;
  EXPECT_THAT(error(arguments({table("zero.csv", "u,F", rows)})), HasSubstr("all values are zero"));
  for (auto& row : rows) row = {row[0] * 1e-300, 1.0};
  EXPECT_THAT(error(arguments({table("tiny.csv", "u,F", rows)})), HasSubstr("no displacement is above 1e-30"));
}

TEST_F(LoadingCurveCommand, AmplitudesThatAreNoneAreOneLine) {
  for (const double wild : {1e308, 0.0, -1.0, 1e-320}) {
    LoadingCurveArguments series = arguments(
        {table("joint.csv", "amplitude,k,d", {{1e-6, 5e7, 1e6}, {2e-6, 4e7, 2e6}, {wild, 3e7, 3e6}, {4e-6, 2e7, 2e6}})});
    series.stiffness = "k", series.damping = "d";
    EXPECT_THAT(error(series), HasSubstr("joint")) << wild;
  }
}

TEST_F(LoadingCurveCommand, UnitsThatContradictTheTitlesAndColumnsUsedTwice) {
  const std::vector<std::vector<double>> rows = {{1, 10}, {2, 18}, {3, 24}, {4, 28}, {5, 30}, {6, 31}, {7, 31.5}, {8, 31.7}};
  LoadingCurveArguments wanted = arguments({table("a.csv", "u (um),F [N]", rows)});
  wanted.laws = {"bilinear"};
  EXPECT_EQ(error(wanted), "");
  wanted.unit = "mm";
  EXPECT_THAT(error(wanted), HasSubstr("column u: the file states um, and mm is given"));
  wanted.unit = "micrometer";
  EXPECT_EQ(error(wanted), "");
  wanted.unit.clear(), wanted.force = "u";
  EXPECT_THAT(error(wanted), HasSubstr("column u: is displacement and force at once"));
  wanted.force.clear(), wanted.time_unit = "ms";
  EXPECT_THAT(error(wanted), HasSubstr("--time-unit: no time is needed without --velocity"));
  LoadingCurveArguments twice = arguments({table("b.csv", "u,F,F", {{1, 2, 3}, {2, 3, 4}})});
  EXPECT_THAT(error(twice), HasSubstr("the name 'F' is above 2 columns"));
  LoadingCurveArguments volts = arguments({table("c.csv", "u [mm],F [V]", rows)});
  EXPECT_THAT(error(volts), HasSubstr("'V' is no unit of it (V is a voltage)"));
}

TEST_F(LoadingCurveCommand, TimesOfVelocitiesInTheirUnit) {
  LoadingCurveArguments velocity = arguments({table("a.csv", "time (ms),v [mm/s],F", {{0, 1, 0}, {1, 1, 1}, {2, 1, 2}})});
  velocity.velocity = true;
  const auto data = tasks::read_curves(velocity);
  EXPECT_NEAR(data.curves[0].u.back() - data.curves[0].u.front(), 2e-6, 1e-15);
  LoadingCurveArguments unknown = arguments({table("b.csv", "time (samples),v [mm/s],F", {{0, 1, 0}, {1, 1, 1}, {2, 1, 2}})});
  unknown.velocity = true;
  EXPECT_THAT(error(unknown), HasSubstr("'samples' is no unit of it"));
}

}  // namespace
}  // namespace jointid::cli
