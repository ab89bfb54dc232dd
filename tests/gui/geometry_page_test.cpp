#include "gui/geometry/geometry_page.hpp"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QImageReader>
#include <QListWidget>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cstring>

#include "base/error.hpp"
#include "base/text.hpp"
#include "gui/geometry/motion_bar.hpp"
#include "gui/geometry/structure_view.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/theme.hpp"
#include "ident/scene/read_scene.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

/// Rig one, whose files know where their nodes are.
struct Seen {
  Measured measured{"rig1"};
  ident::Scene scene = ident::read_scene(as_path(measured.scene()));
  GeometryPage page;
  std::vector<std::string> edits;

  Seen() {
    QObject::connect(&page, &GeometryPage::edit_wanted,
                     [this](const std::string& table, const std::string& key, const std::string& value) {
                       edits.push_back(table + "." + key + " = " + value);
                     });
    page.resize(800, 600);
    page.show();
    page.set_scene(scene, "1");
    (void)rests();
  }
  bool rests() {
    return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000);
  }
  void move() {
    find<QToolButton>(page, "play")->click();
    ASSERT_TRUE(rests());
  }
  int ticked() {
    int count = 0;
    for (int i = 0; i < page.dofs()->count(); ++i) count += page.dofs()->item(i)->checkState() == Qt::Checked ? 1 : 0;
    return count;
  }
};

TEST(GeometryPage, ShowsTheStructureAndTheJointOfTheScene) {
  Seen seen;
  EXPECT_GT(seen.page.view()->structure().nodes.size(), 4U);
  EXPECT_FALSE(seen.page.view()->structure().lines.empty());
  EXPECT_EQ(seen.ticked(), static_cast<int>(seen.scene.joints.front().dofs.size()));
  EXPECT_TRUE(seen.edits.empty());
}

TEST(GeometryPage, ATickIsAnEditOfTheJoint) {
  Seen seen;
  seen.page.dofs()->item(0)->setCheckState(Qt::Checked);
  ASSERT_EQ(seen.edits.size(), 1U);
  EXPECT_THAT(seen.edits[0], testing::StartsWith("joint.dofs = [\"125:+Y\""));
  EXPECT_THAT(seen.edits[0], HasSubstr(seen.page.dofs()->item(0)->text().toStdString()));
  seen.page.dofs()->item(0)->setCheckState(Qt::Unchecked);
  EXPECT_THAT(seen.edits[1], testing::Not(HasSubstr(seen.page.dofs()->item(0)->text().toStdString())));
}

TEST(GeometryPage, SpaceTicksADof) {
  Seen seen;
  seen.page.dofs()->setCurrentRow(0);
  seen.page.dofs()->setFocus();
  QTest::keyClick(seen.page.dofs(), Qt::Key_Space);
  EXPECT_EQ(seen.edits.size(), 1U);
}

TEST(GeometryPage, AClickOnAnArrowTakesItIntoTheJointAndOutAgain) {
  Seen seen;
  StructureView& view = *seen.page.view();
  const frf::Dof dof = view.structure().dofs.front();
  const int before = seen.ticked();
  for (const int expected : {before + 1, before}) {
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.tip_of(dof).toPoint());
    EXPECT_EQ(seen.ticked(), expected);
  }
  EXPECT_EQ(seen.edits.size(), 2U);
}

TEST(GeometryPage, TheSceneTicksTheListBothWays) {
  Seen seen;
  seen.scene.joints.front().dofs.resize(2);
  seen.page.set_scene(seen.scene, "1");
  EXPECT_EQ(seen.ticked(), 2);
  EXPECT_TRUE(seen.edits.empty());
}

TEST(GeometryPage, TheMotionIsThatOfTheMeasuredFrfs) {
  Seen seen;
  seen.page.set_frequency(420.3);
  seen.move();
  const Deflection& found = seen.page.deflection();
  EXPECT_NEAR(found.frequency_hz, 420.3, 3.0);
  const auto files = open_files(seen.scene.data, {});
  const LoadedFile& assembly = files.back();
  ASSERT_TRUE(assembly.is_assembly);
  ASSERT_GT(found.shape.size(), 4U);
  for (std::size_t r = 0; r < assembly.header.response.size(); ++r) {
    const frf::Dof& dof = assembly.header.response[r];
    const Curve curve = read_curve(assembly, r, 0);
    const Complex expected = static_cast<double>(dof.sign) * curve.values[nearest_line(curve, 420.3)];
    EXPECT_EQ(found.shape.at(dof.node)[static_cast<std::size_t>(dof.direction) - 1], expected) << dof.name();
  }
}

