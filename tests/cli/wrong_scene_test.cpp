#include "wrong_input.hpp"

namespace jointid::cli {
namespace {

const std::string symmetric = "pattern = \"symmetric\"";

/// What the scene file alone shows.
const Wrong scenes[] = {
    {"Absent", {}, {"solve", "absent.toml"}, 2, {"absent.toml: ", "no such scene file", "check the path"}},
    {"Folder", {}, {"plan", "."}, 2, {".: ", "folder", "name the scene file in it"}},
    {"Empty", [](const auto& folder) { folder.write("A1.toml", ""); }, solve(), 2, {"A1.toml: line 1", "'data' is missing", "add it"}},
    {"FrfFileAsScene", {}, {"solve", "a.h5"}, 2, {"a.h5: line 1", "is it a scene file (TOML)?"}},
    {"Syntax", scene("[joint]", "[joint"), solve(), 2, {"A1.toml: line 10, column ", "expected ']'", "correct the TOML there"}},
    {"UnknownKey", scene("range =", "rnage ="), solve(), 2,
     {"A1.toml: line 8, [frequency] rnage: ", "'rnage' is not known here", "did you mean range?"}},
    {"UnknownSection", scene("[identify]", "[identity]"), solve(), 2, {"A1.toml: line ", "[identity]", "did you mean identify?"}},
    {"WrongType", scene("range = [400.0, 1000.0]", "range = \"400 to 1000\""), solve(), 2,
     {"A1.toml: line 8, [frequency] range: ", "expected [lo, hi], found the string \"400 to 1000\""}},
    {"NoAssembly", scene("assembly = [\"A1_assembly.h5\"]", ""), solve(), 2,
     {"A1.toml: line 3, [data]: ", "'assembly' is missing", "add it"}},
    {"EquationWord", scene("\"nj\"]", "\"mj\"]"), solve(), 2,
     {"A1.toml: line 21, [identify] equations[2]: ", "'mj' is not a valid word", "did you mean "}},
    {"WeightingWord", scene("\"WA\"", "\"WBX\""), solve(), 2,
     {"A1.toml: line 22, [identify] weighting: ", "'WBX' is not a valid word", "did you mean "}},
    {"MethodWord", scene("method = \"one\"", "method = \"on\""), solve(), 2,
     {"A1.toml: line 20, [identify] method: ", "'on' is not a valid word", "did you mean one?"}},
    {"SolverWord", scene("method = \"one\"", "solver = \"spqrr\""), solve(), 2,
     {"A1.toml: line 20, [identify] solver: ", "'spqrr' is not a valid word", "did you mean spqr?"}},
    {"VarianceWord", scene("method = \"one\"", "variance = \"flie\""), solve(), 2,
     {"A1.toml: line 20, [identify] variance: ", "'flie' is not a valid word", "did you mean file?"}},
    {"VarianceOfNoNoise", both(scene("[noise]\nmodel = \"uniform\"\nlevel = 0.05\n", ""), scene("method = \"one\"", "variance = \"noise\"")), solve(), 2,
     {"A1.toml: ", "[identify] variance: ", "needs a [noise] section", "add it with model and level"}},
    {"PriorWithoutDeviation", scene("method = \"one\"", "priors = { \"K(1,1)\" = [6.6e5] }"), solve(), 2,
     {"A1.toml: line 20, ", "priors", "K(1,1)", "a prior is a value and its standard deviation, found 1 numbers", "write "}},
    {"PriorDeviationZero", scene("method = \"one\"", "priors = { \"K(1,1)\" = [6.6e5, 0] }"), solve(), 2,
     {"A1.toml: line 20, ", "priors", "K(1,1)", "above 0, found 0"}},
    {"BootstrapTooSmall", scene("method = \"one\"", "bootstrap = 20"), solve(), 2,
     {"A1.toml: line 20, [identify] bootstrap: ", "20 replicates give no 95 % interval", "use 100 or more"}},
    {"BootstrapNotWhole", scene("method = \"one\"", "bootstrap = 200.5"), solve(), 2,
     {"A1.toml: line 20, [identify] bootstrap: ", "200.5 is no whole number"}},
    {"BootstrapSeedAlone", scene("method = \"one\"", "bootstrap_seed = 2"), solve(), 2,
     {"A1.toml: line 20, [identify] bootstrap_seed: ", "without bootstrap", "give bootstrap = 200"}},
    {"DeltaTwo", scene("weighting = \"WA\"", "delta = 2"), solve(), 2,
     {"A1.toml: line 22, [identify] delta: ", "delta = 2 is outside 0 <= delta < 2"}},
    {"StepZero", scene("[400.0, 1000.0]", "[400.0, 1000.0]\nstep = 0"), solve(), 2,
     {"A1.toml: line 9, [frequency] step: ", "above 0, found 0"}},
    {"RangeReversed", scene("[400.0, 1000.0]", "[1000.0, 400.0]"), solve(), 2,
     {"A1.toml: line 8, [frequency] range: ", "expected lo < hi, found [1000, 400]"}},
    {"DofText", scene("\"4:+RZ\"", "\"4:+RW\""), solve(), 2,
     {"A1.toml: line 11, [joint] dofs[2]: ", "'4:+RW' is not a DOF", "write node:direction"}},
    {"DofTwice", scene("\"4:+RZ\"", "\"4:-Y\""), solve(), 2,
     {"A1.toml: line 11, [joint] dofs[2]: ", "4:-Y is here twice", "name each coordinate once"}},
    {"MatrixSize", scene(symmetric, "matrix = [[\"a\", \"b\"], [\"b\", \"a\"]]"), solve(), 2,
     {"A1.toml: line 14, [joint.stiffness] matrix: ", "2 rows", "4 DOFs", "a row and a column for each"}},
    {"NonLinear", scene(symmetric, "matrix = [[\"a*b\", 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]"), solve(), 2,
     {"A1.toml: line 14, [joint.stiffness] matrix[1][1]: ", "'a*b' multiplies the unknowns 'a' and 'b'"}},
    {"JointAndJoints", scene("[identify]", "[[joints]]\nname = \"b\"\n[identify]"), solve(), 2,
     {"A1.toml: line 10, [joint]: ", "both [joint] and [[joints]]", "write every joint as [[joints]]"}},
    {"ForeignSpring", scene(symmetric, "springs = [[\"4:+Y\", \"6:+Y\"]]"), solve(), 2,
     {"A1.toml: line 14, [joint.stiffness] springs: ", "6:+Y is not a DOF of the joint"}},
    {"TruthSize", scene("[truth]\n", "[truth]\nmass = [[1, 0], [0, 1]]\n"), solve(), 2,
     {"A1.toml: line ", "[truth] mass: ", "found 2 rows, expected 4"}},
    {"NoiseModelWord", scene("\"uniform\"", "\"unifrom\""), solve(), 2,
     {"A1.toml: line ", "[noise] model: ", "'unifrom' is not a valid word", "did you mean uniform?"}},
    {"RepeatAlone", scene("\"A1_assembly.h5\"", "[\"A1_assembly.h5\"]"), solve(), 2,
     {"A1.toml: line 5, [data] assembly[1]: ", "one run has no scatter", "or more runs"}},
    {"RepeatsThatDisagree", scene("\"A1_assembly.h5\"", "[\"A1_assembly.h5\", \"a.h5\"]"), solve(), 3,
     {"a.h5: repeats: ", "10 to 30 Hz in 3 lines", "differ from those of ", "A1_assembly.h5", "as files of their own"}},
    {"Deep", [](const auto& folder) { folder.write("A1.toml", "a = " + std::string(100000, '[')); }, solve(), 2, {"A1.toml: line 1, column ", "nest"}},
    {"DeepKey", [](const auto& folder) {
       std::string key = "a";
       for (int i = 0; i < 100000; ++i) key += ".a";
       folder.write("A1.toml", key + " = 1");
     }, solve(), 2, {"A1.toml: line 1: ", "more than 32 parts"}},
    {"Huge", [](const auto& folder) { folder.write("A1.toml", std::string(std::size_t{17} << 20, '#')); }, solve(), 2,
     {"A1.toml: ", "larger than 16 MiB", "is it a scene?"}},
    {"FileTwice", scene("A1_substructure_2.h5", "A1_substructure_1.h5"), solve(), 2,
     {"A1.toml: line 4, [data] substructures[2]: ", "'A1_substructure_1.h5' is named twice"}},
};
INSTANTIATE_TEST_SUITE_P(Scene, WrongInput, testing::ValuesIn(scenes), name_of);

}  // namespace
}  // namespace jointid::cli
