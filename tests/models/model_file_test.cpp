#include "models/model_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "frf/hdf5/table_file.hpp"
#include "frf/uff/uff55.hpp"
#include "problems/structure/modes.hpp"
#include "tests/models/model_sample.hpp"
#include "tests/test_folder.hpp"

namespace jointid::models {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<double> lines = {100.0, 450.0, 900.0};

class ModelFile : public testing::Test {
 protected:
  ModelFile() {
    write_market(folder_ / "m.mtx", sparse_matrix(part_, problems::Kind::mass));
    write_market(folder_ / "k.mtx", sparse_matrix(part_, problems::Kind::stiffness));
  }

  std::filesystem::path written(const std::string& text) const {
    write_text(folder_ / "model.toml", text);
    return folder_ / "model.toml";
  }

  std::string matrices(const std::string& more) const {
    return "mass = \"m.mtx\"\nstiffness = \"k.mtx\"\nloss_factor = 0.001\n" + more;
  }

  std::string error_of(const std::string& text) const {
    try {
      read_model(written(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  void write_table(const std::string& name, const std::vector<std::string>& columns, const std::vector<double>& rows) const {
    frf::TableHeader header;
    for (const std::string& column : columns) header.columns.push_back({column, "", 0.0});
    frf::TableWriter writer(folder_ / name, header, rows.size() / columns.size());
    writer.append(rows);
    writer.finish();
  }

  /// Largest difference from the FRFs of the structure over their largest.
  double error(const std::string& text, const problems::Structure& structure) const {
    const auto source = open_model(written(text), lines);
    const frf::FrfSet found = frf::load(*source);
    const frf::FrfSet expected =
        problems::frequency_response(structure, {found.header.response, found.header.reference, lines, 0.0});
    double largest = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < found.values.size(); ++i) {
      largest = std::max(largest, std::abs(expected.values[i]));
      worst = std::max(worst, std::abs(found.values[i] - expected.values[i]));
    }
    return worst / largest;
  }

  TestFolder folder_;
  problems::Structure part_ = problems::substructure_b();
};

TEST_F(ModelFile, NamesItsCoordinatesInAnyOfItsWays) {
  const std::string names = dof_list(part_.dofs());
  EXPECT_LE(error(matrices("dofs = " + names), part_), 1e-12);
  EXPECT_LE(error(matrices("dofs = { \"6:+RZ\" = 4, \"5:+Y\" = 1 }"), part_), 1e-12);
  write_text(folder_ / "rows.txt", "# of the mesh\n5:+Y\n-\n6:+Y\n6:+RZ # middle\n\n7:+Y\n-\n");
  EXPECT_LE(error(matrices("dofs = \"rows.txt\""), part_), 1e-12);
  EXPECT_THAT(frf::names(read_model(folder_ / "model.toml").coordinates.dofs), ElementsAre("5:+Y", "6:+Y", "6:+RZ", "7:+Y"));
  write_text(folder_ / "some.txt", "3 6:+Y\n1 5:+Y\n");
  EXPECT_LE(error(matrices("dofs = \"some.txt\""), part_), 1e-12);
  EXPECT_LE(error(matrices("dofs = " + names + "\nkeep = [\"7:+RZ\", \"5:+Y\"]"), part_), 1e-12);
  EXPECT_THAT(frf::names(read_model(folder_ / "model.toml").coordinates.dofs), ElementsAre("7:+RZ", "5:+Y"));
}

TEST_F(ModelFile, ReadsMatricesAndNamesOfHdf5) {
  write_table("m.h5", frf::names(part_.dofs()), part_.matrix(problems::Kind::mass));
  write_table("k.h5", frf::names(part_.dofs()), part_.matrix(problems::Kind::stiffness));
  EXPECT_LE(error("mass = \"m.h5:rows\"\nstiffness = \"k.h5:rows\"\nloss_factor = 0.001\ndofs = \"m.h5:column\"", part_), 1e-12);
  EXPECT_THAT(files_of_model(folder_ / "model.toml"), ElementsAre(folder_ / "m.h5", folder_ / "k.h5", folder_ / "m.h5"));
}

TEST_F(ModelFile, ReadsModesOfHdf5) {
  const problems::Modes modes = problems::modes(part_);
  const auto numbered = [](std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) names.push_back(std::to_string(i));
    return names;
  };
  write_table("phi.h5", numbered(modes.count()), modes.shapes);  // square, coordinates first
  write_table("f.h5", {"f"}, modes.frequency_hz);
  EXPECT_LE(error("shapes = \"phi.h5:rows\"\nfrequencies = \"f.h5:rows\"\nloss_factor = 0.001\ndofs = " + dof_list(part_.dofs()),
                  part_),
            1e-9);
  // A residual is added to what the modes give, divided by 1 + iη.
  std::vector<double> flexibility(modes.count() * modes.count(), 0.0);
  flexibility[0] = 1e-7;
  write_table("r.h5", numbered(modes.count()), flexibility);
  const std::string with =
      "shapes = \"phi.h5:rows\"\nfrequencies = \"f.h5:rows\"\nloss_factor = 0.001\ndofs = " + dof_list(part_.dofs());
  const frf::FrfSet plain = frf::load(*open_model(written(with), lines));
  const frf::FrfSet more = frf::load(*open_model(written(with + "\nresidual_flexibility = \"r.h5:rows\""), lines));
  for (std::size_t i = 0; i < plain.values.size(); ++i) {
    const Complex expected = i % plain.header.entries() == 0 ? 1e-7 / Complex(1.0, 0.001) : Complex(0.0);
    EXPECT_LT(std::abs(more.values[i] - plain.values[i] - expected), 1e-12 * std::abs(plain.values[i]) + 1e-20) << i;
  }
  EXPECT_THAT(error_of("shapes = \"phi.h5:rows\"\nfrequencies = \"phi.h5:rows\"\ndofs = [\"1:+X\"]"),
              HasSubstr("give one number for each mode"));
  EXPECT_THAT(error_of("shapes = \"phi.h5:x\"\nfrequencies = \"f.h5:rows\"\ndofs = [\"1:+X\"]"), HasSubstr("there are "));
}

TEST_F(ModelFile, ReadsModesOfUniversalFiles) {
  const problems::Modes modes = problems::modes(part_);
  std::vector<frf::Uff55Mode> file;
  for (std::size_t k = 0; k < modes.count(); ++k) {
    frf::Uff55Mode mode;
    mode.number = static_cast<int>(k + 1);
    mode.frequency_hz = modes.frequency_hz[k];
    mode.modal_mass = 4.0;  // of shapes twice as large
    mode.hysteretic_damping = modes.loss_factor[k];
    mode.dofs = modes.dofs;
    for (std::size_t i = 0; i < modes.dofs.size(); ++i) mode.shape.emplace_back(2.0 * modes.shapes[i * modes.count() + k]);
    file.push_back(mode);
  }
  frf::write_uff55(file, part_.nodes(), folder_ / "modes.uff");
  EXPECT_LE(error("modes = \"modes.uff\"", part_), 1e-3);  // six digits in the file
  const NamedModel found = read_model(folder_ / "model.toml");
  EXPECT_THAT(frf::names(found.coordinates.dofs), ElementsAre("5:+Y", "5:+RZ", "6:+Y", "6:+RZ", "7:+Y", "7:+RZ"));
  EXPECT_EQ(found.nodes.size(), 3u);
  file[1].modal_mass = 0.0;
  frf::write_uff55(file, {}, folder_ / "modes.uff");
  EXPECT_THAT(error_of("modes = \"modes.uff\""), HasSubstr("its modal mass is 0"));
}

/// Two DOFs of a node; `data` and `values` of record 6, shape as the format has it.
std::string mode_55(int specific, int data, int values, const std::string& shape, const std::string& mass = "  2.00000E-03") {
  const std::string numbers = "  5.00000E+01" + mass + "  2.00000E-02  0.00000E+00\n";
  return "    -1\n    55\nmode\nNONE\nNONE\nNONE\nNONE\n         1         2         " + std::to_string(values == 6 ? 3 : 2) +
         (specific < 10 ? "         " : "        ") + std::to_string(specific) + "         " + std::to_string(data) + "         " +
         std::to_string(values) + "\n         2         4         1         1\n" + numbers + "         1\n" + shape + "    -1\n";
}

TEST_F(ModelFile, RefusesModesThatItDoesNotUnderstand) {
  const auto refused = [&](const std::string& text) {
    write_text(folder_ / "modes.uff", text);
    return error_of("modes = \"modes.uff\"");
  };
  const std::string real = "  0.00000E+00  0.00000E+00  1.00000E+00\n", good = mode_55(8, 2, 3, real);
  EXPECT_THAT(refused(mode_55(11, 2, 3, real)), HasSubstr("mode 1: its shape is one of velocities"));
  EXPECT_THAT(refused(mode_55(12, 2, 3, real)),
              testing::AllOf(HasSubstr("its shape is one of accelerations"), HasSubstr("shapes of displacements")));
  const std::string turned = "  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  1.00000E+00  1.00000E-01\n";
  EXPECT_THAT(refused(mode_55(8, 5, 3, turned)), HasSubstr("it is a normal mode, and its shape is complex"));
  EXPECT_THAT(refused(good + mode_55(8, 2, 1, "  1.00000E+00\n")), HasSubstr("a mode shape of 1 values per node"));
}

TEST_F(ModelFile, ModalMassesAreInTheUnitsOfDataset164) {
  const std::string real = "  0.00000E+00  0.00000E+00  1.00000E+00\n";
  const std::string units = "    -1\n   164\n        10mm (newton)                  2\n"
                            "  1.00000000000000000D+03  1.00000000000000000D+00  1.00000000000000000D+00\n"
                            "  2.73150000000000000D+02\n    -1\n";
  const auto largest = [&](const std::string& text) {
    write_text(folder_ / "modes.uff", text);
    return std::abs(frf::load(*open_model(written("modes = \"modes.uff\""), {40.0})).values.front());
  };
  const double in_tonnes = largest(units + mode_55(8, 2, 3, real)), in_kg = largest(mode_55(8, 2, 3, real, "  2.00000E+00"));
  EXPECT_NEAR(in_tonnes, in_kg, 1e-12 * in_kg);
}

TEST_F(ModelFile, SaysWhatIsWrong) {
  const std::string names = "dofs = " + dof_list(part_.dofs());
  EXPECT_THAT(error_of("loss_factor = 0.1"), HasSubstr("it describes no model"));
  EXPECT_THAT(error_of(matrices("")), HasSubstr("dofs"));
  EXPECT_THAT(error_of(matrices("modes = \"x.uff\"")), HasSubstr("both mass and modes"));
  EXPECT_THAT(error_of(matrices("los_factor = 1\n" + names)), HasSubstr("loss_factor"));
  EXPECT_THAT(error_of(matrices("dofs = [\"5:+Y\"]")), HasSubstr("1 names of 6 coordinates"));
  EXPECT_THAT(error_of(matrices("dofs = { \"5:+Y\" = 7 }")), HasSubstr("row 7, the model has 6"));
  EXPECT_THAT(error_of(matrices("dofs = { \"5:+Y\" = 1, \"5:-Y\" = 2 }")), HasSubstr("named twice"));
  EXPECT_THAT(error_of(matrices("dofs = { \"5:+Y\" = 1, \"6:+Y\" = 1 }")), HasSubstr("row 1 has two names"));
  EXPECT_THAT(error_of(matrices("dofs = [\"-\",\"-\",\"-\",\"-\",\"-\",\"-\"]")), HasSubstr("no coordinate has a name"));
  EXPECT_THAT(error_of(matrices(names + "\nkeep = [\"5:+X\"]")), HasSubstr("the model has no '5:+X'"));
  EXPECT_THAT(error_of(matrices(names + "\nnoise = 1.0")), HasSubstr("not below 1"));
  EXPECT_THAT(error_of("mass = \"m.mtx\"\nstiffness = \"k.mtx\"\nloss_factor = -0.01\n" + names), HasSubstr("loss_factor"));
  EXPECT_THAT(error_of("mass = [[1.0]]\nstiffness = \"k.mtx\"\n" + names), HasSubstr("6 rows, the mass matrix 1"));
  EXPECT_THAT(error_of("mass = [[1.0, 0.0], [0.0, 1.0]]\nstiffness = [[1.0, 0.5], [0.0, 1.0]]\n" + names),
              HasSubstr("not symmetric"));
}

}  // namespace
}  // namespace jointid::models
