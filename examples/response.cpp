// The response of three masses with a friction joint at two force levels: a scene built in memory, as `jointid response` finds
// it.
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "base/error.hpp"
#include "friction/law/laws.hpp"
#include "tasks/response/run_response.hpp"

using namespace jointid;

/// M ẍ + C ẋ + K x = p in kg, N·s/m, N/m; a joint by Ren's law between masses 2 and 3; coordinates count from 0.
tasks::ResponseScene chain() {
  response::MatrixStructure masses;
  masses.mass = Eigen::Vector3d(1.0, 1.2, 0.9).asDiagonal();
  masses.stiffness = Eigen::Matrix3d{{500.0, -200.0, 0.0}, {-200.0, 250.0, -50.0}, {0.0, -50.0, 150.0}};
  masses.damping = 1e-3 * masses.stiffness;

  tasks::SceneJoint joint;
  joint.positive = {.name = "2", .coordinate = 1, .dof = {}};
  joint.negative = {.name = "3", .coordinate = 2, .dof = {}};
  joint.joint.name = "2-3";
  joint.joint.friction = friction::make_element("ren", std::vector{0.004, 1.5, 150.0});

  tasks::ResponseScene scene;
  scene.structure = masses;
  scene.joints = {joint};
  scene.force_dof = {.name = "1", .coordinate = 0, .dof = {}};
  scene.force = response::Excitation::single(1.0);
  scene.levels = {1.0, 3.0};
  scene.range_hz = {2.0, 5.0};
  scene.points = 61;
  scene.responses = {scene.force_dof};
  return scene;
}

int main() try {
  ident::Control control;
  control.progress = [](const char* stage, std::size_t done, std::size_t total) {
    std::fprintf(stderr, "\r%s: %zu of %zu ", stage, done, total);
  };
  control.interrupted = [] { return false; };  // true ends the run: it throws jointid::Interrupted
  const tasks::ResponseResult found = tasks::run_response(chain(), control);
  std::fputc('\n', stderr);

  std::puts("force N   peak Hz   |x| m");
  for (const tasks::LevelResponse& level : found.levels) {
    if (!level.peak) continue;
    const std::complex<double> x = level.peak->response(tasks::first_row(*level.peak), 0);
    std::printf("%7.1f %9.4f %7.4f\n", level.level, level.peak->omega / (2.0 * std::numbers::pi), std::abs(x));
  }
  return tasks::all_converged(found) ? EXIT_SUCCESS : EXIT_FAILURE;
} catch (const InputError& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return EXIT_FAILURE;
}
