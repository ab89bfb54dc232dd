#include "tasks/correlate/compared_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "correlation/correlated_frfs.hpp"
#include "frf/file/write.hpp"
#include "problems/structure/response.hpp"
#include "tests/models/model_sample.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

/// A beam as the description of a model, and its FRFs at some DOFs and lines.
class ComparedFiles : public testing::Test {
 protected:
  ComparedFiles() : beam_(models::fine_beam(6)) {
    models::write_market(folder_ / "M.mtx", models::sparse_matrix(beam_, problems::Kind::mass));
    models::write_market(folder_ / "K.mtx", models::sparse_matrix(beam_, problems::Kind::stiffness));
    models::write_text(folder_ / "beam.toml", "mass = \"M.mtx\"\nstiffness = \"K.mtx\"\nloss_factor = 0.01\ndofs = " +
                                                  models::dof_list(beam_.dofs()) + "\n");
    frf::write(frfs({"1:+Y", "3:-Y", "7:+Y"}, {"1:+Y", "7:+Y"}), folder_ / "measured.h5");
  }

  frf::FrfSet frfs(const std::vector<const char*>& responses, const std::vector<const char*>& references) const {
    const auto dofs = [](const std::vector<const char*>& names) {
      std::vector<frf::Dof> out;
      for (const char* name : names) out.push_back(frf::Dof::parse(name));
      return out;
    };
    return problems::frequency_response(beam_, {dofs(responses), dofs(references), {150.0, 300.0, 777.0, 2500.0}, 0.0});
  }

  problems::Structure beam_;
  TestFolder folder_;
};

TEST_F(ComparedFiles, AModelHasTheLinesOfTheOther) {
  for (const bool first : {false, true}) {
    const auto [one, other, notes] = first ? read_compared(folder_ / "beam.toml", folder_ / "measured.h5")
                                           : read_compared(folder_ / "measured.h5", folder_ / "beam.toml");
    const correlation::CorrelatedFrfs found = correlation::correlate(one, other);
    ASSERT_EQ(found.frfs.size(), 6U);
    for (const correlation::FrfAgreement& each : found.frfs) {
      EXPECT_EQ(each.lines, 4U);
      EXPECT_NEAR(each.frac, 1.0, 1e-9);
      EXPECT_NEAR(each.lac, 1.0, 1e-9);
    }
  }
}

TEST_F(ComparedFiles, AModelIsTheParentOfAnExpansion) {
  std::vector<const char*> names = {"1:+Y", "2:+Y", "3:+Y", "4:+Y", "5:+Y", "6:+Y", "7:+Y"};
  frf::write(frfs(names, names), folder_ / "parent.h5");
  frf::FrfSet measured = frfs({"1:+Y", "3:+Y", "7:+Y"}, {"1:+Y", "3:+Y", "7:+Y"});
  for (Complex& h : measured.values) h *= 1.05;
  frf::write(measured, folder_ / "square.h5");
  const frf::FrfSet by_frfs = expanded_files(folder_ / "parent.h5", folder_ / "square.h5", "semm", 0).expanded.set,
                    by_model = expanded_files(folder_ / "beam.toml", folder_ / "square.h5", "semm", 0).expanded.set;
  for (const char* response : names) {
    const frf::Dof at = frf::Dof::parse(response), from = frf::Dof::parse("2:+Y");
    const std::size_t r = frf::find_coordinate(by_frfs.header.response, at),
                      c = frf::find_coordinate(by_frfs.header.reference, from),
                      r_model = frf::find_coordinate(by_model.header.response, at),
                      c_model = frf::find_coordinate(by_model.header.reference, from);
    ASSERT_NE(r_model, frf::npos);
    ASSERT_NE(c_model, frf::npos);
    for (std::size_t line = 0; line < 4; ++line) {
      const Complex expected = by_frfs.values[by_frfs.index(line, r, c)];
      EXPECT_LT(std::abs(by_model.values[by_model.index(line, r_model, c_model)] - expected), 1e-7 * std::abs(expected));
    }
  }
}

TEST_F(ComparedFiles, ConjugatesAreNamed) {
  frf::FrfSet square = frfs({"1:+Y", "3:+Y", "7:+Y"}, {"1:+Y", "3:+Y", "7:+Y"});
  frf::write(square, folder_ / "right.h5");
  for (Complex& h : square.values) h = std::conj(h);
  frf::write(square, folder_ / "turned.h5");
  EXPECT_TRUE(read_compared(folder_ / "right.h5", folder_ / "beam.toml").notes.empty());
  const auto turned = testing::ElementsAre(testing::StartsWith("turned.h5: "));
  EXPECT_THAT(read_compared(folder_ / "right.h5", folder_ / "turned.h5").notes, turned);
  EXPECT_THAT(read_compared(folder_ / "beam.toml", folder_ / "turned.h5").notes, turned);
  EXPECT_THAT(expanded_files(folder_ / "beam.toml", folder_ / "turned.h5", "semm", 0).notes, turned);
  EXPECT_THAT(expanded_files(folder_ / "turned.h5", folder_ / "right.h5", "semm", 0).notes, turned);
}

TEST_F(ComparedFiles, TwoModelsHaveNoLines) {
  EXPECT_THROW(read_compared(folder_ / "beam.toml", folder_ / "beam.toml"), InputError);
}

TEST_F(ComparedFiles, WhatADescriptionNamesIsAnInput) {
  std::vector<std::string> names;
  for (const ident::NamedFile& file : compared_inputs(folder_ / "beam.toml", "ONE"))
    names.push_back(file.path.filename().string());
  EXPECT_EQ(names, (std::vector<std::string>{"beam.toml", "M.mtx", "K.mtx"}));
  EXPECT_EQ(compared_inputs(folder_ / "measured.h5", "ONE").size(), 1U);
}

}  // namespace
}  // namespace jointid::tasks
