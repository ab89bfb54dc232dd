#include <gmock/gmock.h>
#include <qcustomplot.h>

#include <QTest>

#include "../widgets.hpp"
#include "gui/plot/chart.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/plot/heat_chart.hpp"
#include "gui/plot/panel_drawing.hpp"
#include "gui/plot/plot_canvas.hpp"

/// The cursor with its values, and numbers at axes.
namespace jointid::gui {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Lines `step` Hz apart from 100 Hz, of growing values.
Curve rising(std::size_t lines, double step, double first = 1.0) {
  Curve made;
  made.name = "x";
  made.response = made.reference = frf::Dof::parse("1:+X");
  for (std::size_t i = 0; i < lines; ++i) {
    made.frequency_hz.push_back(100.0 + step * static_cast<double>(i));
    made.values.emplace_back(first + static_cast<double>(i), 0.0);
  }
  return made;
}

struct Shown {
  FrfPlot plot{QStringLiteral("nothing yet")};
  QWidget* canvas = find(plot, "frf_canvas");

  explicit Shown(const Curve& curve) {
    plot.resize(700, 500);
    plot.show();
    plot.set_curves({curve});
    (void)QTest::qWaitForWindowExposed(&plot);
    QCoreApplication::processEvents();
  }
  std::string readout() const { return plot.readout().toStdString(); }
  /// The upper left axis, drawn now.
  const QCPAxis& value_axis() {
    plot.grab();
    QCustomPlot* const drawn = plot.canvas().plot();
    drawn->replot(QCustomPlot::rpImmediateRefresh);
    return *drawn->axisRects().front()->axis(QCPAxis::atLeft);
  }
};

TEST(FrfCursor, StatesTheLineWhereItIs) {
  Shown shown(rising(51, 10.0));
  shown.plot.set_cursor(203.0);
  EXPECT_THAT(shown.readout(), StartsWith("200 Hz"));
  EXPECT_THAT(shown.readout(), HasSubstr("11"));
  EXPECT_EQ(shown.plot.canvas().cursor_hz(), 200.0);
}

TEST(FrfCursor, ItsValuesStayWithItWhenOtherCurvesAreDrawn) {
  Shown shown(rising(51, 10.0));
  shown.plot.set_cursor(200.0);
  shown.plot.set_decibel(true);
  EXPECT_THAT(shown.readout(), HasSubstr("dB re"));
  shown.plot.set_view(View::real_imaginary);
  EXPECT_THAT(shown.readout(), StartsWith("200 Hz"));
  shown.plot.set_curves({rising(11, 55.0)});
  EXPECT_THAT(shown.readout(), StartsWith("210 Hz")) << "the nearest line of the others";
  EXPECT_EQ(shown.plot.canvas().cursor_hz(), 210.0);
  shown.plot.set_curves({});
  EXPECT_EQ(shown.readout(), "");
}

TEST(FrfCursor, ItsValuesGoWithItOutOfThePicture) {
  Shown shown(rising(51, 10.0));
  shown.plot.set_cursor(200.0);
  shown.plot.canvas().show_range({300.0, 400.0});
  EXPECT_EQ(shown.readout(), "");
  QTest::keyClick(shown.canvas, Qt::Key_Home);
  EXPECT_THAT(shown.readout(), StartsWith("200 Hz"));
}

TEST(FrfAxes, OfASingleLineAreSensible) {
  Shown shown(rising(1, 1.0, 3e7));
  for (const bool decibel : {false, true}) {
    shown.plot.set_decibel(decibel);
    const QCPAxis& y = shown.value_axis();
    const double value = decibel ? 20.0 * std::log10(3e7) : 3e7;
    EXPECT_LT(y.range().lower, value);
    EXPECT_GT(y.range().upper, value);
    EXPECT_GT(y.range().lower, value / 100.0);
    EXPECT_LT(y.range().upper, value * 100.0);
    const QVector<QString> labels = y.tickVectorLabels();
    EXPECT_GE(labels.size(), 1);
    EXPECT_EQ(QSet<QString>(labels.begin(), labels.end()).size(), labels.size());
  }
  EXPECT_EQ(shown.plot.canvas().shown_hz(), (ident::Range{99.5, 100.5}));
}

/// Of values that differ in their sixth digit.
TEST(FrfAxes, TicksDoNotRepeat) {
  Curve curve = rising(3, 1.0);
  curve.values = {1.085471, 1.085472, 1.085473};
  Shown shown(curve);
  shown.plot.set_view(View::real_imaginary);
  const QVector<QString> labels = shown.value_axis().tickVectorLabels();
  EXPECT_GT(labels.size(), 1);
  EXPECT_EQ(QSet<QString>(labels.begin(), labels.end()).size(), labels.size()) << QStringList(labels).join(' ').toStdString();
}

/// Names of axes, with units or without, and numbers as they are in tables.
TEST(FrfAxes, SpeakGerman) {
  const Spoken german("de");
  for (const char* label : {"frequency (Hz)", "receptance (m/N)", "time of one solution (ms)", "rms relative error (median)",
                            "iteration", "objective", "displacement (mm)", "amplitude (m)", "order (pole pairs)"})
    EXPECT_NE(axis_text(label).toStdString(), label);
  EXPECT_EQ(axis_text("receptance (m/N)").toStdString(), "Rezeptanz (m/N)");
  EXPECT_EQ(axis_text("Z(1,2) (N/m)").toStdString(), "Z(1,2) (N/m)");
  const QLocale before;
  QLocale::setDefault(QLocale(QLocale::German));
  Curve curve = rising(3, 1.0);
  curve.values = {0.25, 0.5, 0.75};
  Shown shown(curve);
  shown.plot.set_view(View::real_imaginary);
  const QString labels = QStringList(shown.value_axis().tickVectorLabels()).join(' ');
  QLocale::setDefault(before);
  EXPECT_THAT(labels.toStdString(), testing::AllOf(HasSubstr("0.5"), testing::Not(HasSubstr(","))));
}

/// As many names in a row as there is room for.
TEST(Chart, NamesStandBesideEachOtherInAWideDiagram) {
  Chart chart("wide", "Wide", {});
  report::ScatterPlot points;
  for (const char* name : {"a", "b", "c", "d", "e"}) points.groups.push_back({name, {{1.0, 1.0, {}}, {2.0, 3.0, {}}}});
  chart.resize(900, 400);
  chart.show();
  chart.draw(points);
  QCoreApplication::processEvents();
  auto* const plot = static_cast<QCustomPlot*>(chart.canvas());
  EXPECT_EQ(plot->legend->rowCount(), 1);
  chart.resize(250, 400);
  QCoreApplication::processEvents();
  EXPECT_GT(plot->legend->rowCount(), 1);
  EXPECT_GE(plot->minimumHeight(), 200);
}

TEST(HeatChart, TicksOfItsColoursDoNotRepeat) {
  HeatChart chart("map", "A map", "nothing yet");
  chart.resize(600, 400);
  chart.show();
  chart.draw({.x_label = "f",
              .y_label = "level",
              .value_label = "x",
              .columns = {"1", "2"},
              .x_values = {},
              .rows = {"a"},
              .values = {1.085471, 1.0854712}});
  chart.grab();
  auto* const plot = static_cast<QCustomPlot*>(chart.canvas());
  plot->replot(QCustomPlot::rpImmediateRefresh);
  const auto* const scale = qobject_cast<QCPColorScale*>(plot->plotLayout()->element(0, 1));
  ASSERT_NE(scale, nullptr);
  const QVector<QString> labels = scale->axis()->tickVectorLabels();
  EXPECT_NEAR(scale->dataRange().upper, 1.0854712, 1e-12);
  EXPECT_GT(labels.size(), 1);
  EXPECT_EQ(QSet<QString>(labels.begin(), labels.end()).size(), labels.size()) << QStringList(labels).join(' ').toStdString();
}

}  // namespace
}  // namespace jointid::gui
