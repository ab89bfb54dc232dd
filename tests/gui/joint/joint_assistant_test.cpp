#include "gui/joint/joint_assistant.hpp"

#include <gmock/gmock.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QTest>
#include <QTreeWidget>

#include "gui/scene/scene_check.hpp"
#include "gui/scene/scene_edit.hpp"
#include "../widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Translations and a rotation at some nodes.
frf::FrfHeader part(const char* file, const std::vector<std::int64_t>& nodes, const std::vector<frf::Node>& places) {
  frf::FrfHeader made;
  made.file = file;
  made.frequency_hz = {10.0};
  for (const std::int64_t node : nodes) {
    for (const auto direction : {frf::Direction::x, frf::Direction::z, frf::Direction::ry})
      made.response.push_back({.node = node, .direction = direction});
  }
  made.reference = made.response;
  made.nodes = places;
  return made;
}

/// Two plates on two bolts, and a pair that is farther apart.
struct Plates {
  JointAssistant assistant{{part("/d/low.uff", {1, 2, 3}, {{1, {0, 0, 0}}, {2, {1, 0, 0}}, {3, {2, 0, 0}}}),
                            part("/d/up.uff", {11, 12, 13}, {{11, {0, 0, 0.01}}, {12, {1, 0, 0.01}}, {13, {2, 0, 0.4}}})}};

  Plates() {
    assistant.show();
    assistant.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&assistant));
  }
  QString text(const char* button) { return find<QRadioButton>(assistant, button)->text(); }
  bool may_accept() { return find<QDialogButtonBox>(assistant, "joint_buttons")->button(QDialogButtonBox::Ok)->isEnabled(); }
};

TEST(JointAssistant, ProposesTheNearPairsAndCountsUnknowns) {
  Plates plates;
  EXPECT_EQ(plates.assistant.pairs()->topLevelItemCount(), 3);
  EXPECT_EQ(plates.assistant.joint().pairs.size(), 2U);
  EXPECT_THAT(plates.text("joint_springs").toStdString(), HasSubstr(": 12 unknown"));
  EXPECT_THAT(plates.text("joint_equal").toStdString(), HasSubstr(": 6 unknown"));
  EXPECT_THAT(plates.text("joint_full").toStdString(), HasSubstr(": 156 unknown"));
  EXPECT_TRUE(find<QCheckBox>(plates.assistant, "joint_ry")->isVisible());
  EXPECT_FALSE(find<QCheckBox>(plates.assistant, "joint_y")->isVisible());
}

TEST(JointAssistant, PairsAndDirectionsAreTickedByKeys) {
  Plates plates;
  EXPECT_TRUE(plates.assistant.pairs()->hasFocus());
  QTest::keyClick(plates.assistant.pairs(), Qt::Key_Space);
  QTest::keyClick(find(plates.assistant, "joint_ry"), Qt::Key_Space);
  QTest::keyClick(find(plates.assistant, "joint_damping"), Qt::Key_Space);
  EXPECT_THAT(plates.text("joint_springs").toStdString(), HasSubstr(": 2 unknown"));
  for (const char* direction : {"joint_x", "joint_z"}) QTest::keyClick(find(plates.assistant, direction), Qt::Key_Space);
  EXPECT_FALSE(plates.may_accept());
}

TEST(JointAssistant, AWordIsSaidAboveAHundredUnknowns) {
  Plates plates;
  const auto word = [&] { return find<QLabel>(plates.assistant, "joint_word")->text().toStdString(); };
  EXPECT_THAT(word(), IsEmpty());
  find<QRadioButton>(plates.assistant, "joint_full")->click();
  EXPECT_THAT(word(), HasSubstr("more than 100 unknowns"));
}

TEST(JointAssistant, PairsAreAddedWithoutPositions) {
  JointAssistant assistant({part("/d/low.uff", {1, 2}, {}), part("/d/up.uff", {11, 12}, {})});
  EXPECT_THAT(find<QLabel>(assistant, "joint_hint")->text().toStdString(), HasSubstr("Add the pairs"));
  auto* const add = find<QPushButton>(assistant, "joint_add");
  add->click();
  add->click();
  add->click();
  EXPECT_EQ(assistant.joint().pairs.size(), 2U);
  EXPECT_THAT(find<QLabel>(assistant, "joint_word")->text().toStdString(), HasSubstr("in the list"));
}

TEST(JointAssistant, EveryWidgetHasAName) {
  Plates plates;
  EXPECT_EQ(without_accessible_name(plates.assistant).join(", ").toStdString(), "");
}

constexpr const char* commented = R"([data]
substructures = ["a.uff", "b.uff"]
assembly = ["c.uff"]

[joint]
dofs = []  # both sides
mass = { pattern = "diagonal" }

# Unknown
[joint.stiffness]
pattern = "symmetric"
definite = true

[joint.hysteretic_damping]
pattern = "symmetric"
)";

