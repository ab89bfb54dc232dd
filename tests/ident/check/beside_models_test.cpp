#include "ident/check/beside_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "base/error.hpp"
#include "frf/file/write.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/scene/scene_files.hpp"
#include "problems/structure/frame.hpp"
#include "problems/structure/response.hpp"
#include "tests/models/model_sample.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

using Change = std::function<void(frf::FrfSet&)>;

/// A bent bar in space on soft springs. `stiffer`: Young's modulus over that of the model.
problems::Structure bent_bar(double stiffer, double loss) {
  std::vector<frf::Node> nodes;
  const std::vector<std::array<double, 3>> at = {{0.0, 0.0, 0.0}, {0.13, 0.02, 0.0}, {0.27, 0.03, 0.05}, {0.38, 0.1, 0.09},
                                                 {0.42, 0.24, 0.1}, {0.43, 0.35, 0.2}, {0.47, 0.38, 0.33}};
  for (std::size_t k = 0; k < at.size(); ++k) nodes.push_back({static_cast<std::int64_t>(k + 1), at[k]});
  problems::Structure out = problems::frame({.diameter = 0.012, .youngs_modulus = 2.1e11 * stiffer, .density = 7850.0}, nodes);
  out.add_proportional_damping(loss);
  for (const std::int64_t end : {1, 7}) {
    for (const frf::Dof& dof : problems::frame_dofs(end)) out.add(problems::Kind::stiffness, {dof, {}}, 2e3);
  }
  return out;
}

/// FRFs of translations as a laboratory has them: 2 % noise, resonances that differ from the model's.
frf::FrfSet measured_bar(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<frf::Dof> responses;
  for (std::int64_t node = 1; node <= 7; ++node) {
    const std::vector<frf::Dof> all = problems::frame_dofs(node);
    responses.insert(responses.end(), all.begin(), all.begin() + 3);
  }
  const std::vector<frf::Dof> references = {frf::Dof::parse("1:+Z"), frf::Dof::parse("4:+Y"), frf::Dof::parse("7:+X")};
  std::vector<double> hz;
  for (double f = 30.0; f <= 1500.0; f += 5.0) hz.push_back(f);
  const double stiffer = 1.0 + 0.06 * std::clamp(normal(random), -1.5, 1.5);
  frf::FrfSet set = problems::frequency_response(bent_bar(stiffer, 0.01), {responses, references, hz, 0.0});
  for (Complex& h : set.values) h *= Complex(1.0 + 0.02 * normal(random), 0.02 * normal(random));
  return set;
}


CheckResult checked(frf::FrfSet set) {
  const TestFolder folder;
  const problems::Structure model = bent_bar(1.0, 0.006);
  models::write_market(folder / "M.mtx", models::sparse_matrix(model, problems::Kind::mass));
  models::write_market(folder / "K.mtx", models::sparse_matrix(model, problems::Kind::stiffness));
  models::write_text(folder / "bar.toml",
                     "mass = \"M.mtx\"\nstiffness = \"K.mtx\"\nloss_factor = 0.006\ndofs = " + models::dof_list(model.dofs()) + "\n");
  frf::write(set, folder / "bar.h5");
  const std::string scene =
      "[data]\nsubstructures = [\"bar.h5\"]\nassembly = [\"asm.h5\"]\n[data.files.\"bar.h5\"]\nmodel = \"bar.toml\"\n"
      "[joint]\ndofs = [\"7:+X\"]\n[joint.stiffness]\npattern = \"full\"\n";
  CheckResult result;
  check_beside_models(parse_scene(scene, folder / "scene.toml"), {}, result);
  return result;
}

void exchange_rows(frf::FrfSet& set, const char* one, const char* other) {
  const std::size_t a = frf::find_coordinate(set.header.response, frf::Dof::parse(one)),
                    b = frf::find_coordinate(set.header.response, frf::Dof::parse(other));
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t c = 0; c < set.header.reference.size(); ++c) {
      std::swap(set.values[set.index(line, a, c)], set.values[set.index(line, b, c)]);
    }
  }
}

void scale_row(frf::FrfSet& set, const char* dof, double factor) {
  const std::size_t row = frf::find_coordinate(set.header.response, frf::Dof::parse(dof));
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t c = 0; c < set.header.reference.size(); ++c) set.values[set.index(line, row, c)] *= factor;
  }
}

/// How many of `seeds` name this, and nothing else, after a change.
std::size_t named(std::size_t seeds, const Change& change, SuspectKind kind, const std::vector<std::string>& dofs) {
  std::size_t right = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    frf::FrfSet set = measured_bar(seed);
    change(set);
    const CheckResult found = checked(std::move(set));
    std::vector<std::string> told;
    bool same_kind = !found.suspects.empty();
    for (const Suspect& suspect : found.suspects) {
      same_kind = same_kind && suspect.kind == kind;
      for (const frf::Dof& dof : suspect.dofs) told.push_back(dof.name());
    }
    std::ranges::sort(told);
    right += same_kind && told == dofs;
  }
  return right;
}

constexpr std::size_t seeds = 10;

