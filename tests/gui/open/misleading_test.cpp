#include <gmock/gmock.h>

#include <QApplication>
#include <QComboBox>
#include <QFileInfo>
#include <QMessageBox>
#include <QSlider>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QTextDocument>
#include <QTimer>
#include <QWheelEvent>

#include "../widgets.hpp"
#include "gui/data/data_page.hpp"
#include "gui/main_window.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/plot/plot_canvas.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/solve_page.hpp"

/// Nothing is lost or changed by accident.
namespace jointid::gui {
namespace {

using testing::HasSubstr;
using testing::Not;

void turn_wheel(QWidget& widget) {
  widget.show();
  widget.setFocus();
  QWheelEvent wheel(QPointF(5, 5), widget.mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &wheel);
}

TEST(QuietWheel, ChangesNoChoiceNumberSliderOrTab) {
  MainWindow window;
  window.show();
  QComboBox box(&window);
  box.addItems({"one", "two", "three"});
  QDoubleSpinBox number(&window);
  number.setValue(5.0);
  QSlider slider(&window);
  slider.setValue(50);
  QTabBar tabs(&window);
  for (const char* title : {"one", "two"}) tabs.addTab(title);
  for (QWidget* chooser : std::initializer_list<QWidget*>{&box, &number, &slider, &tabs}) turn_wheel(*chooser);
  EXPECT_EQ(box.currentIndex(), 0);
  EXPECT_EQ(number.value(), 5.0);
  EXPECT_EQ(slider.value(), 50);
  EXPECT_EQ(tabs.currentIndex(), 0);
  QTest::keyClick(&box, Qt::Key_Down);
  EXPECT_EQ(box.currentIndex(), 1);
}

/// From the picture into the scene and out of it again.
TEST(ExcludedBands, AreDrawnIntoTheSceneAndRemovedByKey) {
  const Measured measured("A1");
  Project project;
  project.resize(1280, 800);
  project.show();
  ASSERT_TRUE(project.open(measured.scene()));
  FrfPlot& plot = *project.data_page()->plot();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !project.data_page()->is_busy() && !plot.curves().empty(); }, 60000));
  const std::string before = project.editor()->text();
  const std::vector<double>& lines = plot.curves().front().frequency_hz;
  ASSERT_GT(lines.size(), 12U);
  Q_EMIT plot.band_chosen(lines[5], lines[10]);
  ASSERT_TRUE(QTest::qWaitFor([&] { return project.checked().scene && !project.checked().scene->frequency.exclude_hz.empty(); }));
  EXPECT_EQ(project.checked().scene->frequency.exclude_hz, (std::vector<ident::Range>{{lines[5], lines[10]}}));
  EXPECT_THAT(project.editor()->text(), HasSubstr("exclude = [["));
  plot.set_cursor(lines[2]);
  QTest::keyClick(find(plot, "frf_canvas"), Qt::Key_Delete);
  EXPECT_THAT(project.editor()->text(), HasSubstr("exclude = [[")) << "the cursor is beside it";
  plot.set_cursor(lines[7]);
  QTest::keyClick(find(plot, "frf_canvas"), Qt::Key_Delete);
  EXPECT_THAT(project.editor()->text(), Not(HasSubstr("exclude = [[")));
  project.undo();
  EXPECT_THAT(project.editor()->text(), HasSubstr("exclude = [["));
  project.undo();
  EXPECT_EQ(project.editor()->text(), before);
}

/// Answers the question that comes, and notes its text.
void answer(QMessageBox::StandardButton with, QString& text) {
  QTimer::singleShot(100, [with, &text] {
    auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr) return;
    text = box->text();
    box->button(with)->click();
  });
}

/// Of a scene that was not saved; a minute is taken for long, here any time.
TEST(MainWindow, ClosingWithRunsThatTookLongAsks) {
  const Measured measured("A1");
  MainWindow window;
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  QTest::keyClick(&window, Qt::Key_N, Qt::ControlModifier);
  ASSERT_EQ(window.count(), 1);
  Project& project = *window.current();
  project.start(read_file(measured.scene()), QFileInfo(measured.scene()).absolutePath());
  SolvePage& page = *project.solve_page();
  const auto rests = [&] { return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000); };
  ASSERT_TRUE(rests());
  page.solve();
  ASSERT_TRUE(rests());
  ASSERT_GT(project.seconds_of_runs(), 0.0);
  project.editor()->document()->setModified(false);
  QString text;
  window.set_long_runs(0.0);
  answer(QMessageBox::Cancel, text);
  EXPECT_FALSE(window.close());
  EXPECT_THAT(text.toStdString(), HasSubstr("They are lost with it"));
  ASSERT_EQ(window.count(), 1);
  window.activateWindow();  // what a window manager does when a dialog closes
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  answer(QMessageBox::Close, text);
  QTest::keyClick(&window, Qt::Key_W, Qt::ControlModifier);
  EXPECT_EQ(window.count(), 0);
}

}  // namespace
}  // namespace jointid::gui
