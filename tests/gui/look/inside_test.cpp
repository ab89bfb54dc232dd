#include <gmock/gmock.h>
#include <qcustomplot.h>

#include <QAbstractScrollArea>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTest>

#include "../widgets.hpp"
#include "gui/begin/example_dialog.hpp"
#include "gui/data/data_page.hpp"
#include "gui/geometry/structure_view.hpp"
#include "gui/help/help_window.hpp"
#include "gui/look/language.hpp"
#include "gui/main_window.hpp"
#include "gui/open/variable_dialog.hpp"
#include "gui/project.hpp"
#include "gui/records/records_page.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/solve_page.hpp"

namespace jointid::gui {
namespace {

/// Whether all of it is seen.
bool shows_all(const QWidget& widget) {
  const auto* const area = qobject_cast<const QScrollArea*>(&widget);
  return area != nullptr && area->viewport()->rect().contains(area->widget()->geometry());
}

/// What a scroll area shows may be larger than it.
bool is_scrolled(const QWidget& widget) {
  for (const QWidget* each = widget.parentWidget(); each != nullptr && !each->isWindow(); each = each->parentWidget()) {
    if (shows_all(*each)) continue;
    if (qobject_cast<const QAbstractScrollArea*>(each) != nullptr || qobject_cast<const QTabBar*>(each) != nullptr) return true;
  }
  return false;
}

QString title_of(const QWidget& widget) {
  return QString::fromLatin1(widget.metaObject()->className()) + " " + widget.objectName() + " " + widget.accessibleName();
}

/// Visible widgets that do not lie inside of the window, or inside of the widget that holds them, and buttons that cut their
/// texts.
QStringList outside(QWidget& window) {
  QStringList found;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->window() != &window || is_scrolled(*widget) || widget->size().isEmpty()) continue;
    const QRect place(widget->mapTo(&window, QPoint(0, 0)), widget->size());
    if (!window.rect().contains(place)) found << "outside: " + title_of(*widget);
    if (!widget->parentWidget()->rect().contains(widget->geometry())) found << "cut: " + title_of(*widget);
    const auto* button = qobject_cast<const QPushButton*>(widget);
    if (button != nullptr && button->width() < button->minimumSizeHint().width()) found << "narrow: " + title_of(*widget);
  }
  return found;
}

/// Plots, pictures and tables in which something is picked, that are too small for it.
QStringList too_small(QWidget& window) {
  constexpr int least_px = 200;
  QStringList found;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->window() != &window) continue;
    const bool is_picked_in =
        qobject_cast<const QCustomPlot*>(widget) != nullptr || qobject_cast<const StructureView*>(widget) != nullptr ||
        qobject_cast<const QTableView*>(widget) != nullptr || qobject_cast<const QListWidget*>(widget) != nullptr;
    if (!is_picked_in || (widget->width() >= least_px && widget->height() >= least_px)) continue;
    found << QStringLiteral("%1: %2 × %3").arg(title_of(*widget)).arg(widget->width()).arg(widget->height());
  }
  return found;
}

void expect_inside(QWidget& window, const QSize& size, const std::string& where) {
  QApplication::processEvents();
  for (const QScrollArea* area : window.findChildren<QScrollArea*>()) {
    const bool is_of_page = area->isVisible() && area->objectName().endsWith(QLatin1String("_scrolled"));
    EXPECT_TRUE(!is_of_page || shows_all(*area)) << where << ": " << area->objectName().toStdString();
  }
  EXPECT_LE(window.minimumSizeHint().height(), 720) << where << ": a title and a panel need room, too";
  EXPECT_EQ(too_small(window).join("\n").toStdString(), "") << where;
  EXPECT_EQ(window.size(), size) << where;
  EXPECT_EQ(outside(window).join("\n").toStdString(), "") << where;
}

