#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "base/random.hpp"
#include "frf/file/write.hpp"
#include "ident/identify.hpp"
#include "ident/newton/loose_path.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/structure/many_joints.hpp"
#include "problems/structure/modes.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

using problems::ManyJoints;

ManyJoints beams(std::size_t joints) {
  ManyJoints out = problems::chain_of_beams({.beam = {.elements = 1}, .joints = joints});
  out.references = {out.parts.front().dofs().front(), out.parts.back().dofs().back()};
  out.frequency_hz = {20.0, 60.0, 100.0};
  return out;
}

ManyJoints loosened(ManyJoints structure, const std::map<std::size_t, double>& lost) {
  for (const auto& [joint, share] : lost) {
    for (auto& row : structure.joints[joint].relative_stiffness) {
      for (double& element : row) element *= 1.0 - share;
    }
  }
  return structure;
}

/// The lowest elastic ones of the undamped structure, each with a relative error.
std::vector<double> frequencies_of(const ManyJoints& structure, std::size_t count, double error, std::uint64_t seed) {
  problems::Structure whole = structure.parts.front();
  for (std::size_t s = 1; s < structure.parts.size(); ++s) whole = merged(whole, structure.parts[s]);
  for (const problems::BeamJoint& joint : structure.joints)
    whole.add(problems::Kind::stiffness, joint.dofs, joint.over_dofs(joint.relative_stiffness));
  std::vector<double> out = modes(whole).frequency_hz;
  std::erase(out, 0.0);
  out.resize(count);
  for (std::size_t r = 0; r < count; ++r) out[r] *= 1.0 + error * normal_numbers({.seed = seed}, r)[0];
  return out;
}

template <class Rows>
std::string rows_text(const Rows& rows) {
  std::ostringstream out;
  out.precision(17);
  out << '[';
  for (std::size_t r = 0; r < rows.size(); ++r) {
    out << (r > 0 ? ", [" : "[");
    for (std::size_t c = 0; c < rows[r].size(); ++c) out << (c > 0 ? ", " : "") << rows[r][c];
    out << ']';
  }
  out << ']';
  return out.str();
}

/// Files of a scene: parts as models, FRFs of the assembly at both ends, nominal joints.
class LooseScene {
 public:
  explicit LooseScene(const ManyJoints& nominal) : nominal_(nominal) {
    for (std::size_t s = 0; s < nominal.parts.size(); ++s) write_part(s);
    frf::write(problems::assembly_receptances(nominal), folder_ / "assembly.h5");
  }

  std::string identify = "method = 'newton'\nloose = true\n";
  bool knows_damping = true;

  Scene scene(const std::vector<double>& frequencies) const {
    std::ostringstream text;
    text.precision(17);
    text << "[data]\nassembly = ['assembly.h5']\nsubstructures = [";
    for (std::size_t s = 0; s < nominal_.parts.size(); ++s) text << (s > 0 ? ", " : "") << "'part" << s << ".toml'";
    text << "]\n[identify]\n" << identify << "frequencies = [";
    for (std::size_t r = 0; r < frequencies.size(); ++r) text << (r > 0 ? ", " : "") << frequencies[r];
    text << "]\n";
    for (std::size_t e = 0; e < nominal_.joints.size(); ++e) {
      const problems::BeamJoint& joint = nominal_.joints[e];
      text << "[[joints]]\nname = 'j" << e << "'\ndofs = [";
      for (std::size_t k = 0; k < joint.dofs.size(); ++k) text << (k > 0 ? ", " : "") << '\'' << joint.dofs[k].name() << '\'';
      text << "]\nstiffness.matrix = " << rows_text(joint.over_dofs(joint.relative_stiffness)) << '\n';
      if (knows_damping) text << "hysteretic_damping.matrix = " << rows_text(joint.over_dofs(joint.relative_damping)) << '\n';
    }
    return parse_scene(text.str(), folder_ / "scene.toml");
  }

  const TestFolder& folder() const { return folder_; }

