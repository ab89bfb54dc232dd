#include "gui/plot/frf_plot.hpp"

#include <gmock/gmock.h>

#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"
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