TEST(WithJoint, ReplacesTheMatricesAndKeepsTheRest) {
  tasks::JointLayout layout{{{1, 11, {frf::Direction::x}}, {2, 12, {frf::Direction::x}}}};
  const std::string text = with_joint(commented, layout);
  const CheckedScene checked = check_scene(text, "/d/scene.toml");
  ASSERT_TRUE(checked.scene) << checked.error->problem << text;
  EXPECT_EQ(checked.scene->joints[0].dofs.size(), 4U);
  EXPECT_TRUE(checked.scene->joints[0].definite.contains(restrictions::Kind::stiffness));
  EXPECT_THAT(text, testing::AllOf(HasSubstr("# both sides"), HasSubstr("# Unknown"), Not(HasSubstr("symmetric"))));
  layout.form = tasks::JointForm::equal_springs;
  layout.damping = false;
  const std::string equal = with_joint(text, layout);
  EXPECT_THAT(equal, testing::AllOf(HasSubstr("x = [["), Not(HasSubstr("hysteretic"))));
  EXPECT_TRUE(check_scene(equal, "/d/scene.toml").scene) << equal;
  layout.form = tasks::JointForm::full;
  EXPECT_TRUE(check_scene(with_joint(equal, layout), "/d/scene.toml").scene) << with_joint(equal, layout);
}

TEST(WithJoint, ReplacesMatricesThatStandInALine) {
  const std::string text = with_joint("[data]\nsubstructures = [\"a\", \"b\"]\nassembly = [\"c\"]\n[joint]\ndofs = [\"1:+X\", \"2:+X\"]\n"
                                      "stiffness = { pattern = \"full\" }\n[frequency]\nrange = [1, 2]\n",
                                      {{{1, 2, {frf::Direction::x}}}});
  EXPECT_TRUE(check_scene(text, "/d/scene.toml").scene) << text;
}

/// Three nodes on either side, in three directions, not on one line.
frf::FrfHeader surface(const char* file, std::int64_t first, double z) {
  frf::FrfHeader made = part(file, {}, {{first, {0, 0, z}}, {first + 1, {0.1, 0, z}}, {first + 2, {0, 0.1, z}}});
  for (std::int64_t node = first; node < first + 3; ++node) {
    for (const auto direction : {frf::Direction::x, frf::Direction::y, frf::Direction::z}) made.response.push_back({node, direction});
  }
  made.reference = made.response;
  return made;
}

TEST(JointAssistant, RigidPlatesAreVirtualPoints) {
  JointAssistant assistant({surface("/d/low.uff", 1, 0.0), surface("/d/up.uff", 11, 0.01)});
  find<QRadioButton>(assistant, "joint_plate")->click();
  EXPECT_THAT(find<QRadioButton>(assistant, "joint_plate")->text().toStdString(), HasSubstr(": 12 unknown"));
  const tasks::JointLayout layout = assistant.joint();
  ASSERT_TRUE(layout.plate);
  EXPECT_NEAR(layout.plate->position[2], 0.005, 1e-12);
  std::string text = with_joint(small_scene, layout);
  const CheckedScene checked = check_scene(text, "/d/scene.toml");
  ASSERT_TRUE(checked.scene) << checked.error->problem << '\n' << text;
  EXPECT_EQ(checked.scene->joints.front().dofs.size(), 12U);
  EXPECT_THAT(text, HasSubstr("name = \"VP2\""));
  // Once more, and the text has two virtual points again.
  text = with_joint(text, layout);
  EXPECT_TRUE(check_scene(text, "/d/scene.toml").scene);
}

TEST(JointAssistant, PlatesThatDoNotTellAllMotionsAreNone) {
  Plates plates;  // on one line: the rotation about it is not seen
  find<QRadioButton>(plates.assistant, "joint_plate")->click();
  EXPECT_FALSE(plates.assistant.joint().plate);
  EXPECT_FALSE(plates.may_accept());
  EXPECT_THAT(find<QLabel>(plates.assistant, "joint_word")->text().toStdString(), HasSubstr("VP1"));
}

TEST(JointAssistant, TimeAndIntervalsStandBesideTheChoice) {
  Plates plates;
  std::vector<std::size_t> asked;
  plates.assistant.set_forecast([&asked](const tasks::JointLayout& layout, const Worker::Watch&) {
    asked.push_back(tasks::unknowns_of(layout));
    return tasks::JointForecast{12, 290.0, {{"K.x", "N/m", 1e6, 1e4, 0.01}, {"K.z", "N/m", 1e6, 1e5, 0.1}}, ""};
  });
  const auto said = [&] { return plates.assistant.forecast().toStdString(); };
  ASSERT_TRUE(QTest::qWaitFor([&] { return said().find("95 %") != std::string::npos; }, 10000));
  EXPECT_THAT(said(), HasSubstr("4 min 50 s"));
  EXPECT_THAT(said(), HasSubstr("± 20 % of the worst"));
  EXPECT_THAT(asked, testing::ElementsAre(12U));
  find<QRadioButton>(plates.assistant, "joint_equal")->click();
  EXPECT_TRUE(QTest::qWaitFor([&] { return asked.size() == 2; }, 10000));
}

}  // namespace
}  // namespace jointid::gui
