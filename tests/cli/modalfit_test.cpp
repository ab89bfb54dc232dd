#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "cli/modalfit/modalfit_arguments.hpp"
#include "frf/uff/uff55.hpp"
#include "problems/case/modal_set.hpp"
#include "report/modalfit/modal_text.hpp"
#include "tests/test_folder.hpp"

namespace jointid::cli {
namespace {

namespace fs = std::filesystem;
class Modalfit : public testing::Test {
 protected:
  void SetUp() override {
    file_ = problems::write(problems::make_modal_set("modes-pair"), folder_, {});
  }

  tasks::ModalRun run(modalfit::ModelKind kind) const {
    modalfit::FitOptions options;
    options.kind = kind;
    options.range_hz = {95.0, 106.0};
    return tasks::run_modal_files({file_}, {}, options);
  }

  TestFolder folder_;
  fs::path file_;
};

/// Poles and residues of dataset 55 by its own conventions against the FRFs of the set, a few bandwidths off resonance (six digits of λ
/// are few at resonance).
TEST_F(Modalfit, ShapesInUff55GiveTheFrfs) {
  const auto set = problems::make_modal_set("modes-pair");
  for (const auto damping : {modalfit::Damping::viscous, modalfit::Damping::hysteretic}) {
    for (const bool real : {false, true}) {
      write_shapes(run({damping, real}), folder_ / "shapes.uff");
      const auto modes = frf::read_uff55(folder_ / "shapes.uff");
      ASSERT_EQ(modes.size(), 2u);
      const std::size_t line = 525;  // 100.5 Hz
      const Complex s(0.0, 2.0 * std::numbers::pi * set.clean.header.frequency_hz[line]);
      Complex h = 0.0;
      for (const frf::Uff55Mode& mode : modes) {
        const Complex product = mode.shape[5] * mode.shape[2];  // 2:+Z and 1:+Z
        if (!mode.is_complex) {
          const double w = 2.0 * std::numbers::pi * mode.frequency_hz;
          h += product / mode.modal_mass / (w * w * Complex(1.0, mode.hysteretic_damping) + s * s + 2.0 * mode.viscous_damping * w * s);
          continue;
        }
        const Complex residue = product / mode.modal_a, lambda = mode.eigenvalue;
        const bool viscous = damping == modalfit::Damping::viscous;
        h += residue / (s - lambda) + (viscous ? std::conj(residue) / (s - std::conj(lambda)) : -residue / (s + lambda));
        EXPECT_LT(std::abs(mode.modal_b + lambda * mode.modal_a), 1e-4 * std::abs(mode.modal_b));
      }
      const Complex exact = set.clean.values[set.clean.index(line, 1, 0)];
      EXPECT_LT(std::abs(h - exact), 0.01 * std::abs(exact)) << modalfit::name(damping) << " real " << real;
    }
  }
}

TEST_F(Modalfit, ModesAtTheEdgeOfTheRangeAreNamed) {
  EXPECT_THAT(report::notes(run({})), testing::Not(testing::Contains(testing::HasSubstr("edge"))));
  modalfit::FitOptions options;
  options.range_hz = {99.97, 106.0};  // lines 0.02 Hz apart
  EXPECT_THAT(report::notes(tasks::run_modal_files({file_}, {}, options)), testing::Contains(testing::HasSubstr("from those beyond: 100 Hz")));
}

TEST_F(Modalfit, JsonHasModesAndErrors) {
  const auto json = nlohmann::json::parse(report::modal_json(run({modalfit::Damping::hysteretic, true})));
  EXPECT_EQ(json["status"], "ok");
  ASSERT_EQ(json["modes"].size(), 2u);
  EXPECT_NEAR(json["modes"][1]["frequency_hz"].get<double>(), 101.0, 1e-3);
  EXPECT_EQ(json["modes"][0]["shape"].size(), 4u);
  EXPECT_NEAR(json["mac"][0][0].get<double>(), 1.0, 1e-12);
  EXPECT_LT(json["fit"]["synthesis_symmetric"]["rms_db"].get<double>(), 0.2);
  EXPECT_EQ(json["frfs"].size(), 8u);
  EXPECT_FALSE(json["stabilisation"].empty());
}

/// Given poles are refined to those that a search finds, none added or left out; one alone stays alone.
TEST_F(Modalfit, GivenPolesAreRefinedAndNoneIsSought) {
  const tasks::ModalRun sought = run({});
  modalfit::FitOptions options;
  options.range_hz = {95.0, 106.0};
  options.poles = parse_poles({"99.99:0.0012", "101.01:0.0009"});
  const tasks::ModalRun given = tasks::run_modal_files({file_}, {}, options);
  ASSERT_EQ(given.fit.modes.size(), 2u);
  EXPECT_TRUE(given.fit.stabilisation.empty());
  for (std::size_t r = 0; r < 2; ++r) {
    const modalfit::Mode &a = sought.fit.modes[r], &b = given.fit.modes[r];
    EXPECT_NEAR(b.pole.frequency_hz, a.pole.frequency_hz, 0.2 * a.frequency_deviation_hz);
    EXPECT_NEAR(b.pole.damping, a.pole.damping, 0.2 * a.damping_deviation);
  }
  options.poles->resize(1);
  EXPECT_EQ(tasks::run_modal_files({file_}, {}, options).fit.modes.size(), 1u);
}

TEST(ModalfitArguments, PolesAreFrequenciesAndDampings) {
  const auto poles = parse_poles({"51.5:0.001", "1e3:2e-3"});
  ASSERT_EQ(poles.size(), 2u);
  EXPECT_EQ(poles[1].frequency_hz, 1000.0);
  EXPECT_EQ(poles[1].damping, 0.002);
  for (const char* wrong : {"51", "51:", ":0.1", "a:0.1", "51:0.1:2", "-5:0.1", "51:0", "nan:1"}) {
    EXPECT_THROW(parse_poles({wrong}), InputError) << wrong;
  }
}

TEST(ModalfitArguments, RangesAreTwoFrequencies) {
  EXPECT_EQ(parse_range("400:1000"), (std::array{400.0, 1000.0}));
  EXPECT_EQ(parse_range(":1000")[0], 0.0);
  EXPECT_GT(parse_range("400:")[1], 1e300);
  for (const char* wrong : {"400", "a:b", "5:4", "-5:4", "1:2:3", "nan:5"}) EXPECT_THROW(parse_range(wrong), InputError) << wrong;
}

}  // namespace
}  // namespace jointid::cli
