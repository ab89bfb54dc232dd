#include "gui/plot/frf_plot.hpp"

#include <gmock/gmock.h>

#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QSet>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"
#include "gui/look/theme.hpp"
#include "gui/plot/plot_canvas.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

/// One resonance at a third of the range; `lines` from 10 Hz up to `last_hz`.
Curve resonance(std::size_t lines, double last_hz, double height = 1.0) {
  Curve made;
  made.name = "x";
  made.response = made.reference = frf::Dof::parse("1:+X");
  for (std::size_t i = 0; i < lines; ++i) {
    const double f = 10.0 + (last_hz - 10.0) * static_cast<double>(i) / static_cast<double>(lines - 1), r = 3.0 * f / last_hz;
    made.frequency_hz.push_back(f);
    made.values.push_back(height / Complex(1.0 - r * r, 0.02));
  }
  return made;
}

struct Drawn {
  FrfPlot plot{QStringLiteral("nothing yet")};
  QWidget* canvas = find(plot, "frf_canvas");

  explicit Drawn(std::size_t lines = 991) {
    plot.resize(700, 500);
    plot.let_exclude();
    plot.show();
    plot.set_curves({resonance(lines, 1000.0), resonance(lines, 1000.0, 3.0)});
    (void)QTest::qWaitForWindowExposed(&plot);
    QCoreApplication::processEvents();  // replots are queued, and the axes have their places after them
  }
  /// Sent to the canvas itself: QTest::mouseMove moves the pointer of a real screen, and whether its event comes is the window
  /// system's.
  void move_mouse(QPoint to, Qt::MouseButtons buttons = Qt::NoButton) {
    QMouseEvent event(QEvent::MouseMove, to, canvas->mapToGlobal(to), Qt::NoButton, buttons, Qt::NoModifier);
    QApplication::sendEvent(canvas, &event);
  }
  void drag(double from, double to) {
    const auto at = [&](double share) { return QPoint(static_cast<int>(share * canvas->width()), canvas->height() / 3); };
    QTest::mousePress(canvas, Qt::LeftButton, Qt::NoModifier, at(from));
    move_mouse(at((from + to) / 2), Qt::LeftButton);
    move_mouse(at(to), Qt::LeftButton);
    QTest::mouseRelease(canvas, Qt::LeftButton, Qt::NoModifier, at(to));
    plot.grab();
  }
};

/// The lightest pixel of the margin with the labels of the ordinates.
int lightest_of_labels(QWidget& canvas) {
  const QImage image = canvas.grab(QRect(0, 20, 60, canvas.height() - 60)).toImage();
  int lightest = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) lightest = std::max(lightest, image.pixelColor(x, y).lightness());
  }
  return lightest;
}

TEST(FrfPlot, LabelsAreLightAfterTheThemeBecomesDark) {
  Drawn drawn;
  drawn.plot.set_cursor(420.0);
  QTest::qWait(50);
  apply(Theme::dark, *qApp);
  QTest::qWait(50);
  EXPECT_GT(lightest_of_labels(*drawn.canvas), 150);
  apply(Theme::light, *qApp);
}

TEST(FrfPlot, TheReadoutHasTheColoursOfTheThemeThatIsOn) {
  Drawn drawn;
  drawn.plot.set_cursor(420.0);
  const auto* const label = find<QLabel>(drawn.plot, "readout");
  EXPECT_THAT(label->text().toStdString(), HasSubstr(curve_colour(Theme::light, 1).name().toStdString()));
  apply(Theme::dark, *qApp);
  QCoreApplication::processEvents();
  const std::string dark = label->text().toStdString();
  apply(Theme::light, *qApp);
  EXPECT_THAT(dark, HasSubstr(curve_colour(Theme::dark, 1).name().toStdString()));
  EXPECT_THAT(dark, testing::Not(HasSubstr(curve_colour(Theme::light, 1).name().toStdString())));
}

TEST(FrfPlot, DrawsEveryView) {
  Drawn drawn;
  drawn.plot.offer(View::difference);
  QByteArray before;
  for (const View view : {View::magnitude_phase, View::real_imaginary, View::nyquist, View::coherence, View::difference}) {
    drawn.plot.set_view(view);
    EXPECT_EQ(drawn.plot.view(), view);
    drawn.plot.set_cursor(400.0);
    const QByteArray now = drawn.plot.canvas().picture("png");
    EXPECT_NE(now, before);
    before = now;
  }
}

TEST(FrfPlot, MarkedLinesAreSeen) {
  Drawn drawn;
  const QByteArray before = drawn.plot.canvas().picture("png");
  drawn.plot.set_marked({200.0, 700.0});
  EXPECT_NE(drawn.plot.canvas().picture("png"), before);
  drawn.plot.set_marked({});
  EXPECT_EQ(drawn.plot.canvas().picture("png"), before);
}

TEST(FrfPlot, DraggingZoomsAndADoubleClickShowsAll) {
  Drawn drawn;
  drawn.drag(0.4, 0.6);
  const auto [low, high] = drawn.plot.canvas().shown_hz();
  EXPECT_GT(low, 200.0);
  EXPECT_LT(high, 800.0);
  QTest::mouseDClick(drawn.canvas, Qt::LeftButton, Qt::NoModifier, drawn.canvas->rect().center());
  EXPECT_EQ(drawn.plot.canvas().shown_hz(), (ident::Range{10.0, 1000.0}));
}

