#include <gmock/gmock.h>

#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>

#include "../widgets.hpp"
#include "gui/data/data_page.hpp"
#include "gui/geometry/geometry_page.hpp"
#include "gui/geometry/line_pen.hpp"
#include "gui/geometry/structure_view.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_editor.hpp"

namespace jointid::gui {
namespace {

using frf::NodeLine;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Rig one's geometry in front.
struct Drawn {
  Measured measured{"rig1"};
  Project project;
  StructureView* view = project.geometry_page()->view();
  QPushButton* button = find<QPushButton>(project, "geometry_lines");

  Drawn() {
    project.resize(1280, 800);
    project.show();
    project.open(measured.scene());
    project.pages()->setCurrentWidget(project.geometry_page());
    (void)QTest::qWaitFor([&] { return !project.geometry_page()->is_busy() && !view->structure().nodes.empty(); }, 60000);
  }
  std::int64_t node(std::size_t place) const { return view->structure().nodes[place].id; }
  void click(std::int64_t node) { click(view->place_of(node)); }
  void click(const QPointF& at) { QTest::mouseClick(view, Qt::LeftButton, Qt::NoModifier, at.toPoint()); }
  void press(Qt::Key key) { QTest::keyClick(view, key); }
  std::string text() const { return project.editor()->text(); }
  std::string status() const { return project.geometry_page()->status().toStdString(); }
};

/// Nodes that the files do not join: the first and the third of a straight part.
TEST(LinesByHand, TwoClicksDrawALineThatTheSceneKeepsAndUndoTakesBack) {
  Drawn drawn;
  const NodeLine line = {drawn.node(0), drawn.node(2)};
  const std::string before = drawn.text(),
                    written = "lines = [[" + std::to_string(line[0]) + ", " + std::to_string(line[1]) + "]]";
  drawn.button->click();
  drawn.click(line[0]);
  EXPECT_THAT(drawn.status(), HasSubstr("A line from node " + std::to_string(line[0])));
  EXPECT_EQ(drawn.text(), before);
  const QImage without = drawn.view->grab().toImage();
  drawn.click(line[1]);
  EXPECT_THAT(drawn.view->own_lines(), ElementsAre(line));
  EXPECT_THAT(drawn.text(), HasSubstr("[geometry]\n" + written));
  EXPECT_NE(drawn.view->grab().toImage(), without);
  EXPECT_TRUE(drawn.project.checked().scene.has_value());
  drawn.project.undo();
  EXPECT_EQ(drawn.text(), before);
  EXPECT_THAT(drawn.view->own_lines(), IsEmpty());
  drawn.project.redo();
  EXPECT_THAT(drawn.view->own_lines(), ElementsAre(line));
  ASSERT_TRUE(drawn.project.save());
  Project again;
  again.show();
  ASSERT_TRUE(again.open(drawn.measured.scene()));
  EXPECT_THAT(again.geometry_page()->view()->own_lines(), ElementsAre(line));
}

TEST(LinesByHand, TheKeyboardDrawsAndRemovesThem) {
  Drawn drawn;
  const std::string before = drawn.text();
  drawn.view->setFocus();
  drawn.press(Qt::Key_L);
  EXPECT_TRUE(drawn.button->isChecked());
  for (const Qt::Key key : {Qt::Key_PageDown, Qt::Key_Space, Qt::Key_PageDown, Qt::Key_PageDown, Qt::Key_Space}) drawn.press(key);
  EXPECT_THAT(drawn.view->own_lines(), ElementsAre(NodeLine{drawn.node(0), drawn.node(2)}));
  EXPECT_THAT(drawn.status(), HasSubstr("Delete removes it"));
  drawn.press(Qt::Key_Delete);
  EXPECT_THAT(drawn.view->own_lines(), IsEmpty());
  EXPECT_THAT(drawn.text(), Not(HasSubstr("lines = ")));
  drawn.press(Qt::Key_Space);
  drawn.press(Qt::Key_Escape);
  EXPECT_FALSE(drawn.view->pen().from().has_value());
  drawn.press(Qt::Key_L);
  EXPECT_FALSE(drawn.button->isChecked());
  EXPECT_THAT(drawn.status(), HasSubstr("nodes"));
  drawn.press(Qt::Key_Delete);
  EXPECT_TRUE(drawn.project.checked().scene.has_value());
}

TEST(LinesByHand, AClickOnALineChoosesItAndDeleteRemovesIt) {
  Drawn drawn;
  const NodeLine one = {drawn.node(0), drawn.node(4)}, other = {drawn.node(1), drawn.node(3)};
  drawn.button->click();
  for (const std::int64_t node : {one[0], one[1], other[0], other[1]}) drawn.click(node);
  ASSERT_THAT(drawn.view->own_lines(), ElementsAre(one, other));
  drawn.press(Qt::Key_Escape);
  drawn.press(Qt::Key_Delete);
  EXPECT_EQ(drawn.view->own_lines().size(), 2U) << "nothing was chosen";
  drawn.click(0.5 * (drawn.view->place_of(drawn.node(0)) + drawn.view->place_of(drawn.node(1))));  // the nodes are on one line
  EXPECT_EQ(drawn.view->pen().chosen(), one);
  drawn.press(Qt::Key_Delete);
  EXPECT_THAT(drawn.view->own_lines(), ElementsAre(other));
}

TEST(LinesByHand, AClickChoosesNoDofWhileLinesAreDrawn) {
  Drawn drawn;
  const std::string before = drawn.text();
  drawn.button->click();
  drawn.click(drawn.view->tip_of(drawn.view->structure().dofs.front()));
  EXPECT_EQ(drawn.text(), before);
}

TEST(LinePen, LinesOfTheFilesAreNotDrawnTwice) {
  LinePen pen;
  EXPECT_FALSE(pen.pick(1, {{2, 1}}));
  EXPECT_FALSE(pen.pick(2, {{2, 1}}));
  EXPECT_THAT(pen.own(), IsEmpty());
  EXPECT_THAT(pen.text().toStdString(), HasSubstr("one of the files"));
  EXPECT_FALSE(pen.remove());
  EXPECT_FALSE(pen.pick(1, {}));
  EXPECT_TRUE(pen.pick(3, {}));
  EXPECT_FALSE(pen.pick(3, {}));
  EXPECT_FALSE(pen.pick(1, {})) << "it is there, the other way round";
  EXPECT_EQ(pen.chosen(), (NodeLine{1, 3}));
  EXPECT_FALSE(pen.pick(5, {}));
  EXPECT_FALSE(pen.pick(5, {})) << "the same node puts it down";
  EXPECT_FALSE(pen.from().has_value());
}

}  // namespace
}  // namespace jointid::gui
