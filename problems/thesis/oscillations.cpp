#include "problems/thesis/oscillations.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/temporary_file.hpp"

namespace jointid::problems {
namespace {

using Json = nlohmann::ordered_json;

/// The chain of n masses on a belt (3.1–3.11). The thesis prints neither c, α, μ_S, μ_K, N nor the sampling step.
std::string chain_scene(const std::string& system, const std::string& decay, const std::string& start, const std::string& rest) {
  return "# The thesis prints neither damping, decay, static, kinetic, normal nor the step: these are ours.\n"
         "[system]\nkind = \"belt_chain\"\n" +
         system +
         "velocity = 0.2           # of the belt\n\n"
         "[friction]               # f = N (kinetic + (static - kinetic) exp(-decay |V_r|))\n"
         "kinetic = 0.3\nstatic = 0.5\ndecay = " +
         decay +
         "\nnormal = 3.0\n\n"
         "[start]\ndisplacement = " +
         start + "\n\n" + rest;
}

const std::string chain_10_rest =
    "[motion]\ntransient = 1500.0\nlength = 6000.0\nstep = 0.2\n\n"
    "[exponents]\ncount = 4\nlength = 6000.0\ninterval = 2.0\n\n"
    "[sweep]\nparameter = \"velocity\"\nrange = [0.5, 0.1]\npoints = 41\ntransient = 500.0\nlength = 300.0\n";

const std::string chain_10_orbit_rest =
    "[motion]\ntransient = 4000.0\nlength = 1000.0\nstep = 0.2\n\n"
    "[orbit]\nslips = 8\n\n"
    "[reduction]\nbases = [\"pod\", \"normal_modes\", \"craig_bampton\"]\norders = [10, 9, 8, 7, 6, 5, 4, 3]\nfrom = \"orbit\"\n";

const std::string chain_3_rest =
    "[motion]\ntransient = 1500.0\nlength = 6000.0\nstep = 0.2\n\n"
    "[exponents]\ncount = 3\nlength = 6000.0\ninterval = 2.0\n\n"
    "[sweep]\nparameter = \"velocity\"\nrange = [0.5, 0.1]\npoints = 41\ntransient = 500.0\nlength = 300.0\n";

/// The cantilever of chapter 6 on its slider, parameters of Tables 4.x.
std::string beam_scene(bool rigid) {
  return "[system]\nkind = \"cantilever\"\nlength = 0.4              # m\nwidth = 0.0128\nthickness = 0.00086\nyoungs_modulus = "
         "128e9   # N/m^2\n"
         "density = 7488.0         # kg/m^3\nextension = 0.076        # m, to the nub\nextension_free = 0.064\nextension_width = "
         "0.0134\n"
         "extension_thickness = 0.00056\nextension_density = 6777.0\nfixture_mass = 0.01226   # kg\n"
         "modes = 8                # clamped-free modes of the Ritz model; the thesis has six\n"
         "first_mode_damping = 0.01  # C = cK, c = 2*0.01/omega_1: \"one per cent proportional damping\"\n"
         "amplitude = 0.0023       # m, of the slider; only a figure of the thesis: ours\nfrequency = 12.0         # Hz\n"
         "points = [0.05, 0.1, 0.15, 0.2, 0.25, 0.3]  # m, where the gauges are\nstrain_at = 0.05\n\n"
         "[friction]\nkinetic = 0.55\nstatic = 0.748           # 1.36 kinetic\nnormal = 0.345           # N\nnormal_slope = "
         "-1.54     # N/m\n" +
         std::string(rigid ? "" : "contact_stiffness = 20000.0  # N/m\n") +
         "\n[motion]                 # 600 cycles, the last 100 kept\ntransient = 41.6666666666666667\nlength = "
         "8.3333333333333333\nstep = 0.000868055555555555556\n\n"
         "[orbit]\ncycles = 3\n\n"
         "[exponents]\ncount = 2\nlength = 33.3333333333333333\ninterval = 0.0833333333333333333\n\n"
         "[sweep]\nparameter = \"frequency\"\nrange = [8.0, 14.0]\npoints = 25\ntransient = 300.0        # cycles\nlength = "
         "60.0\n\n"
         "[reduction]\nbases = [\"pod\", \"normal_modes\", \"craig_bampton\"]\norders = [3, 4, 6]\n";
}

std::string scene_of(const std::string& name) {
  if (name == "chain-10") {
    return chain_scene("masses = 10\ndamping = 0.01           # c of C = cK\n", "2.0",
                       "[0.9, 1.8, 2.7, 3.6, 4.5, 5.4, 6.3, 7.2, 8.1, 9.0]", chain_10_rest);
  }
  if (name == "chain-10-orbit") {
    return chain_scene("masses = 10\ndamping = 0.05           # c of C = cK\n", "2.0",
                       "[0.9, 1.8, 2.7, 3.6, 4.5, 5.4, 6.3, 7.2, 8.1, 9.0]", chain_10_orbit_rest);
  }
  if (name == "chain-3")
    return chain_scene("masses = 3\ndamping = 0.005          # c of C = cK\n", "1.0", "[0.9, 1.8, 2.7]", chain_3_rest);
  return beam_scene(name == "cantilever-rigid");
}

/// What the thesis prints of it.
Json printed(const std::string& name) {
  if (name == "chain-3") return Json();
  if (name.starts_with("chain")) {
    return {
        {"table_3_1",
         {{"modes", {3, 4, 5, 6, 7, 8, 9}},
          {"fractions_percent", {94.05, 96.50, 98.53, 99.59, 99.90, 99.95, 99.99}},
          {"deviation_X_percent", {6.07, 4.67, 2.17, 1.08, 0.39, 0.25, 0.05}},
          {"deviation_E_percent", {2.07, 0.99, 0.44, 0.06, 0.01, 0.02, 0.01}}}},
        {"table_3_2",
         {{"period", {1, 3, 5}}, {"deviation_X_percent", {0.614, 2.527, 4.873}}, {"deviation_E_percent", {0.095, 1.350, 0.610}}}},
        {"largest_exponent", {{"value", 0.2833}, {"unit", "not printed"}}}};
  }
  return {{"fractions_at_12_hz", {0.9913, 0.0083, 0.0003}},
          {"frequencies_hz", {3.13, 21.97, 64.72, 130.64, 220.55, 334.12}},
          {"frequencies_measured_hz", {3.75, 18.4, 53.75, 102.5, 172.5, 265.0}}};
}

}  // namespace

const std::vector<Oscillation>& list_oscillations() {
  static const std::vector<Oscillation> all = {
      {"chain-10", "ten masses on a belt, chaotic (Kappagantu, chapter 3)"},
      {"chain-10-orbit", "ten masses on a belt with more damping: a stable orbit of eight slips, reduced models"},
      {"chain-3", "three masses on a belt, chaotic"},
      {"cantilever", "a beam whose nub rubs on a slider, compliant contact (Kappagantu, chapter 6)"},
      {"cantilever-rigid", "the same with a rigid contact"},
  };
  return all;
}

const Oscillation* find_oscillation(const std::string& name) {
  const auto found = std::ranges::find(list_oscillations(), name, &Oscillation::name);
  return found == list_oscillations().end() ? nullptr : &*found;
}

std::filesystem::path write(const Oscillation& problem, const std::filesystem::path& directory) {
  std::error_code ignored;  // a folder that cannot be made shows when the first file is written
  std::filesystem::create_directories(directory, ignored);
  const Json truth = {{"name", problem.name}, {"description", problem.description}, {"thesis", printed(problem.name)}};
  write_text(directory / "truth.json", truth.dump(1) + "\n");
  const std::filesystem::path scene = directory / (problem.name + ".toml");
  write_text(scene, "title = \"" + problem.name + ": " + problem.description + "\"\n\n" + scene_of(problem.name));
  return scene;
}

}  // namespace jointid::problems
