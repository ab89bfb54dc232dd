#include "wrong_input.hpp"

namespace jointid::cli {
namespace {

Spoil keep_positions_out(const std::string& file) {
  return with_set(file, [](frf::FrfSet& set) { set.header.nodes.clear(); });
}

/// Leaves the first `count` responses of a set.
Spoil first_responses(const std::string& file, std::size_t count) {
  return with_set(file, [count](frf::FrfSet& set) {
    frf::FrfSet kept;
    kept.header = set.header;
    kept.header.response.resize(count);
    for (std::size_t line = 0; line < set.header.lines(); ++line) {
      for (std::size_t r = 0; r < count; ++r) {
        for (std::size_t c = 0; c < set.header.reference.size(); ++c) {
          kept.values.push_back(set.values[set.index(line, r, c)]);
        }
      }
    }
    set = kept;
  });
}

Spoil axis(const std::string& file, double shift) {
  return with_set(file, [shift](frf::FrfSet& set) {
    for (double& hz : set.header.frequency_hz) hz += shift;
  });
}

/// Method "likelihood" with what the files say about their noise.
Spoil likelihood_by_file() { return scene("method = \"one\"", "method = \"likelihood\"\nvariance = \"file\""); }

/// Gives all files variances but `file`, which gets coherences of 1.
Spoil coherence(const std::string& file, double averages) {
  Spoil spoil = with_set(file, [averages](frf::FrfSet& set) {
    set.header.noise = frf::NoiseRecord::coherence;
    set.header.averages = averages;
    set.coherence.assign(set.values.size(), 1.0);
  });
  for (const std::string part : {"A1_substructure_1.h5", "A1_substructure_2.h5"}) {
    spoil = both(spoil, with_set(part, [](frf::FrfSet& set) {
                   set.header.noise = frf::NoiseRecord::variance;
                   set.variance.assign(set.values.size(), {1e-20, 1e-20});
                 }));
  }
  return spoil;
}

/// What shows when the scene meets its data.
const Wrong plans[] = {
    {"DofThatNoFileHas", scene("\"5:+Y\"", "\"5:+Z\""), solve(), 2,
     {"A1.toml: ", "[joint] dofs: ", "no substructure file has the DOF 5:+Z", "did you mean 5:+Y?"}},
    {"EquationThatTheDataDoNotAllow", first_responses("A1_substructure_1.h5", 6), solve(), 2,
     {"A1.toml: ", "[identify] equations: ", "equation nn cannot be used", "the substructures have no response 4:+Y",
      "leave it out, measure what it lacks, or let `jointid check` look for a mistaken label"}},
    {"NoEquation", both(first_responses("A1_substructure_1.h5", 6), scene("equations = [\"nn\", \"nj\"]\n", "")), solve(), 2,
     {"A1.toml: ", "[data]: ", "the data allow no equation", "the substructures have no response 4:+Y", "measure it"}},
    {"RangeWithoutLines", scene("[400.0, 1000.0]", "[401.0, 419.0]"), solve(), 2,
     {"A1.toml: ", "[frequency]: ", "leaves no line", "400 to 1000 Hz in 31 lines"}},
    {"EverythingExcluded", scene("[joint]", "exclude = [[0, 2000]]\n[joint]"), solve(), 2,
     {"A1.toml: ", "[frequency]: ", "leaves no line", "400 to 1000 Hz in 31 lines"}},
    {"FreeWithoutPositions",
     both(both(both(keep_positions_out("A1_substructure_1.h5"), keep_positions_out("A1_substructure_2.h5")),
               keep_positions_out("A1_assembly.h5")),
          scene("pattern = \"symmetric\"", "pattern = \"free\"")),
     solve(), 2, {"A1.toml: ", "stiffness", "needs the position of node 4", "[nodes]"}},
    {"NewtonExplainsTheBlockNnAlone", scene("method = \"one\"", "method = \"newton\""), solve(), 2,
     {"A1.toml: ", "[identify] equations: ", "method \"newton\" uses the equation nn only", "leave it out"}},
    {"LinearSolverOfTheLikelihood", scene("method = \"one\"", "method = \"likelihood\"\nsolver = \"qr\""), solve(), 2,
     {"A1.toml: ", "[identify] solver: ", "method \"likelihood\" has no solver \"qr\"", "use auto"}},
    {"LikelihoodOfAJointThatIsNotSymmetric",
     both(scene("method = \"one\"", "method = \"likelihood\""), scene("pattern = \"symmetric\"", "pattern = \"full\"")),
     solve(), 2, {"A1.toml: ", "[joint]: ", "the joint is not symmetric", "use pattern = \"symmetric\""}},
    {"CoherenceOfOneAverage", both(likelihood_by_file(), coherence("A1_assembly.h5", 1.0)), solve(), 3,
     {"A1_assembly.h5: ", "coherences of 1 average(s) are 1 whatever the noise is", "take more averages", "[noise]"}},
    {"FileWithoutVariances", likelihood_by_file(), solve(), 3,
     {"A1_substructure_1.h5: ", "neither variances nor coherences", "take more averages", "[noise]"}},
    {"SolverOfAnotherMethod", scene("method = \"one\"", "solver = \"ceres\""), solve(), 2,
     {"A1.toml: ", "[identify] solver: ", "no solver \"ceres\"", "use auto, qr, normal, spqr, cholmod or ldlt"}},
    {"PriorsOfALinearMethod", scene("method = \"one\"", "priors = { \"K(1,1)\" = [6.6e5, 1e4] }"), solve(), 2,
     {"A1.toml: ", "[identify] priors: ", "method \"one\" has no use for priors", "use method \"likelihood\""}},
    {"PriorOfNoUnknown", scene("method = \"one\"", "method = \"likelihood\"\npriors = { \"K(1,9)\" = [6.6e5, 1e4] }"), solve(), 2,
     {"A1.toml: ", "[identify] priors: ", "no unknown K(1,9)", "did you mean K(1,1)?"}},
    {"BootstrapOfALinearMethod", scene("method = \"one\"", "bootstrap = 200"), solve(), 2,
     {"A1.toml: ", "[identify] bootstrap: ", "method \"one\" has no bootstrap", "use method \"likelihood\""}},
    {"NothingUnknown",
     scene("pattern = \"symmetric\"\n\n[joint.hysteretic_damping]\npattern = \"symmetric\"",
           "matrix = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]"),
     solve(), 2, {"A1.toml: ", "[joint]: ", "every element of the joint is known", "name an unknown"}},
    {"MethodTwoWithNn", scene("method = \"one\"", "method = \"two\""), solve(), 2,
     {"A1.toml: ", "[identify] equations: ", "nn", "Method Two has the equations jn and jj only", "leave it out"}},
    {"FileOfTheSceneAbsent", scene("A1_substructure_2.h5", "A1_substructure_3.h5"), solve(), 3,
     {"A1_substructure_3.h5: ", "no such file", "check"}},
    {"AxesWithoutACommonLine", axis("A1_assembly.h5", 7.0), solve(), 3,
     {"A1.toml: ", "[frequency]: ", "common", "407 to 1007 Hz in 31 lines", "400 to 1000 Hz in 31 lines"}},
    {"PartsWithoutACommonLine", axis("A1_substructure_2.h5", 7.0), solve(), 3,
     {"A1_substructure_1.h5: ", "substructures: ", "no frequency line is common to all files", "A1_substructure_2.h5",
      "one axis"}},
    {"CoordinateInTwoParts",
     with_set("A1_substructure_2.h5", [](frf::FrfSet& set) { set.header.response[2] = frf::Dof::parse("3:-Y"); }),
     solve(), 3, {"A1_substructure_2.h5: ", "DOF 3:-Y is also in ", "A1_substructure_1.h5", "rename the node"}},
    {"AssemblyFrfInTwoFiles",
     both([](const InputFolder& folder) {
            std::filesystem::copy(folder.path("A1_assembly.h5"), folder.path("again.h5"));
          },
          scene("[\"A1_assembly.h5\"]", "[\"A1_assembly.h5\", \"again.h5\"]")),
     solve(), 3, {"again.h5: ", "assembly: ", "FRF 1:+Y / 1:+Y is also in ", "A1_assembly.h5", "keep it in one file"}},
};
INSTANTIATE_TEST_SUITE_P(Plan, WrongInput, testing::ValuesIn(plans), name_of);

}  // namespace
}  // namespace jointid::cli
