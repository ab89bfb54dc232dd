#include "gui/plot/chart.hpp"

#include <gmock/gmock.h>
#include <qcustomplot.h>

#include <QApplication>
#include <QClipboard>
#include <QImage>
#include <QSet>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "base/error.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

report::ScatterPlot three_points() {
  report::ScatterPlot plot{"Error", {"time (ms)", true}, {"error", true}, {}, {}};
  plot.groups = {{"WA", {{1.0, 0.2, "WA, nn"}, {30.0, 0.02, "WA, \"all\""}}}, {"WB", {{8.0, 0.05, "WB"}}}};
  plot.front = {{1.0, 0.2, ""}, {30.0, 0.02, ""}};
  plot.front_name = "front";
  return plot;
}

report::HistogramPlot bins(const char* name) { return {name, {"N/m", false}, 0.0, 4.0, {1.0, 5.0, 3.0, 0.0}, 1.5, "truth"}; }

struct DrawnChart {
  Chart chart{"chart", "A chart", "nothing yet"};
  QSignalSpy chosen{&chart, &Chart::chosen}, opened{&chart, &Chart::opened};

  DrawnChart() {
    chart.resize(600, 400);
    chart.show();
    (void)QTest::qWaitForWindowExposed(&chart);
  }
  void draw_points() {
    chart.draw(three_points());
    QCoreApplication::processEvents();  // replots are queued, and the axes have their places after them
  }
};

TEST(Chart, AClickOnAPointOpensIt) {
  DrawnChart drawn;
  drawn.draw_points();
  QTest::mouseClick(drawn.chart.canvas(), Qt::LeftButton, Qt::NoModifier, drawn.chart.pixel_of(1, 0));
  ASSERT_EQ(drawn.opened.count(), 1);
  EXPECT_EQ(drawn.opened.front().at(0).value<std::size_t>(), 1U);
  EXPECT_THAT(drawn.chart.readout().toStdString(), HasSubstr("WB: time (ms) 8"));
  QTest::mouseClick(drawn.chart.canvas(), Qt::LeftButton, Qt::NoModifier, QPoint(2, 2));
  EXPECT_EQ(drawn.opened.count(), 1);
}

TEST(Chart, TheKeyboardGoesThroughThePointsFromLeftToRightAndOpensOne) {
  DrawnChart drawn;
  drawn.draw_points();
  for (const char* label : {"WA, nn", "WB", "WA, \"all\"", "WA, \"all\""}) {
    QTest::keyClick(drawn.chart.canvas(), Qt::Key_Right);
    EXPECT_THAT(drawn.chart.readout().toStdString(), testing::StartsWith(label));
  }
  QTest::keyClick(drawn.chart.canvas(), Qt::Key_Left);
  EXPECT_EQ(drawn.chosen.count(), 5);
  EXPECT_EQ(drawn.opened.count(), 0);
  QTest::keyClick(drawn.chart.canvas(), Qt::Key_Return);
  ASSERT_EQ(drawn.opened.count(), 1);
  EXPECT_EQ(drawn.opened.front().at(0).value<std::size_t>(), 1U);
}

TEST(Chart, WithNothingToChooseKeysAndClicksDoNothing) {
  DrawnChart drawn;
  for (const auto& draw : std::vector<std::function<void()>>{[] {}, [&] { drawn.chart.draw({bins("K")}); }}) {
    draw();
    QTest::keyClick(drawn.chart.canvas(), Qt::Key_Right);
    QTest::keyClick(drawn.chart.canvas(), Qt::Key_Return);
    QTest::mouseClick(drawn.chart.canvas(), Qt::LeftButton, Qt::NoModifier, QPoint(100, 100));
  }
  EXPECT_EQ(drawn.chosen.count() + drawn.opened.count(), 0);
}

TEST(Chart, IsCopiedAndSavedAsNumbersAndPicture) {
  DrawnChart drawn;
  drawn.draw_points();
  EXPECT_THAT(drawn.chart.saveable().table(','), HasSubstr("\"WA\",\"WA, \"\"all\"\"\",30,0.02"));
  drawn.chart.draw({bins("K(1,1)"), bins("K(1,2)")});
  EXPECT_THAT(drawn.chart.saveable().table('\t'), HasSubstr("\"K(1,2)\"\t1\t2\t5\n"));
  copy_plot(drawn.chart.saveable());
  EXPECT_THAT(QApplication::clipboard()->text().toStdString(), HasSubstr("K(1,1)"));
  const QTemporaryDir folder;
  for (const char* name : {"a.png", "a.svg", "a.pdf", "a.csv"}) {
    save_plot(folder.filePath(name), drawn.chart.saveable(), {});
    EXPECT_GT(QFileInfo(folder.filePath(name)).size(), 50) << name;
  }
  EXPECT_THROW(save_plot(folder.filePath("a.doc"), drawn.chart.saveable(), {}), InputError);
}

