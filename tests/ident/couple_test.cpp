#include "tasks/couple.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/scene/scene_files.hpp"
#include "problems/case/coupling_problem.hpp"
#include "problems/problem.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Couple : public testing::Test {
 protected:
  CoupleScene written(const std::string& name, bool clean) const {
    return read_couple_scene(problems::write(problems::make_coupling(name), folder_, {.format = "h5", .seed = 1, .clean = clean}));
  }

  TestFolder folder_;
};

TEST_F(Couple, WritesTheFrfsOfTheAssembly) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-B");
  Control control;
  control.threads = 1;
  const tasks::CoupleResult result = tasks::couple(written("coupling-B", true), folder_ / "out.h5", false, control);
  EXPECT_EQ(result.status, Status::ok);
  EXPECT_EQ(result.result.conditions, 5u);
  EXPECT_EQ(result.unusable_lines, 0u);
  const frf::FrfSet found = frf::load(*frf::open_hdf5(folder_ / "out.h5"));
  EXPECT_EQ(found.header.response, problem.assembly.header.response);
  EXPECT_EQ(found.header.frequency_hz, problem.assembly.header.frequency_hz);
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    ASSERT_LT(std::abs(found.values[i] - problem.assembly.values[i]), 1e-9 * std::abs(problem.assembly.values[i]));
  }
  ASSERT_EQ(result.result.resonances_hz.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(result.result.resonances_hz[k], problem.assembly_modes.frequency_hz[k], 0.5);
}