 private:
  /// Of every other part the first transducer pointed the other way.
  void write_part(std::size_t s) const {
    const problems::Structure& part = nominal_.parts[s];
    const auto sign = [&](std::size_t k) { return k == 0 && s % 2 == 1 ? -1.0 : 1.0; };
    const auto matrix = [&](problems::Kind kind) {
      problems::Matrix rows(part.size(), std::vector<double>(part.size()));
      for (std::size_t r = 0; r < part.size(); ++r) {
        for (std::size_t c = 0; c < part.size(); ++c) rows[r][c] = sign(r) * sign(c) * part.matrix(kind)[r * part.size() + c];
      }
      return rows_text(rows);
    };
    std::ofstream out(folder_ / ("part" + std::to_string(s) + ".toml"));
    out << "mass = " << matrix(problems::Kind::mass) << "\nstiffness = " << matrix(problems::Kind::stiffness)
        << "\nloss_factor = 0.004\ndofs = [";
    for (std::size_t k = 0; k < part.size(); ++k) {
      frf::Dof dof = part.dofs()[k];
      dof.sign = static_cast<int>(sign(k));
      out << (k > 0 ? ", " : "") << '"' << dof.name() << '"';
    }
    out << "]\n";
  }

  const ManyJoints& nominal_;
  TestFolder folder_;
};

Control only_estimate() {
  Control control;
  control.detail = Detail::estimates;
  return control;
}

std::vector<std::string> first_of(const Solution& found, std::size_t count) {
  std::vector<std::string> out;
  for (std::size_t k = 0; k < std::min(count, found.loose.size()); ++k) out.push_back(found.loose[k].joint);
  return out;
}

TEST(LooseByFrequencies, ThreeOfFiftyJointsAreFoundFromFortyFrequencies) {
  const ManyJoints nominal = beams(50);
  const LooseScene files(nominal);
  const std::map<std::size_t, double> lost = {{11, 0.7}, {26, 0.5}, {37, 0.8}};
  for (const double error : {1e-4, 1e-3}) {
    const auto plan = make_plan(files.scene(frequencies_of(loosened(nominal, lost), 40, error, 3)));
    const Solution found = solve(*plan, only_estimate());
    ASSERT_EQ(found.status, Status::ok) << found.message;
    EXPECT_THAT(first_of(found, 3), testing::UnorderedElementsAre("j11", "j26", "j37")) << error;
    for (std::size_t k = 0; k < 3; ++k) {
      const LooseJoint& each = found.loose[k];
      const double truth = lost.at(std::stoul(each.joint.substr(1)));
      ASSERT_TRUE(each.std_error);
      EXPECT_LT(*each.std_error, 300.0 * error * (1.0 - truth)) << each.joint;
      EXPECT_NEAR(each.lost, truth, 4.0 * *each.std_error) << each.joint;
      EXPECT_GT(each.probability, 0.99);
    }
    EXPECT_LT(found.loose[3].probability, 0.1);
    EXPECT_LT(found.loose[3].lost, 0.05);
    EXPECT_THAT(found.warnings, testing::Contains(testing::HasSubstr("with all joints sound")));
  }
}

TEST(LooseByFrequencies, ExactFrequenciesGiveTheSharesOfAShortRow) {
  const ManyJoints nominal = beams(6);
  const LooseScene files(nominal);
  const auto plan = make_plan(files.scene(frequencies_of(loosened(nominal, {{1, 0.6}, {4, 0.3}}), 10, 0.0, 1)));
  EXPECT_EQ(plan->entries_per_line, 0u);
  const Solution found = solve(*plan, only_estimate());
  ASSERT_EQ(found.loose.size(), 6u);
  for (std::size_t u = 0; u < 6; ++u) EXPECT_NEAR(found.unknowns[u].value, u == 1 ? 0.4 : u == 4 ? 0.7 : 1.0, 1e-5) << u;
}

TEST(LooseByFrequencies, SoundJointsAreCalledSound) {
  const ManyJoints nominal = beams(12);
  const LooseScene files(nominal);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Solution found = solve(*make_plan(files.scene(frequencies_of(nominal, 12, 1e-3, seed))), only_estimate());
    for (const LooseJoint& each : found.loose) EXPECT_LT(each.lost, 0.1) << seed << ' ' << each.joint;
  }
}

