#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.hpp"
#include "cli/series/series_command.hpp"
#include "frf/file/columns.hpp"
#include "oscillation/measurement/beam_shapes.hpp"
#include "tests/test_folder.hpp"

namespace jointid::cli {
namespace {

using testing::HasSubstr;

std::filesystem::path write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
  return path;
}

template <class Arguments>
nlohmann::json run(Arguments arguments) {
  arguments.json = "-";
  std::ostringstream out;
  EXPECT_EQ(execute(arguments, out), ExitCode::done);
  return nlohmann::json::parse(out.str());
}

/// x of the Hénon map, exponent 0.4192 nats per iteration, D₂ 1.21: embedded without folds in two dimensions.
std::string henon(int count) {
  std::ostringstream text;
  text.precision(17);
  text << "x\n";
  double x = 0.1, y = 0.3;
  for (int i = 0; i < count + 100; ++i) {
    const double next = 1.0 - 1.4 * x * x + y;
    y = 0.3 * x, x = next;
    if (i >= 100) text << x << "\n";
  }
  return text.str();
}

TEST(SeriesDelay, KnowsTheHenonMap) {
  const TestFolder folder;
  SeriesDelayArguments arguments;
  arguments.file = write(folder / "henon.csv", henon(4000));
  arguments.rate_hz = 1.0;
  arguments.delay = 1;
  arguments.theiler = 5;
  arguments.most_dimension = 4;
  arguments.steps = 20;
  const auto found = run(arguments);
  EXPECT_EQ(found["dimension"], 2);
  EXPECT_NEAR(found["correlation_dimension"].get<double>(), 1.21, 0.1);
  EXPECT_NEAR(found["exponent_rosenstein"]["nats_per_second"].get<double>(), 0.4192, 0.06);
  EXPECT_EQ(found["samples"], 4000);
  arguments.report = (folder / "henon.html").string();
  std::ostringstream out;
  execute(arguments, out);
  EXPECT_THAT(out.str(), HasSubstr("nats per s"));
  std::ifstream page(*arguments.report);
  EXPECT_THAT((std::string{std::istreambuf_iterator<char>(page), {}}), HasSubstr("Mutual information"));
}

TEST(SeriesDelay, OfATurnDeterminesNoExponent) {
  const TestFolder folder;
  std::ostringstream text;
  text.precision(17);
  text << "time,x\n";
  for (int i = 0; i < 3000; ++i) text << 0.01 * i << "," << std::sin(0.1 * i) + 0.3 * std::sin(0.1 * std::sqrt(2.0) * i) << "\n";
  SeriesDelayArguments arguments;
  arguments.file = write(folder / "turns.csv", text.str());
  arguments.most_dimension = 4;
  const auto found = run(arguments);
  EXPECT_TRUE(found["exponent_rosenstein"]["nats_per_second"].is_null());
  EXPECT_NE(found["exponent_rosenstein"]["reason"], "");
  EXPECT_NEAR(found["rate_hz"].get<double>(), 100.0, 1e-9);
  arguments.channel = "absent";
  EXPECT_THROW(run(arguments), InputError);
}

TEST(SeriesStrain, GivesTheDisplacementsOfModes) {
  const TestFolder folder;
  const double length = 0.4, thickness = 0.00086;
  const std::vector<double> gauges = {0.05, 0.15, 0.25};
  std::ostringstream text;
  text.precision(17);
  text << "a,b,c\n";
  const auto amplitude = [](int i, std::size_t mode) {
    return 1e-3 * std::cos(0.1 * i * static_cast<double>(mode)) / static_cast<double>(mode);
  };
  const auto shape = [&](std::size_t mode, double x) { return oscillation::deflection({oscillation::ShapeKind::mode, mode}, length, x); };
  for (int i = 0; i < 50; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      double strain = 0.0;
      for (std::size_t mode = 1; mode <= 3; ++mode)
        strain += amplitude(i, mode) * 0.5 * thickness * shape(mode, gauges[k]).curvature;
      text << (k > 0 ? "," : "") << strain;
    }
    text << "\n";
  }
  SeriesStrainArguments arguments;
  arguments.file = write(folder / "strain.csv", text.str());
  arguments.length = length, arguments.thickness = thickness, arguments.gauges = gauges;
  arguments.points = {0.2, 0.4};
  arguments.output = (folder / "y.csv").string();
  const auto map = run(arguments);
  EXPECT_EQ(map["noise"].size(), 2u);
  const frf::Columns found = frf::read_columns(*arguments.output);
  for (int i = 0; i < 50; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      double exact = 0.0;
      for (std::size_t mode = 1; mode <= 3; ++mode) exact += amplitude(i, mode) * shape(mode, arguments.points[k]).value;
      EXPECT_NEAR(found.columns[k].values[static_cast<std::size_t>(i)], exact, 1e-14);
    }
  }
  EXPECT_EQ(found.columns[1].unit, "m");
  arguments.gauges = {0.05, 0.15};
  EXPECT_THROW(run(arguments), InputError);
}