/// One word for the structures of a scene serves every kind of it.
TEST(CoupleScene, TakesSubstructuresAsAnotherWordForParts) {
  const std::string rest = "[couple]\nground = [\"a.h5/1:+Y\"]\n";
  const CoupleScene scene = parse_couple_scene("[data]\nsubstructures = [\"a.h5\", \"b.h5\"]\n" + rest, "scene.toml");
  EXPECT_THAT(scene.names, ElementsAre("a.h5", "b.h5"));
  ASSERT_EQ(scene.parts.size(), 2u);
  try {
    parse_couple_scene("[data]\nsubstructures = [\"a.h5\"]\nparts = [\"b.h5\"]\n" + rest, "scene.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("there are parts, too"));
  }
}

TEST_F(Couple, BoundsAreTheFrfsWithAndWithoutDependentConditions) {
  CoupleScene scene = written("coupling-C", false);
  scene.frequency.step_hz = 1.0;
  scene.frequency.range_hz = Range{5.0, 60.0};
  const tasks::CoupleResult result = tasks::couple(scene, folder_ / "out.h5", true);
  ASSERT_TRUE(result.dependencies && result.with_all);
  EXPECT_THAT(result.dependencies->left_out(), ElementsAre(false, true, false, false, true));
  EXPECT_EQ(result.result.conditions, 3u);
  EXPECT_EQ(result.with_all->conditions, 5u);
  EXPECT_EQ(result.with_all->path, folder_ / "out.all.h5");
  EXPECT_EQ(frf::load(*frf::open_hdf5(folder_ / "out.all.h5")).header.lines(), 56u);
  // Every condition holds the assembly more.
  EXPECT_GT(result.with_all->resonances_hz.at(1), result.result.resonances_hz.at(1));
}

TEST_F(Couple, LinesThatCannotBeCoupledAreNaNAndTold) {
  problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  frf::FrfSet& part = problem.parts[1];
  part.values[part.index(3, 0, 0)] = Complex(std::nan(""), std::nan(""));
  const tasks::CoupleResult result =
      tasks::couple(read_couple_scene(problems::write(problem, folder_, {.format = "h5", .seed = 1, .clean = true})),
                    folder_ / "out.h5", false);
  EXPECT_EQ(result.status, Status::ok);
  EXPECT_EQ(result.unusable_lines, 1u);
  EXPECT_THAT(result.message, HasSubstr("1 of 341 lines"));
  const frf::FrfSet found = frf::load(*frf::open_hdf5(folder_ / "out.h5"));
  EXPECT_TRUE(std::isnan(found.values[found.index(3, 0, 0)].real()));
  EXPECT_FALSE(std::isnan(found.values[found.index(4, 0, 0)].real()));
}

TEST_F(Couple, AConditionThatFollowsFromTheStructureIsNotUsable) {
  problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  // Coordinates 6 and 7 of part three as one: the second pair with them follows from the first.
  frf::FrfSet& part = problem.parts[2];
  for (std::size_t line = 0; line < part.header.lines(); ++line) {
    for (const auto& [r, c] : {std::pair{0, 1}, {1, 0}, {1, 1}}) {
      part.values[part.index(line, static_cast<std::size_t>(r), static_cast<std::size_t>(c))] = part.values[part.index(line, 0, 0)];
    }
  }
  problem.scene = "[data]\nparts = [\"" + problem.parts[2].header.file + "\", \"" + problem.parts[0].header.file +
                  "\"]\n[couple]\nground = [\"6:+Y\", \"7:+Y\"]\njoin = [[\"1:+Y\", \"2:+Y\"]]\n";
  const fs::path file = problems::write(problem, folder_, {.format = "h5", .seed = 1, .clean = true});
  const tasks::CoupleResult result = tasks::couple(read_couple_scene(file), folder_ / "out.h5", false);
  EXPECT_EQ(result.status, Status::rank_deficient);
  EXPECT_EQ(result.unusable_lines, result.lines);
  CoupleScene fixed = read_couple_scene(file);
  fixed.options.threshold = coupling::Threshold::fixed;
  fixed.options.epsilon = 1e-6;
  const tasks::CoupleResult dropped = tasks::couple(fixed, folder_ / "out.h5", false);
  EXPECT_EQ(dropped.status, Status::ok);
  EXPECT_EQ(dropped.records[5].kept, 2u);
}

TEST_F(Couple, AnInterruptionLeavesNoFile) {
  const CoupleScene scene = written("coupling-A", true);
  Control control;
  control.interrupted = [] { return true; };
  EXPECT_THROW(tasks::couple(scene, folder_ / "out.h5", false, control), Interrupted);
  EXPECT_FALSE(fs::exists(folder_ / "out.h5"));
}

CoupleScene parse(const std::string& couple, const std::string& rest = "") {
  return parse_couple_scene("[data]\nparts = [\"a.h5\", \"b.h5\"]\n[couple]\n" + couple + "\n" + rest, "scene.toml");
}

std::string error_of(const std::string& couple, const std::string& rest = "") {
  try {
    parse(couple, rest);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(CoupleScene, IsRead) {
  const CoupleScene scene = parse(
      "join = [[\"4:+Y\", \"b.h5/4:-Y\", \"5:+Y\"]]\nground = [\"9:+RZ\"]\nremove = [\"b.h5\"]\nkeep = [\"1:+Y\"]\nmethod = \"pcc\"\n"
      "threshold = \"fixed\"\nepsilon = 0.02\nuncertainty = true\n",
      "[[couple.joint]]\ndofs = [\"1:+Y\", \"2:+Y\"]\nstiffness = { matrix = [[1.0, -1.0], [-1.0, 1.0]] }\n"
      "[noise]\nmodel = \"circular\"\nlevel = 0.01\n");
  ASSERT_EQ(scene.assembly.join.size(), 1u);
  EXPECT_EQ(scene.assembly.join[0][1].name(), "b.h5/4:-Y");
  EXPECT_EQ(scene.assembly.ground[0].dof.name(), "9:+RZ");
  EXPECT_THAT(scene.assembly.remove, ElementsAre("b.h5"));
  EXPECT_EQ(scene.assembly.keep.size(), 1u);
  EXPECT_EQ(scene.options.method, coupling::Method::pcc);
  EXPECT_EQ(scene.options.threshold, coupling::Threshold::fixed);
  EXPECT_EQ(scene.options.epsilon, 0.02);
  EXPECT_TRUE(scene.options.uncertainty);
  EXPECT_EQ(scene.options.noise->level, 0.01);
  EXPECT_THAT(scene.assembly.joints.at(0).stiffness, ElementsAre(1.0, -1.0, -1.0, 1.0));
  EXPECT_TRUE(parse("join = [[\"1:+Y\", \"2:+Y\"]]\nthreshold = \"auto\"").find_dependent);
}

TEST(CoupleScene, SaysWhatIsWrong) {
  const std::string join = "join = [[\"1:+Y\", \"2:+Y\"]]\n";
  EXPECT_THAT(error_of(""), HasSubstr("nothing is coupled"));
  EXPECT_THAT(error_of("join = [[\"1:+Y\"]]"), HasSubstr("one DOF alone joins nothing"));
  EXPECT_THAT(error_of("join = [[\"1:+Y\", \"2:+W\"]]"), HasSubstr("line 4"));
  EXPECT_THAT(error_of(join + "methode = \"grc\""), HasSubstr("did you mean method?"));
  EXPECT_THAT(error_of(join + "method = \"gcr\""), HasSubstr("[couple] method"));
  EXPECT_THAT(error_of(join + "method = \"mtc\"\nthreshold = \"fixed\""), HasSubstr("use method \"grc\" or \"pcc\""));
  EXPECT_THAT(error_of(join + "epsilon = 0.1"), HasSubstr("threshold is not \"fixed\""));
  EXPECT_THAT(error_of(join + "threshold = \"fixed\"\nepsilon = 1.5"), HasSubstr("0 < epsilon < 1"));
  EXPECT_THAT(error_of(join + "remove = [\"c.h5\"]"), HasSubstr("'c.h5' is not a valid word"));
  EXPECT_THAT(error_of(join, "[[couple.joint]]\ndofs = [\"1:+Y\"]\n"), HasSubstr("the joint has no matrix"));
  EXPECT_THAT(error_of(join, "[noise]\nmodel = \"modal\"\nlevel = 0.05\n"), HasSubstr("no law for a single FRF"));
}

/// The scene of an identification in the folder, and one that couples its parts with what it finds.
class CoupleIdentified : public testing::Test {
 protected:
  CoupleIdentified() : problem_(problems::make("A1")) {
    const fs::path scene = problems::write(problem_, folder_, {.format = "h5", .seed = 1});
    std::ifstream file(scene);
    text_.assign(std::istreambuf_iterator<char>(file), {});
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  /// The problem's scene by method "likelihood".
  std::string likelihood() const {
    std::string text = text_;
    text.replace(text.find("method = \"one\""), 14, "method = \"likelihood\"");
    const std::string weighting = "weighting = \"WA\"\n";
    return text.erase(text.find(weighting), weighting.size());
  }

  CoupleScene couple_scene(const std::string& joint) const {
    std::string parts;
    const Scene scene = parse_scene(text_, folder_ / "x.toml");
    for (const DataFile& file : scene.data.substructures) {
      parts += (parts.empty() ? "\"" : ", \"") + file.path.filename().string() + "\"";
    }
    write("couple.toml", "[data]\nparts = [" + parts + "]\n[couple]\nuncertainty = true\n[[couple.joint]]\n" + joint + "\n[noise]\n" +
                             "model = \"uniform\"\nlevel = 0.05\n");
    return read_couple_scene(folder_ / "couple.toml");
  }

  std::string error_of(const std::string& joint) const {
    try {
      tasks::couple(couple_scene(joint), folder_ / "out.h5", false);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  TestFolder folder_;
  problems::Problem problem_;
  std::string text_;
};

TEST_F(CoupleIdentified, TheJointIsFoundAndItsErrorsAreCarried) {
  write("mount.toml", likelihood());
  const CoupleScene scene = couple_scene("identified = \"mount.toml\"");
  ASSERT_EQ(scene.identified.size(), 1u);
  EXPECT_THAT(files_of(scene), testing::Contains(testing::Field(&NamedFile::path, folder_ / "mount.toml")));
  const tasks::CoupleResult result = tasks::couple(scene, folder_ / "out.h5", false);
  EXPECT_EQ(result.status, Status::ok);
  const auto source = frf::open_hdf5(folder_ / "out.h5");
  EXPECT_TRUE(source->has_covariance());
  const frf::FrfSet found = frf::load(*source);
  double inside = 0.0, count = 0.0;
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    const std::size_t line = i / found.header.entries(), r = i / found.header.reference.size() % found.header.response.size(),
                      c = i % found.header.reference.size();
    const frf::FrfSet& exact = problem_.assembly;
    const std::size_t row = frf::find_coordinate(exact.header.response, found.header.response[r]),
                      column = frf::find_coordinate(exact.header.reference, found.header.reference[c]);
    if (row == frf::npos || column == frf::npos) continue;
    const Complex error = found.values[i] - exact.values[exact.index(line, row, column)];
    inside += std::abs(error.real()) < 1.96 * std::sqrt(found.variance[i].real()) ? 0.5 : 0.0;
    inside += std::abs(error.imag()) < 1.96 * std::sqrt(found.variance[i].imag()) ? 0.5 : 0.0;
    count += 1.0;
  }
  EXPECT_GT(count, 1000.0);
  EXPECT_GT(inside / count, 0.85);  // numbers of one test depend on each other: bench_coupled_joint has the coverage
}

TEST_F(CoupleIdentified, SaysWhatItCannotDo) {
  write("mount.toml", text_);
  EXPECT_THAT(error_of("identified = \"mount.toml\""), HasSubstr("only method \"likelihood\""));
  EXPECT_THAT(error_of("identified = \"nowhere.toml\""), HasSubstr("nowhere.toml"));
  EXPECT_THAT(error_of("identified = \"mount.toml\"\nstiffness = { matrix = [[1]] }"), HasSubstr("stiffness"));
  write("mount.toml", likelihood());
  EXPECT_THAT(error_of("identified = \"mount.toml\"\ndofs = [\"1:+Y\"]"), HasSubstr("are named"));
}

TEST_F(CoupleIdentified, RefusesWhatHasNoOneMatrixOrOtherErrors) {
  const std::string identified = "identified = \"mount.toml\"";
  const auto refused = [&](const std::string& where, const std::string& added) {
    std::string text = likelihood();
    const std::size_t line = where.empty() ? text.size() : text.find('\n', text.find(where)) + 1;
    write("mount.toml", text.insert(line, added));
    return error_of(identified);
  };
  EXPECT_THAT(refused("method = ", "bounds = { \"K(1,1)\" = \"positive\" }\n"), HasSubstr("bounds and ties"));
  EXPECT_THAT(refused("[joint]", "bands = [[400, 550], [550, 1000]]\n"), HasSubstr("a joint with bands has no one matrix"));
  EXPECT_THAT(refused("", "\n[[data.gains]]\ngain = 0.01\n"), HasSubstr("gains, masses"));
  EXPECT_THAT(refused("[data]", "regenerate = [\"substructures\"]\n"), HasSubstr("[data] regenerate"));
  write("mount.toml", "[data]\nparts = [\"a.h5\"]\n[couple]\njoin = [[\"1:+Y\", \"2:+Y\"]]\n");
  EXPECT_THAT(error_of(identified), HasSubstr("mount.toml"));
}

TEST_F(CoupleIdentified, RefusesASolutionThatIsNotToBeUsed) {
  problems::Problem wrong = problem_;
  for (Complex& value : wrong.assembly.values) value = 1.0 / value;  // accelerances taken for receptances would be as far off
  problems::write(wrong, folder_, {.format = "h5", .seed = 1});
  write("mount.toml", likelihood());
  EXPECT_THAT(error_of("identified = \"mount.toml\""), HasSubstr("no usable solution"));
}

TEST_F(CoupleIdentified, NamedDofsTakeTheOrderOfTheScene) {
  write("mount.toml", likelihood());
  const Scene scene = read_scene(folder_ / "mount.toml");
  ASSERT_EQ(scene.joints.size(), 1u);
  std::string dofs;
  for (const frf::Dof& dof : scene.joints[0].dofs) dofs += (dofs.empty() ? "\"" : ", \"") + dof.name() + "\"";
  tasks::couple(couple_scene("identified = \"mount.toml\""), folder_ / "left_out.h5", false);
  tasks::couple(couple_scene("identified = \"mount.toml\"\ndofs = [" + dofs + "]"), folder_ / "named.h5", false);
  EXPECT_EQ(frf::load(*frf::open_hdf5(folder_ / "named.h5")).values, frf::load(*frf::open_hdf5(folder_ / "left_out.h5")).values);
}

}  // namespace
}  // namespace jointid::ident