TEST(LooseByFrequencies, AMissingFrequencyIsDoubtful) {
  const ManyJoints nominal = beams(12);
  const LooseScene files(nominal);
  std::vector<double> frequencies = frequencies_of(loosened(nominal, {{3, 0.5}}), 13, 1e-4, 1);
  frequencies.erase(frequencies.begin() + 1);
  const Solution found = solve(*make_plan(files.scene(frequencies)), only_estimate());
  EXPECT_EQ(found.status, Status::doubtful);
  EXPECT_THAT(found.message, testing::HasSubstr("missing"));
}

TEST(LooseByFrequencies, SlopesAreThoseOfTheFrequencies) {
  SharedStiffness chain{.mass = Eigen::Vector3d(2.0, 1.0, 3.0).asDiagonal(), .stiffness = Eigen::Matrix3d::Zero(), .of_joint = {}};
  for (const auto& [a, k] : {std::pair{Eigen::Index{0}, 5.0}, std::pair{Eigen::Index{1}, 8.0}})
    chain.of_joint.push_back({{a, a, k}, {a, a + 1, -k}, {a + 1, a, -k}, {a + 1, a + 1, k}});
  const Eigen::Vector2d lost(0.2, 0.4);
  const ElasticModes found = elastic_modes(chain, lost, 2);
  for (Eigen::Index j = 0; j < 2; ++j) {
    const Eigen::Vector2d step = 1e-6 * Eigen::Vector2d::Unit(j);
    const Eigen::VectorXd slope = (elastic_modes(chain, lost + step, 2).logarithm - elastic_modes(chain, lost - step, 2).logarithm) / 2e-6;
    EXPECT_LT((slope - found.by_lost.col(j)).cwiseAbs().maxCoeff(), 1e-8);
  }
}

void expect_refused(const LooseScene& files, const std::vector<double>& frequencies, const std::string& what) {
  try {
    make_plan(files.scene(frequencies));
    ADD_FAILURE() << "no error: " << what;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(what));
    EXPECT_FALSE(error.parts().remedy.empty());
  }
}

TEST(LooseByFrequencies, WhatDoesNotGoWithThemIsRefused) {
  const ManyJoints nominal = beams(4);
  const std::vector<double> frequencies = frequencies_of(nominal, 5, 0.0, 1);
  LooseScene files(nominal);
  files.knows_damping = false;
  expect_refused(files, frequencies, "j0.D.loss");
  files.knows_damping = true;
  const std::string identify = files.identify;
  files.identify = identify + "bounds = { 'j0.K.share' = [0.0, 1.0] }\n";
  expect_refused(files, frequencies, "bounds");
  files.identify = identify + "solver = 'ceres'\n";
  expect_refused(files, frequencies, "ceres");
  files.identify = identify;
  expect_refused(files, {frequencies.front()}, "three");
}

TEST(LooseByFrequencies, AMeasuredPartIsRefused) {
  const ManyJoints nominal = beams(4);
  const LooseScene files(nominal);
  Scene scene = files.scene(frequencies_of(nominal, 5, 0.0, 1));
  scene.data.substructures.front().path = files.folder() / "part0.h5";
  frf::write(problems::part_receptances(nominal, 0), scene.data.substructures.front().path);
  try {
    make_plan(scene);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("part0.h5 is no model"));
    EXPECT_THAT(error.parts().remedy, testing::HasSubstr("mass and stiffness"));
  }
}

TEST(LooseByFrequencies, MoreFrequenciesThanModesAreRefused) {
  const ManyJoints nominal = beams(2);
  const LooseScene files(nominal);
  std::vector<double> frequencies(20);
  for (std::size_t r = 0; r < frequencies.size(); ++r) frequencies[r] = 10.0 + static_cast<double>(r);
  const auto plan = make_plan(files.scene(frequencies));
  try {
    solve(*plan, only_estimate());
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("10 elastic modes, and 20 frequencies"));
    EXPECT_EQ(error.parts().remedy, "leave the highest out");
  }
}

}  // namespace
}  // namespace jointid::ident
