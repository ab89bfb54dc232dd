#include <gmock/gmock.h>

#include <QComboBox>
#include <QImage>
#include <QTabWidget>
#include <QTest>
#include <QTextDocument>

#include "gui/geometry/geometry_page.hpp"
#include "gui/geometry/structure_view.hpp"
#include "gui/main_window.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/difference_tab.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/table/cell_table.hpp"
#include "widgets.hpp"

/// The bolts of a solution in the picture of the structure, and two tightenings beside each other.
namespace jointid::gui {
namespace {

using tasks::JointSpring;
using tasks::Tightness;
using testing::HasSubstr;

JointSpring spring(std::int64_t first, std::int64_t second, double share, Tightness tightness) {
  JointSpring out;
  out.unknown = "K[" + std::to_string(first) + ":+Z," + std::to_string(second) + ":+Z]";
  out.ends = {{frf::Dof{first, frf::Direction::z}, frf::Dof{second, frf::Direction::z}}};
  out.share = share;
  out.share_half_width = 0.02;
  out.tightness = tightness;
  return out;
}

TEST(DrawnSprings, TheLoosestOfTwoNodesStandsForThem) {
  const auto drawn = drawn_springs({spring(1, 11, 1.1, Tightness::alike), spring(11, 1, 0.3, Tightness::loose),
                                    spring(2, 12, 0.9, Tightness::alike)});
  ASSERT_EQ(drawn.size(), 2U);
  EXPECT_EQ(drawn[0].tightness, Tightness::loose);
  EXPECT_EQ(drawn[0].label.toStdString(), "0.3 ± 0.02");
  EXPECT_TRUE(drawn[1].label.isEmpty());
  EXPECT_THAT(springs_text(drawn).toStdString(), HasSubstr("Loose, red: 1 – 11: 0.3 ± 0.02 of the others (K[11:+Z,1:+Z])"));
  EXPECT_TRUE(springs_text({}).isEmpty());
  EXPECT_THAT(springs_text({drawn[1]}).toStdString(), HasSubstr("No spring is looser"));
}

int pixels_like(const QImage& image, const QColor& wanted) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == wanted ? 1 : 0;
  }
  return count;
}

/// A square of nodes, 11 over 1 and so on.
Structure two_plates() {
  Structure out;
  for (const auto& [id, x, z] : {std::tuple(1, 0.0, 0.0), std::tuple(2, 1.0, 0.0), std::tuple(11, 0.0, 0.3), std::tuple(12, 1.0, 0.3)})
    out.nodes.push_back({id, {x, 0.0, z}});
  return out;
}

TEST(StructureView, ALooseSpringIsRedAndOneLikeTheOthersGreen) {
  StructureView view;
  view.resize(500, 400);
  view.set_structure(two_plates());
  view.look(Camera::Side::front);
  const Colours use = colours(theme_of(view.palette()));
  const auto picture = [&view] { return QImage::fromData(view.picture(QStringLiteral("png"))); };
  EXPECT_EQ(pixels_like(picture(), use.good), 0);
  view.set_springs(drawn_springs({spring(1, 11, 1.0, Tightness::alike), spring(2, 12, 0.2, Tightness::loose)}));
  EXPECT_GT(pixels_like(picture(), use.good), 100);
  EXPECT_GT(pixels_like(picture(), use.error), 100);
}

TEST(StructureView, ArrowsMoveWithTheirNodes) {
  StructureView view;
  view.resize(500, 400);
  Structure structure = two_plates();
  structure.dofs = {{.node = 2, .direction = frf::Direction::z}};
  view.set_structure(structure);
  view.grab();  // the camera has the size of the view from here on
  const QPointF before = view.tip_of(structure.dofs.front());
  view.set_shape({{2, {0.0, 0.0, 1.0}}}, 0.3);
  view.set_phase(0.0);
  EXPECT_LT(view.tip_of(structure.dofs.front()).y(), before.y() - 5.0);
}

/// The first bolt at a fifth of its stiffness, by another scene of the same problem: a second tightening.
TEST(Tightenings, OfTwoScenesStandBesideEachOtherWithIntervals) {
  const Measured rig("bolts", "uff"), other("bolts", "uff");
  MainWindow window;
  window.resize(1100, 750);
  window.show();
  for (const QString& scene : {rig.scene(), other.scene()}) {
    window.open({scene});
    SolvePage& page = *window.current()->solve_page();
    page.solve();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !page.runs().empty() && !page.is_busy(); }, 120000)) << page.status().toStdString();
  }
  Project& project = *window.current();
  project.pages()->setCurrentWidget(project.solve_page());
  DifferenceTab& tab = *project.solve_page()->differences();
  project.solve_page()->results()->setCurrentWidget(&tab);
  ASSERT_EQ(tab.others()->count(), 1);
  EXPECT_THAT(tab.others()->itemText(0).toStdString(), HasSubstr("bolts.toml"));
  const CellModel& cells = *tab.table()->cells();
  ASSERT_GT(cells.rowCount(), 0);
  EXPECT_EQ(cells.index(0, 6).data().toString().toStdString(), "within the intervals");
  EXPECT_FALSE(project.geometry_page()->view()->springs().empty());
}

}  // namespace
}  // namespace jointid::gui
