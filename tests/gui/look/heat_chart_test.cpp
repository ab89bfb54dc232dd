#include "gui/plot/heat_chart.hpp"

#include <gmock/gmock.h>

#include <QCoreApplication>
#include <QImage>
#include <QTest>
#include <cmath>

#include "../widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

struct DrawnMap {
  HeatChart chart{"map", "A map", "nothing yet"};

  explicit DrawnMap(HeatPlot plot) {
    chart.resize(600, 400);
    chart.show();
    (void)QTest::qWaitForWindowExposed(&chart);
    chart.draw(std::move(plot));
    QCoreApplication::processEvents();
  }
};

HeatPlot two_by_three() {
  return {.x_label = "modes of b.uff",
          .y_label = "modes found",
          .value_label = "MAC",
          .columns = {"1: 10 Hz", "2: 20 Hz", "3: 30 Hz"},
          .x_values = {},
          .rows = {"1: 11 Hz", "2: 21 Hz"},
          .values = {1.0, 0.1, 0.0, 0.2, 0.9, std::nan("")},
          .from_0_to_1 = true};
}

TEST(HeatChart, StatesTheCellUnderTheMouse) {
  DrawnMap drawn(two_by_three());
  const QPoint place = drawn.chart.pixel_of(1, 1);
  ASSERT_TRUE(drawn.chart.canvas()->rect().contains(place)) << place.x() << ' ' << place.y();
  move_mouse(drawn.chart.canvas(), place);
  QCoreApplication::processEvents();
  EXPECT_EQ(drawn.chart.readout().toStdString(), "2: 21 Hz / 2: 20 Hz: MAC 0.9");
}

TEST(HeatChart, ColoursAreThoseOfTheValues) {
  DrawnMap drawn(two_by_three());
  const QImage image = drawn.chart.canvas()->grab().toImage();
  const auto colour = [&](std::size_t row, std::size_t column) { return image.pixelColor(drawn.chart.pixel_of(row, column)); };
  const auto off = [](const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
  };
  EXPECT_GT(off(colour(0, 0), colour(0, 2)), 200) << "1 and 0 of a scale from 0 to 1";
  EXPECT_GT(off(colour(0, 0), colour(0, 1)), off(colour(0, 0), colour(1, 1))) << "0.1 is further from 1 than 0.9";
}

TEST(HeatChart, KeysGoFromCellToCell) {
  DrawnMap drawn(two_by_three());
  for (const auto key : {Qt::Key_Up, Qt::Key_Up, Qt::Key_Right, Qt::Key_Right, Qt::Key_Right})
    QTest::keyClick(drawn.chart.canvas(), key);
  EXPECT_EQ(drawn.chart.readout().toStdString(), "2: 21 Hz / 3: 30 Hz: MAC –");
  for (const auto key : {Qt::Key_Down, Qt::Key_Left}) QTest::keyClick(drawn.chart.canvas(), key);
  EXPECT_EQ(drawn.chart.readout().toStdString(), "1: 11 Hz / 2: 20 Hz: MAC 0.1");
}

TEST(HeatChart, ItsNumbersAreATable) {
  EXPECT_EQ(DrawnMap(two_by_three()).chart.saveable().table(','),
            "\"modes found\",\"1: 10 Hz\",\"2: 20 Hz\",\"3: 30 Hz\"\n\"1: 11 Hz\",1,0.10000000000000001,0\n"
            "\"2: 21 Hz\",0.20000000000000001,0.90000000000000002,nan\n");
}

TEST(HeatChart, CurvesOfForceLevelsBecomeRows) {
  report::CurvePlot plot{.title = "",
                         .x = {"frequency (Hz)", false},
                         .y = {"|X|/force", true},
                         .x_values = {1.0, 2.0, 4.0},
                         .series = {{"1 N", {1e-3, 1e-2, 1e-3}}, {"10 N", {1e-3, 1e-1, 1e-3}}},
                         .band = {},
                         .level = {},
                         .period = {}};
  const HeatPlot map = heat_of(plot, "force level");
  EXPECT_THAT(map.rows, testing::ElementsAre("1 N", "10 N"));
  EXPECT_TRUE(map.log);
  DrawnMap drawn(map);
  move_mouse(drawn.chart.canvas(), drawn.chart.pixel_of(1, 1));
  QCoreApplication::processEvents();
  EXPECT_THAT(drawn.chart.readout().toStdString(), testing::AllOf(HasSubstr("10 N"), HasSubstr("2:"), HasSubstr("0.1")));
}

TEST(HeatChart, HintStandsWhereThereIsNothing) {
  DrawnMap drawn({});
  move_mouse(drawn.chart.canvas(), QPoint(50, 50));
  QTest::keyClick(drawn.chart.canvas(), Qt::Key_Right);
  EXPECT_EQ(drawn.chart.readout().toStdString(), "");
}

}  // namespace
}  // namespace jointid::gui