TEST(BesideModels, AModelThatIsSomePercentOffAccusesNobody) {
  for (std::uint64_t seed = 1; seed <= 4 * seeds; ++seed) {
    const CheckResult found = checked(measured_bar(seed));
    EXPECT_TRUE(found.suspects.empty()) << seed << ": " << found.suspects.front().evidence;
    EXPECT_EQ(found.verdict, Verdict::clean);
    ASSERT_EQ(found.notes.size(), 1U);
    EXPECT_NE(found.notes[0].find("bar.h5 beside the model bar.toml"), std::string::npos);
  }
}

/// As a hand-held test has them: few sensors of one direction, one hammer point.
frf::FrfSet with_few(const frf::FrfSet& all, const std::vector<const char*>& sensors, std::size_t reference) {
  frf::FrfSet out = all;
  out.header.response.clear();
  out.header.reference = {all.header.reference[reference]};
  out.values.clear();
  for (std::size_t line = 0; line < all.header.lines(); ++line) {
    for (const char* dof : sensors) {
      out.values.push_back(all.values[all.index(line, frf::find_coordinate(all.header.response, frf::Dof::parse(dof)), reference)]);
    }
  }
  for (const char* dof : sensors) out.header.response.push_back(frf::Dof::parse(dof));
  return out;
}

TEST(BesideModels, FewSensorsAccuseNobody) {
  for (std::uint64_t seed = 1; seed <= 2 * seeds; ++seed) {
    for (std::size_t reference = 0; reference < 3; ++reference) {
      const CheckResult found = checked(with_few(measured_bar(seed), {"2:+Y", "3:+Z", "5:+X", "6:+Z"}, reference));
      EXPECT_TRUE(found.suspects.empty()) << seed << " " << reference << ": " << found.suspects.front().evidence;
    }
  }
}

TEST(BesideModels, ASensorTheOtherWayRound) {
  EXPECT_EQ(named(seeds, [](frf::FrfSet& set) { scale_row(set, "5:+Y", -1.0); }, SuspectKind::sign, {"5:+Y"}), seeds);
}

TEST(BesideModels, AHammerTheOtherWayRound) {
  const auto turn = [](frf::FrfSet& set) {
    for (std::size_t line = 0; line < set.header.lines(); ++line) {
      for (std::size_t r = 0; r < set.header.response.size(); ++r) set.values[set.index(line, r, 1)] *= -1.0;
    }
  };
  EXPECT_EQ(named(seeds, turn, SuspectKind::sign, {"4:+Y"}), seeds);
}

TEST(BesideModels, ASensorOfTwiceTheGain) {
  EXPECT_EQ(named(seeds, [](frf::FrfSet& set) { scale_row(set, "3:+Z", 2.0); }, SuspectKind::gain, {"3:+Z"}), seeds);
}

TEST(BesideModels, LabelsOfTwoSensorsExchanged) {
  const auto exchange = [](frf::FrfSet& set) { exchange_rows(set, "2:+Y", "6:+Z"); };
  EXPECT_GE(named(seeds, exchange, SuspectKind::label, {"2:+Y", "6:+Z"}), seeds - 1);
}

TEST(BesideModels, DirectionsOfOneNodeExchanged) {
  const auto exchange = [](frf::FrfSet& set) { exchange_rows(set, "5:+X", "5:+Z"); };
  EXPECT_GE(named(seeds, exchange, SuspectKind::direction, {"5:+X", "5:+Z"}), seeds - 1);
}

TEST(BesideModels, GTakenForMetresPerSecondSquared) {
  const auto in_g = [](frf::FrfSet& set) {
    for (Complex& h : set.values) h /= 9.80665;
  };
  EXPECT_EQ(named(seeds, in_g, SuspectKind::unit, {}), seeds);
  frf::FrfSet set = measured_bar(1);
  in_g(set);
  const CheckResult found = checked(std::move(set));
  EXPECT_NE(found.suspects[0].evidence.find("g in place of m/s²"), std::string::npos) << found.suspects[0].evidence;
  EXPECT_NE(found.suspects[0].remedy.find("gain = 9.80665"), std::string::npos) << found.suspects[0].remedy;
}

TEST(BesideModels, AMobilityTakenForAReceptance) {
  const auto mobility = [](frf::FrfSet& set) {
    for (std::size_t i = 0; i < set.values.size(); ++i) {
      const std::size_t line = i / (set.header.response.size() * set.header.reference.size());
      set.values[i] *= Complex(0.0, 2.0 * std::numbers::pi * set.header.frequency_hz[line]);
    }
  };
  EXPECT_EQ(named(seeds, mobility, SuspectKind::quantity, {}), seeds);
}

TEST(BesideModels, MistakesOfTheKeyAreRefused) {
  const auto refused = [](const std::string& files, const std::string& part = "a.h5") -> std::string {
    try {
      parse_scene("[data]\nsubstructures = [\"" + part + "\"]\nassembly = [\"b.h5\"]\n" + files +
                      "[joint]\ndofs = [\"7:+X\"]\n[joint.stiffness]\npattern = \"full\"\n",
                  "scene.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refused("[data.files.\"a.h5\"]\nmodel = \"a.mtx\"\n").find("no description of a model"), std::string::npos);
  EXPECT_NE(refused("[data.files.\"a.toml\"]\nmodel = \"c.toml\"\n", "a.toml").find("a model itself"), std::string::npos);
  EXPECT_EQ(refused("[data.files.\"a.h5\"]\nmodel = \"a.toml\"\n"), "");
}

}  // namespace
}  // namespace jointid::ident