TEST(Chart, IsZoomedByKeysAndTheViewStaysWithOtherPoints) {
  DrawnChart drawn;
  drawn.draw_points();
  const auto all = drawn.chart.shown();
  QTest::keyClick(drawn.chart.canvas(), Qt::Key_Plus);
  EXPECT_EQ(drawn.chart.shown(), all);
  drawn.chart.let_zoom();
  QTest::keyClick(drawn.chart.canvas(), Qt::Key_Plus);
  const auto zoomed = drawn.chart.shown();
  EXPECT_GT(zoomed[0], all[0]);
  EXPECT_LT(zoomed[1], all[1]);
  drawn.draw_points();
  EXPECT_EQ(drawn.chart.shown(), zoomed);
  QTest::keyClick(drawn.chart.canvas(), Qt::Key_Home);
  EXPECT_EQ(drawn.chart.shown(), all);
}

TEST(Chart, CurvesAreDrawnBelowEachOtherAndSavedAsNumbers) {
  DrawnChart drawn;
  report::CurvePlot curve, residual;
  curve.x = residual.x = {"u (m)", false};
  curve.y = {"force (N)", false};
  residual.y = {"residual", false};
  residual.level = 0.0;
  curve.x_values = residual.x_values = {0.0, 1.0, 2.0};
  curve.series = {{"measured", {0.0, 1.5, 2.0}, report::Style::reference}, {"ren", {0.0, 1.4, std::nan("")}, report::Style::line}};
  residual.series = {{"ren", {0.0, -0.1, 0.2}, report::Style::points}};
  drawn.chart.draw({curve, residual});
  drawn.chart.let_zoom();
  QCoreApplication::processEvents();
  const QImage one = drawn.chart.grab().toImage();
  QTest::keyClick(drawn.chart.canvas(), Qt::Key_Minus);
  QCoreApplication::processEvents();
  EXPECT_NE(drawn.chart.grab().toImage(), one);
  const std::string table = drawn.chart.saveable().table(',');
  EXPECT_THAT(table, HasSubstr("\"u (m)\",\"measured, force (N)\",\"ren, force (N)\"\n0,0,0\n"));
  EXPECT_THAT(table, HasSubstr("\n2,2,\n"));
  drawn.chart.clear();
  EXPECT_TRUE(drawn.chart.curve_plots().empty());
}

TEST(Chart, OtherPointsForgetWhichWasChosen) {
  DrawnChart drawn;
  drawn.draw_points();
  drawn.chart.choose(0, 1);
  EXPECT_FALSE(drawn.chart.readout().isEmpty());
  drawn.chart.draw(report::ScatterPlot());
  EXPECT_TRUE(drawn.chart.readout().isEmpty());
  QTest::keyClick(drawn.chart.canvas(), Qt::Key_Return);
  EXPECT_EQ(drawn.opened.count(), 0);
}

/// What stands at the ticks of the two axes of the first diagram.
std::array<QVector<QString>, 2> tick_labels(Chart& chart) {
  chart.grab();
  auto* const plot = static_cast<QCustomPlot*>(chart.canvas());
  plot->replot(QCustomPlot::rpImmediateRefresh);
  const QCPAxisRect* const rect = plot->axisRects().front();
  return {rect->axis(QCPAxis::atBottom)->tickVectorLabels(), rect->axis(QCPAxis::atLeft)->tickVectorLabels()};
}

TEST(Chart, TicksDoNotRepeat) {
  Chart chart("ticks", "Ticks", {});
  chart.resize(600, 400);
  const report::Series series{"x", {1.085471, 1.0854712}, report::Style::line};
  report::CurvePlot plot{"", {"time (s)", false}, {"x (m)", false}, {1.0, 2.0}, {series}, {}, {}, {}};
  chart.draw(std::vector{plot});
  const QVector<QString> labels = tick_labels(chart)[1];
  EXPECT_GT(labels.size(), 1);
  EXPECT_EQ(QSet<QString>(labels.begin(), labels.end()).size(), labels.size());
}

TEST(Chart, OnePointHasSensibleAxes) {
  Chart chart("one", "One", {});
  chart.resize(600, 400);
  report::CurvePlot plot{"", {"time (s)", false}, {"k (N/m)", true}, {100.0}, {{"x", {3e7}, report::Style::points}}, {}, {}, {}};
  chart.draw(std::vector{plot});
  EXPECT_EQ(chart.shown(), (std::array<double, 2>{80.0, 120.0}));
  for (const QVector<QString>& labels : tick_labels(chart))
    EXPECT_EQ(QSet<QString>(labels.begin(), labels.end()).size(), labels.size());
}

}  // namespace
}  // namespace jointid::gui