TEST(FrfPlot, WithExcludeADragNamesABand) {
  Drawn drawn;
  QSignalSpy chosen(&drawn.plot, &FrfPlot::band_chosen);
  find<QToolButton>(drawn.plot, "plot_exclude")->click();
  drawn.drag(0.6, 0.4);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_LT(chosen.front().at(0).toDouble(), chosen.front().at(1).toDouble());
  EXPECT_EQ(drawn.plot.canvas().shown_hz(), (ident::Range{10.0, 1000.0}));
  drawn.drag(0.5, 0.501);
  EXPECT_EQ(chosen.count(), 1);
}

TEST(FrfPlot, TheKeyboardMovesTheCursorAndZooms) {
  Drawn drawn;
  drawn.plot.set_cursor(400.0);
  QTest::keyClick(drawn.canvas, Qt::Key_Right);
  EXPECT_THAT(drawn.plot.readout().toStdString(), HasSubstr("401 Hz"));
  QTest::keyClick(drawn.canvas, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_THAT(drawn.plot.readout().toStdString(), HasSubstr("391 Hz"));
  QTest::keyClick(drawn.canvas, Qt::Key_Plus);
  EXPECT_LT(drawn.plot.canvas().shown_hz()[1], 1000.0);
  QTest::keyClick(drawn.canvas, Qt::Key_Home);
  EXPECT_EQ(drawn.plot.canvas().shown_hz()[1], 1000.0);
}

TEST(FrfPlot, TheMouseMovesTheCursor) {
  Drawn drawn;
  QSignalSpy moved(&drawn.plot, &FrfPlot::cursor_moved);
  drawn.move_mouse(QPoint(drawn.canvas->width() / 2, drawn.canvas->height() / 3));
  ASSERT_GE(moved.count(), 1);
  EXPECT_THAT(drawn.plot.readout().toStdString(), HasSubstr("m/N"));
}

TEST(FrfPlot, DecibelsAreOnALinearAxisAndInTheReadout) {
  Drawn drawn;
  drawn.plot.set_decibel(true);
  drawn.plot.set_cursor(1000.0);
  EXPECT_THAT(drawn.plot.readout().toStdString(), HasSubstr("dB re 1 m/N"));
  EXPECT_LT(drawn.plot.canvas().shown_ordinates()[0], 0.0);
  drawn.plot.set_decibel(false);
  EXPECT_GT(drawn.plot.canvas().shown_ordinates()[0], 0.0);
}

TEST(FrfPlot, ASecondCursorTellsDifferences) {
  Drawn drawn;
  drawn.plot.set_cursor(400.0);
  QTest::keyClick(drawn.canvas, Qt::Key_M);
  drawn.plot.set_cursor(420.0);
  EXPECT_THAT(drawn.plot.readout().toStdString(), HasSubstr("420 Hz, Δ +20 Hz from 400 Hz"));
  EXPECT_THAT(drawn.plot.readout().toStdString(), HasSubstr("Δ -"));
  QTest::keyClick(drawn.canvas, Qt::Key_M);
  EXPECT_THAT(drawn.plot.readout().toStdString(), testing::Not(HasSubstr("Δ")));
}

TEST(FrfPlot, OrdinatesZoomByKeyAndWheel) {
  Drawn drawn;
  drawn.plot.set_decibel(true);
  const auto size = [&] { return drawn.plot.canvas().shown_ordinates()[1] - drawn.plot.canvas().shown_ordinates()[0]; };
  const double before = size();
  QTest::keyClick(drawn.canvas, Qt::Key_Up);
  EXPECT_LT(size(), before);
  QWheelEvent wheel(QPointF(50, 50), drawn.canvas->mapToGlobal(QPointF(50, 50)), {}, {0, -120}, Qt::NoButton, Qt::ControlModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(drawn.canvas, &wheel);
  EXPECT_NEAR(size(), before, 1e-9 * before);
  EXPECT_EQ(drawn.plot.canvas().shown_hz(), (ident::Range{10.0, 1000.0}));
}

/// The curve's place is where the readout is bold.
TEST(FrfPlot, TheCurveUnderTheMouseIsNamed) {
  Drawn drawn;
  auto* const label = find<QLabel>(drawn.plot, "readout");
  QSet<QString> bold;
  for (int y = 0; y < drawn.canvas->height(); y += 3) {
    drawn.move_mouse(QPoint(drawn.canvas->width() / 2, y));
    EXPECT_THAT(label->text().toStdString(), HasSubstr("&#9632;"));  // the legend
    const qsizetype place = label->text().indexOf("<b>");
    if (place >= 0) bold << label->text().left(place).section("color:", -1).left(7);
  }
  EXPECT_EQ(bold.size(), 2);
}

TEST(FrfPlot, PeaksAreListedAndMoveTheCursor) {
  Drawn drawn;
  QMenu& menu = *find<QToolButton>(drawn.plot, "plot_peaks")->menu();
  Q_EMIT menu.aboutToShow();
  ASSERT_EQ(menu.actions().size(), 1);
  EXPECT_THAT(menu.actions().front()->text().toStdString(), testing::StartsWith("333 Hz"));
  menu.actions().front()->trigger();
  EXPECT_THAT(drawn.plot.readout().toStdString(), testing::StartsWith("333 Hz"));
}

TEST(FrfPlot, KeysAskForTheNextFrfAndTakeBandsBackIn) {
  Drawn drawn;
  QSignalSpy next(&drawn.plot, &FrfPlot::next_wanted), unwanted(&drawn.plot, &FrfPlot::band_unwanted);
  QTest::keyClick(drawn.canvas, Qt::Key_PageDown);
  QTest::keyClick(drawn.canvas, Qt::Key_PageUp);
  ASSERT_EQ(next.count(), 2);
  EXPECT_EQ(next[0][0].toInt(), 1);
  EXPECT_EQ(next[1][0].toInt(), -1);
  drawn.plot.set_bands({{100.0, 200.0}}, {});
  drawn.plot.set_cursor(300.0);
  QTest::keyClick(drawn.canvas, Qt::Key_Delete);
  EXPECT_EQ(unwanted.count(), 0);
  drawn.plot.set_cursor(150.0);
  QTest::keyClick(drawn.canvas, Qt::Key_Delete);
  ASSERT_EQ(unwanted.count(), 1);
  EXPECT_EQ(unwanted[0][0].toDouble(), 100.0);
}

TEST(FrfPlot, ExcludedBandsSnapToLines) {
  Drawn drawn(100);  // lines 10 Hz apart
  QSignalSpy chosen(&drawn.plot, &FrfPlot::band_chosen);
  find<QToolButton>(drawn.plot, "plot_exclude")->click();
  drawn.drag(0.4, 0.61);
  ASSERT_EQ(chosen.count(), 1);
  for (const int end : {0, 1}) EXPECT_NEAR(std::remainder(chosen.front().at(end).toDouble(), 10.0), 0.0, 1e-9);
}

TEST(FrfPlot, AWindowOfItsOwnHasCurvesViewAndCursor) {
  Drawn drawn;
  drawn.plot.set_view(View::real_imaginary);
  FrfPlot* const twin = drawn.plot.pop_out();
  EXPECT_TRUE(twin->isWindow());
  EXPECT_EQ(twin->curves().size(), 2U);
  EXPECT_EQ(twin->view(), View::real_imaginary);
  Q_EMIT drawn.plot.cursor_moved(500.0);
  EXPECT_THAT(twin->readout().toStdString(), testing::StartsWith("500 Hz"));
  delete twin;
}

TEST(FrfPlot, SavesPicturesAndTables) {
  Drawn drawn;
  const QTemporaryDir folder;
  const auto save = [&](const char* name) {
    drawn.plot.save(folder.filePath(name));
    return read_file(folder.filePath(name));
  };
  EXPECT_THAT(save("a.svg"), HasSubstr("<svg"));
  EXPECT_THAT(save("a.pdf"), testing::StartsWith("%PDF"));
  EXPECT_THAT(save("a.csv"), testing::StartsWith("frequency_hz"));
  save("a.png");
  EXPECT_GT(QImage(folder.filePath("a.png")).width(), 700);
  EXPECT_THROW(save("a.docx"), InputError);
  EXPECT_THROW(save("no/such/folder/a.png"), InputError);
}

TEST(FrfPlot, NeverSavesOverAnInput) {
  Drawn drawn;
  const QTemporaryDir folder;
  write_file(folder.filePath("frfs.csv"), "measured");
  drawn.plot.protect({folder.filePath("frfs.csv").toStdString()});
  EXPECT_THROW(drawn.plot.save(folder.filePath("frfs.csv")), InputError);
  EXPECT_EQ(read_file(folder.filePath("frfs.csv")), "measured");
}

TEST(FrfPlot, NothingToDrawIsBorne) {
  Drawn drawn;
  drawn.plot.set_bands({{100.0, 200.0}}, ident::Range{50.0, 500.0});
  drawn.plot.set_curves({});
  drawn.plot.set_cursor(1.0);
  QTest::keyClick(drawn.canvas, Qt::Key_Right);
  drawn.drag(0.2, 0.8);
  Curve single = resonance(2, 20.0);
  single.frequency_hz.resize(1);
  single.values.resize(1);
  drawn.plot.set_curves({single});
  drawn.plot.grab();
}

TEST(FrfPlot, TimeToDrawAMillionPointsIsTold) {
  Drawn drawn(1000000);
  const auto start = std::chrono::steady_clock::now();
  constexpr int times = 5;
  for (int i = 0; i < times; ++i) {
    drawn.plot.canvas().show_range({10.0 + i, 900.0});
    QApplication::processEvents();
  }
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  std::printf("%.0f ms for two curves of a million points\n", spent.count() / times);
  RecordProperty("milliseconds", static_cast<int>(spent.count() / times));
}

}  // namespace
}  // namespace jointid::gui