TEST(GeometryPage, StoppedTheStructureIsAtRest) {
  Seen seen;
  seen.move();
  EXPECT_FALSE(seen.page.deflection().shape.empty());
  seen.move();
  EXPECT_TRUE(seen.page.deflection().shape.empty());
}

TEST(GeometryPage, ModesOfAFitAndOfAFileMoveTheStructure) {
  Seen seen;
  frf::Uff55Mode mode;
  mode.number = 3;
  mode.frequency_hz = 77.5;
  mode.id.fill("NONE");
  const frf::Dof moved = seen.page.view()->structure().dofs.front();
  mode.dofs = {moved};
  mode.shape = {2.0};
  seen.page.set_modes(named_shapes({mode}, "fit"));
  seen.page.motion()->choose_mode(0);
  EXPECT_TRUE(seen.page.deflection().shape.empty());
  find<QToolButton>(seen.page, "play")->click();
  ASSERT_EQ(seen.page.deflection().shape.size(), 1U);
  EXPECT_EQ(seen.page.deflection().shape.at(moved.node)[static_cast<std::size_t>(moved.direction) - 1], 2.0 * moved.sign);
  EXPECT_THAT(seen.page.status().toStdString(), HasSubstr("3: 77.5 Hz, fit"));
  EXPECT_FALSE(find<QDoubleSpinBox>(seen.page, "force_frequency")->isEnabled());
  const QString file = seen.measured.file("shapes.uff");
  mode.frequency_hz = 88.5;
  frf::write_uff55({mode}, {}, as_path(file));
  seen.page.open_shapes(file);
  ASSERT_TRUE(seen.rests());
  EXPECT_EQ(seen.page.motion()->mode(), 1U);
  EXPECT_THAT(seen.page.status().toStdString(), HasSubstr("88.5 Hz, shapes.uff"));
  seen.page.open_shapes("/nowhere.uff");
  ASSERT_TRUE(seen.rests());
  EXPECT_THAT(seen.page.status().toStdString(), HasSubstr("/nowhere.uff"));
}

TEST(GeometryPage, ThePhaseIsHeldWhereItIsSet) {
  Seen seen;
  seen.move();
  find<QToolButton>(seen.page, "hold")->click();
  const QSignalSpy phases(seen.page.motion(), &MotionBar::phase_changed);
  QTest::qWait(100);
  EXPECT_EQ(phases.count(), 0);
  auto* const slider = find<QSlider>(seen.page, "phase");
  slider->setValue(slider->value() == 90 ? 180 : 90);
  ASSERT_EQ(phases.count(), 1);
  EXPECT_NEAR(phases.front().at(0).toDouble(), slider->value() / 57.29577951308232, 1e-12);
}

/// Of two nodes that move by 3 and 1: ±1 about their mean; others are left out.
TEST(ModeShapes, TheJointDeflectsAboutItsMean) {
  const Shape shape = {{1, {0.0, 3.0, 0.0}}, {2, {0.0, Complex(1.0, 0.0), 0.0}}, {7, {0.0, 9.0, 0.0}}};
  const std::vector<frf::Dof> joint = {frf::Dof::parse("1:+Y"), frf::Dof::parse("2:-Y"), frf::Dof::parse("2:+RZ")};
  const Shape found = joint_deflection(shape, joint);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found.at(1)[1], Complex(1.0));
  EXPECT_EQ(found.at(2)[1], Complex(-1.0));
  EXPECT_EQ(joint_motion_text(shape, joint).toStdString(), "1:+Y 3 ∠ 0°, 2:-Y 1 ∠ 180°");
  EXPECT_EQ(joint_deflection(shape, {joint[0]}).size(), 3U);
}

TEST(GeometryPage, FilesAreOpenedWhenThePageIsSeen) {
  Measured measured("rig1");
  GeometryPage page;
  page.set_scene(ident::read_scene(as_path(measured.scene())), "1");
  EXPECT_FALSE(page.is_busy());
  page.show();
  EXPECT_TRUE(page.is_busy());
}

TEST(StructureView, IsTurnedZoomedAndShownWholeAgain) {
  Seen seen;
  StructureView& view = *seen.page.view();
  const auto tip = [&] { return view.tip_of(view.structure().dofs.front()); };
  const QPointF first = tip();
  for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Up, Qt::Key_Plus}) {
    const QPointF before = tip();
    QTest::keyClick(&view, key);
    EXPECT_NE(tip(), before);
  }
  QTest::keyClick(&view, Qt::Key_Home);
  EXPECT_EQ(tip(), first);
  QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, QPoint(30, 30));
  QMouseEvent drag(QEvent::MouseMove, QPointF(90, 60), view.mapToGlobal(QPointF(90, 60)), Qt::NoButton, Qt::LeftButton,
                   Qt::NoModifier);
  QApplication::sendEvent(&view, &drag);
  QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, QPoint(90, 60));
  EXPECT_NE(tip(), first);
  EXPECT_TRUE(seen.edits.empty());
}

