// A scene of `jointid oscillate` from a file: the exact stick-slip motion and its periodic orbit.
#include <cstdio>
#include <cstdlib>

#include "base/error.hpp"
#include "tasks/oscillate/oscillate_scene.hpp"
#include "tasks/oscillate/run_oscillate.hpp"

using namespace jointid;

int main(int count, char** arguments) try {
  if (count != 2) {
    std::fputs("usage: example_oscillate SCENE.toml\n", stderr);
    return EXIT_FAILURE;
  }
  const tasks::OscillateScene scene = tasks::read_oscillate_scene(arguments[1]);
  ident::Control control;
  control.progress = [](const char* stage, std::size_t done, std::size_t total) {
    if (total > 0) std::fprintf(stderr, "\r%s: %zu of %zu ", stage, done, total);
  };
  control.interrupted = [] { return false; };  // true ends the run: it throws jointid::Interrupted
  const tasks::OscillateResult found = tasks::run_oscillate(scene, control);
  std::fputc('\n', stderr);

  std::printf("%s: %zu events, it sticks for %.3f of the time\n", found.title.c_str(), found.motion->events,
              found.motion->stick_share);
  if (found.orbit && found.orbit->converged) std::printf("periodic orbit of %.9f s\n", found.orbit->period);
  const std::string failure = tasks::failure_of(found);
  if (failure.empty()) return EXIT_SUCCESS;
  std::fprintf(stderr, "%s\n", failure.c_str());
  return EXIT_FAILURE;
} catch (const InputError& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return EXIT_FAILURE;
}