TEST(SeriesFriction, FindsTheLawThatMadeTheRecord) {
  const TestFolder folder;
  std::ostringstream text;
  text.precision(17);
  text << "v,F,N\n";
  for (int i = 0; i < 400; ++i) {
    const double v = i < 40 ? 0.0 : 0.002 * (i - 39), normal = 2.0 + 0.1 * std::sin(i);
    const double mu = i < 40 ? 0.5 * i / 40.0 : 0.3 + 0.2 * std::exp(-4.0 * v);
    text << v << "," << mu * normal << "," << normal << "\n";
  }
  SeriesFrictionArguments arguments;
  arguments.file = write(folder / "run.csv", text.str());
  arguments.velocity = "v", arguments.force = "F", arguments.normal = "N", arguments.stick_speed = 0.001;
  const auto found = run(arguments);
  EXPECT_TRUE(found["falls"]);
  EXPECT_NEAR(found["kinetic"].get<double>(), 0.3, 1e-6);
  EXPECT_NEAR(found["drop"].get<double>(), 0.2, 1e-6);
  EXPECT_NEAR(found["decay"].get<double>(), 4.0, 1e-4);
  EXPECT_NEAR(found["static_bound"].get<double>(), 0.4875, 1e-12);
  arguments.load = 2.0;
  EXPECT_THROW(run(arguments), InputError);
  arguments.normal.clear();
  EXPECT_FALSE(run(arguments)["kinetic"].is_null());
}

TEST(SeriesAlign, TakesTheDelayOfASensorAway) {
  const TestFolder folder;
  std::ostringstream text;
  text.precision(17);
  text << "time,slider,beam\n";
  const double hz = 12.0, late = 0.0031;
  const auto motion = [&](double t) { return std::sin(2.0 * M_PI * hz * t) + 0.2 * std::cos(6.0 * M_PI * hz * t); };
  for (int i = 0; i < 2000; ++i)
    text << 0.0005 * i << "," << motion(0.0005 * i) << "," << 0.4 * motion(0.0005 * i - late) << "\n";
  SeriesAlignArguments arguments;
  arguments.file = write(folder / "run.csv", text.str());
  arguments.reference = "slider";
  arguments.frequency_hz = hz;
  arguments.output = (folder / "aligned.csv").string();
  const auto found = run(arguments);
  EXPECT_NEAR(found["channels"][1]["delay_s"].get<double>(), late, 1e-9);
  EXPECT_NEAR(found["channels"][1]["degrees"].get<double>(), 360.0 * hz * late, 1e-5);
  EXPECT_TRUE(found["remarks"].empty());
  const frf::Columns aligned = frf::read_columns(*arguments.output);
  for (std::size_t i = 10; i < 1900; ++i)
    EXPECT_NEAR(aligned.columns[2].values[i], 0.4 * motion(0.0005 * static_cast<double>(i)), 1e-4);
  arguments.output.reset();
  arguments.frequency_hz = 17.3;
  EXPECT_EQ(run(arguments)["remarks"].size(), 2u);  // no channel moves with it
}

}  // namespace
}  // namespace jointid::cli
