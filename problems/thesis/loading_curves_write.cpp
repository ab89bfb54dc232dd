#include <nlohmann/json.hpp>

#include "base/random.hpp"
#include "base/temporary_file.hpp"
#include "friction/law/laws.hpp"
#include "problems/thesis/loading_curves.hpp"
#include "problems/thesis/shortest_text.hpp"

namespace jointid::problems {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t written_points = 100;
constexpr double written_noise = 0.01;

/// Displacement or angle to which a joint is loaded.
double range(const friction::Element& element) {
  const std::vector<double> kinks = element.kinks();
  return kinks.empty() ? 4.0 * element.limit() / element.response(0.0).tangent : 1.2 * kinks.back();
}

std::string csv(const LoadingCurve& problem, const friction::Curve& curve) {
  std::string text = "# " + problem.description + "\n" +
                     (problem.ring ? "angle [rad],torque [N·m]\n" : "displacement [m],force [N]\n");
  for (std::size_t i = 0; i < curve.u.size(); ++i) text += shortest_text(curve.u[i]) + "," + shortest_text(curve.value[i]) + "\n";
  return text;
}

std::string truth(const LoadingCurve& problem) {
  Json out = {{"name", problem.name}, {"description", problem.description}, {"law", problem.law}};
  for (const friction::Parameter& each : friction::make_element(problem.law, problem.values)->parameters()) {
    out["parameters"].push_back({{"name", each.name}, {"value", each.value}});
  }
  out["limit"] = element_of(problem)->limit();
  out["normal_load"] = problem.normal_load;
  if (problem.ring) out["ring"] = {problem.ring->inner, problem.ring->outer};
  return out.dump(1) + "\n";
}

}  // namespace

friction::Curve make_curve(const LoadingCurve& problem, std::size_t points, double noise, std::uint64_t seed) {
  const auto element = element_of(problem);
  const double most = range(*element), scale = noise * element->response(most).force;
  friction::Record record;
  for (std::size_t i = 1; i <= points; ++i) {
    const double u = most * static_cast<double>(i) / static_cast<double>(points);
    record.displacement.push_back(u);
    record.force.push_back(element->response(u).force + scale * normal_numbers({.seed = seed}, i)[0]);
  }
  friction::Curve curve = friction::loading_curve(problem.name, std::move(record));
  if (problem.ring) {
    curve.displacement_unit = "rad";
    curve.force_unit = "N·m";
  } else {
    curve.normal_load = problem.normal_load;
  }
  return curve;
}

std::filesystem::path write(const LoadingCurve& problem, const std::filesystem::path& directory, const WriteOptions& options) {
  std::error_code ignored;  // a folder that cannot be made shows when the first file is written
  std::filesystem::create_directories(directory, ignored);
  const std::filesystem::path path = directory / (problem.name + ".csv");
  write_text(path, csv(problem, make_curve(problem, written_points, options.clean ? 0.0 : written_noise, options.seed)));
  write_text(directory / "truth.json", truth(problem));
  return path;
}

std::string fit_options(const LoadingCurve& problem) {
  const std::string ring = problem.ring ? " --ring " + shortest_text(problem.ring->inner) + "," + shortest_text(problem.ring->outer) : "";
  return "--law " + problem.law + ring;
}

}  // namespace jointid::problems