/// All pages of a scene and all its results.
void look_at_pages(MainWindow& window, const QSize& size, const std::string& where) {
  Project& project = *window.current();
  for (int page = 0; page < project.pages()->count(); ++page) {
    project.pages()->setCurrentIndex(page);
    QTest::qWait(20);
    expect_inside(window, size, where + ", page " + project.pages()->tabText(page).toStdString());
  }
  project.pages()->setCurrentWidget(project.records_page());
  auto* const tools = find<QComboBox>(*project.records_page(), "records_tool");
  for (int tool = 0; tool < tools->count(); ++tool) {
    tools->setCurrentIndex(tool);
    expect_inside(window, size, where + ", records: " + tools->currentText().toStdString());
  }
  project.pages()->setCurrentWidget(project.solve_page());
  for (int result = 0; result < project.solve_page()->results()->count(); ++result) {
    if (!project.solve_page()->results()->isTabVisible(result)) continue;
    project.solve_page()->results()->setCurrentIndex(result);
    expect_inside(window, size, where + ", result " + project.solve_page()->results()->tabText(result).toStdString());
  }
  project.switch_view(true);
  expect_inside(window, size, where + ", form");
  project.switch_view(false);
}

/// The walk itself finds what it is to find.
TEST(OutsideOfWindow, IsFound) {
  QWidget window;
  window.setObjectName("window");
  window.resize(200, 100);
  QPushButton inside("yes", &window), beyond("no", &window), narrow("a rather long text", &window);
  inside.setGeometry(5, 5, 90, 30);
  window.show();
  narrow.setGeometry(5, 60, 20, 30);
  beyond.setGeometry(150, 40, 90, 30);
  const QStringList found = outside(window);
  EXPECT_THAT(found.join("\n").toStdString(), testing::AllOf(testing::HasSubstr("outside: "), testing::HasSubstr("narrow: ")));
  EXPECT_EQ(found.size(), 3) << found.join("\n").toStdString();
  beyond.move(100, 40);
  narrow.resize(narrow.sizeHint());
  EXPECT_TRUE(outside(window).isEmpty());
}

class Inside : public testing::TestWithParam<const char*> {};

TEST_P(Inside, NoWidgetLiesOutsideOfItsWindow) {
  ASSERT_TRUE(has_language(QString::fromLatin1(GetParam())));
  const Spoken spoken(GetParam());
  const Measured measured("A1");
  for (const QSize size : {QSize(1280, 800), QSize(1024, 768)}) {
    const std::string where = std::string(GetParam()) + " " + std::to_string(size.width());
    MainWindow window;
    window.resize(size);
    window.show();
    expect_inside(window, size, where + ", empty");
    window.open({measured.scene()});
    Project& project = *window.current();
    const auto rests = [&] {
      return QTest::qWaitFor([&] { return !project.solve_page()->is_busy() && !project.data_page()->is_busy(); }, 60000);
    };
    ASSERT_TRUE(rests());
    project.solve_page()->solve();
    ASSERT_TRUE(rests());
    ASSERT_FALSE(project.solve_page()->runs().empty());
    look_at_pages(window, size, where);
  }
}

TEST_P(Inside, DialogsFitASmallScreen) {
  ASSERT_TRUE(has_language(QString::fromLatin1(GetParam())));
  const Spoken spoken(GetParam());
  const Measured measured("A1");
  MainWindow window;
  window.resize(1024, 768);
  window.show();
  window.open({measured.scene()});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.current()->data_page()->is_busy(); }, 60000));
  window.current()->open_joint_assistant();
  auto* const assistant = window.findChild<QDialog*>(QStringLiteral("joint_assistant"));
  ASSERT_NE(assistant, nullptr);
  ExampleDialog examples;
  VariableDialog variables({{QStringLiteral("a_rather_long_name_of_a_file.mat"), {QStringLiteral("H1"), QStringLiteral("H2")}}});
  HelpWindow help;
  for (QDialog* dialog : std::initializer_list<QDialog*>{assistant, &examples, &variables, &help}) {
    dialog->show();
    QApplication::processEvents();
    EXPECT_LE(dialog->width(), 1024) << dialog->objectName().toStdString();
    EXPECT_LE(dialog->height(), 720) << dialog->objectName().toStdString();
    EXPECT_EQ(outside(*dialog).join("\n").toStdString(), "") << dialog->objectName().toStdString();
    dialog->close();
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, Inside, testing::Values("en", "de"));

}  // namespace
}  // namespace jointid::gui
