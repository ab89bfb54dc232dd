// What a run does not need is not loaded: base/module.hpp.
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "frf/file/write.hpp"
#include "input_folder.hpp"
#include "run_command.hpp"

namespace jointid::cli {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Libraries that are ours to leave out, as the dynamic loader names those that it loads.
const std::vector<std::string> optional_libraries = {"jointid_", "hdf5",    "matio",  "mpi",  "ipopt", "ceres",
                                                     "spqr",     "cholmod", "lapack", "curl", "ldap",  "mumps", "glog"};

/// Those of them that a command loads.
std::vector<std::string> loaded_by(const InputFolder& folder, const std::vector<std::string>& arguments) {
  ::setenv("LD_DEBUG", "files", 1);
  ::setenv("LD_DEBUG_OUTPUT", folder.path("loader").c_str(), 1);
  const Outcome outcome = run_command(folder.path(), arguments);
  ::unsetenv("LD_DEBUG");
  ::unsetenv("LD_DEBUG_OUTPUT");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::vector<std::string> loaded;
  bool any = false;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    if (!entry.path().filename().string().starts_with("loader.")) continue;
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      const std::size_t at = line.find("calling init: ");
      if (at == std::string::npos) continue;
      any = true;
      const std::string library = std::filesystem::path(line.substr(at + 14)).filename();
      if (library.starts_with("libjointid_")) continue;  // a folder's, where libraries are shared
      for (const std::string& name : optional_libraries) {
        if (library.find(name) != std::string::npos) loaded.push_back(library);
      }
    }
    in.close();
    std::filesystem::remove(entry.path());
  }
  EXPECT_TRUE(any) << "the loader tells nothing";
  return loaded;
}

/// The files of case A1 as UFF, and the scene with them.
void use_uff(const InputFolder& folder) {
  for (const std::string name : {"A1_assembly", "A1_substructure_1", "A1_substructure_2"}) {
    frf::write(frf::load(*frf::open(folder.path(name + ".h5"))), folder.path(name + ".uff"));
    folder.replace("A1.toml", name + ".h5", name + ".uff");
  }
}

TEST(Modules, NoneForTheVersionTheHelpOrTextFiles) {
  const InputFolder folder;
  EXPECT_THAT(loaded_by(folder, {"--version"}), IsEmpty());
  EXPECT_THAT(loaded_by(folder, {"--help"}), IsEmpty());
  EXPECT_THAT(loaded_by(folder, {"info", "a.uff"}), IsEmpty());
  EXPECT_THAT(loaded_by(folder, {"convert", "a.uff", "x.csv"}), IsEmpty());
  use_uff(folder);
  std::string before = "method = \"one\"\nequations = [\"nn\", \"nj\"]\nweighting = \"WA\"";
  for (const std::string method : {"one", "two", "direct", "newton", "likelihood"}) {
    const std::string section = "method = \"" + method + "\"";
    folder.replace("A1.toml", before, section);
    before = section;
    EXPECT_THAT(loaded_by(folder, {"solve", "A1.toml"}), IsEmpty()) << method;
  }
}

/// Scenes whose structures are inline and curves in text need no library of others, whatever the command has them for.
TEST(Modules, NoneForResponsesOscillationsAndCurvesOfText) {
  const InputFolder folder;
  folder.write("response.toml",
        "[structure]\nmass = [[1.0, 0.0], [0.0, 1.0]]\nstiffness = [[2.0, -1.0], [-1.0, 2.0]]\n"
        "damping = [[0.02, -0.01], [-0.01, 0.02]]\n"
        "[[joints]]\ndofs = [1, 2]\nlaw = \"ren\"\nparameters = [0.05, 2.0, 1.0]\n"
        "[force]\ndof = 1\namplitudes = [0.1]\n[frequency]\nrange = [0.1, 0.3]\n[response]\ndofs = [2]\nharmonics = [1]\n");
  folder.write("belt.toml",
        "[system]\nkind = \"belt_chain\"\nmasses = 2\nvelocity = 0.2\n[friction]\nkinetic = 0.3\nstatic = 0.5\ndecay = 2.0\nnormal = 1.0\n"
        "[motion]\nlength = 20.0\nstep = 0.1\n");
  folder.write("joint.toml", "[joint]\nlaw = \"ren\"\nparameters = [5e-8, 3.0, 1e6]\n[history]\ndisplacements = [1e-6]\n");
  EXPECT_THAT(loaded_by(folder, {"response", "response.toml"}), IsEmpty());
  EXPECT_THAT(loaded_by(folder, {"oscillate", "belt.toml"}), IsEmpty());
  EXPECT_THAT(loaded_by(folder, {"loading-curve", "joint.toml", "--csv", "curve.csv"}), IsEmpty());
  EXPECT_THAT(loaded_by(folder, {"loading-curve", "curve.csv", "--law", "ren", "--minimiser", "pattern"}), IsEmpty());
}

TEST(Modules, ThatOfTheFilesOrTheSolver) {
  const InputFolder folder;
  EXPECT_THAT(loaded_by(folder, {"info", "a.h5"}), Contains("jointid_hdf5.so"));
  use_uff(folder);
  folder.replace("A1.toml", "[identify]", "[identify]\nsolver = \"spqr\"");
  const std::vector<std::string> loaded = loaded_by(folder, {"solve", "A1.toml"});
  EXPECT_THAT(loaded, Contains("jointid_spqr.so"));
  EXPECT_THAT(loaded, Not(Contains(HasSubstr("hdf5"))));
}

}  // namespace
}  // namespace jointid::cli