TEST(StructureView, TheMotionIsDrawn) {
  Seen seen;
  seen.move();
  StructureView& view = *seen.page.view();
  view.set_phase(0.3);
  const QImage one = view.grab().toImage();
  view.set_phase(1.6);
  EXPECT_NE(view.grab().toImage(), one);
  view.set_phase(0.3);
  find<QSlider>(seen.page, "amplitude")->setValue(90);
  EXPECT_NE(view.grab().toImage(), one);
}

TEST(GeometryPage, SavesPicturesAndNodes) {
  Seen seen;
  seen.move();
  const QTemporaryDir folder;
  for (const auto& [name, begin] : {std::pair("a.png", "\x89PNG"), std::pair("a.svg", "<?xml"), std::pair("a.pdf", "%PDF")}) {
    seen.page.save(folder.filePath(name));
    EXPECT_EQ(read_file(folder.filePath(name)).substr(0, std::strlen(begin)), begin) << name;
  }
  EXPECT_EQ(QImage(folder.filePath("a.png")).size(), 2 * seen.page.view()->size());
  seen.page.save(folder.filePath("a.csv"));
  const std::string csv = read_file(folder.filePath("a.csv"));
  const std::size_t nodes = seen.page.view()->structure().nodes.size();
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), nodes + 1);
  const auto& [node, shape] = *seen.page.deflection().shape.begin();
  const std::size_t at = csv.find("\n" + std::to_string(node) + ",");
  ASSERT_NE(at, std::string::npos);
  EXPECT_THAT(csv.substr(at + 1, csv.find('\n', at + 1) - at),
              HasSubstr("," + digits(shape[1].real(), "%.17g") + "," + digits(shape[1].imag(), "%.17g")));
  seen.page.save(folder.filePath("a.gif"));
  QImageReader film(folder.filePath("a.gif"));
  EXPECT_EQ(film.imageCount(), 36);
  const QImage first = film.read(), second = film.read();
  EXPECT_EQ(first.size(), seen.page.view()->size());
  EXPECT_NE(first, second);
  seen.move();
  EXPECT_THROW(seen.page.save(folder.filePath("b.gif")), InputError) << "what is at rest is no film";
  EXPECT_THROW(seen.page.save(seen.measured.files().front()), InputError);
}

TEST(StructureView, NumbersOfNodesDoNotCollide) {
  Structure structure;
  for (std::int64_t id = 1; id <= 12; ++id) structure.nodes.push_back({id, {0.001 * static_cast<double>(id % 3), 0.0, 0.0}});
  structure.nodes.push_back({13, {1.0, 1.0, 0.0}});
  StructureView view;
  view.resize(400, 300);
  view.show();
  view.set_structure(structure);
  view.set_joint({frf::Dof::parse("1:+X"), frf::Dof::parse("2:+X"), frf::Dof::parse("4:+X"), frf::Dof::parse("5:+X"),
                  frf::Dof::parse("7:+X")});
  const auto places = view.name_places();
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(places[i].second.intersects(places[j].second)) << places[i].first;
  }
  for (const std::int64_t node : {1, 2, 4, 5, 7, 13})
    EXPECT_TRUE(std::ranges::any_of(places, [&](const auto& each) { return each.first == node; })) << node;
}

TEST(StructureView, PartsHaveColours) {
  Structure structure;
  structure.nodes = {{1, {0.0, 0.0, 0.0}}, {2, {1.0, 0.0, 0.0}}, {3, {2.0, 0.0, 0.0}}};
  structure.part = {{1, 0}, {2, 1}};
  StructureView view;
  view.set_structure(structure);
  EXPECT_NE(view.part_colour(structure.nodes[0]), view.part_colour(structure.nodes[1]));
  EXPECT_EQ(view.part_colour(structure.nodes[2]), colours(theme_of(view.palette())).text);
  structure.part = {{1, 0}};
  view.set_structure(structure);
  EXPECT_EQ(view.part_colour(structure.nodes[0]), colours(theme_of(view.palette())).text) << "one part has no colour";
}

TEST(StructureView, WithoutPositionsItSaysSo) {
  StructureView view;
  view.resize(400, 300);
  view.show();
  EXPECT_FALSE(view.grab().isNull());
  QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, QPoint(100, 100));
}

}  // namespace
}  // namespace jointid::gui
