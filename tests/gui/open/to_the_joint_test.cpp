#include <gmock/gmock.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QTextDocument>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "../widgets.hpp"
#include "gui/data/data_page.hpp"
#include "gui/loading_curve/loading_curve_page.hpp"
#include "gui/main_window.hpp"
#include "gui/page/plot_menu.hpp"
#include "gui/plot/chart.hpp"
#include "gui/project.hpp"
#include "gui/records/records_page.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/table/cell_table.hpp"

/// From what was measured to the joint, by mouse; and what is drawn of files before anything is run.
namespace jointid::gui {
namespace {

using testing::HasSubstr;

bool wait(const std::function<bool()>& came) { return QTest::qWaitFor(came, 60000); }

void click(QWidget& widget) { QTest::mouseClick(&widget, Qt::LeftButton); }

/// An entry of a menu, both clicked.
void choose_entry(MainWindow& window, const QString& menu, const QString& entry) {
  for (QAction* each : window.menuBar()->actions()) {
    if (each->text() != menu) continue;
    QTest::mouseClick(window.menuBar(), Qt::LeftButton, Qt::NoModifier, window.menuBar()->actionGeometry(each).center());
    for (QAction* action : each->menu()->actions()) {
      if (action->text() == entry)
        return QTest::mouseClick(each->menu(), Qt::LeftButton, Qt::NoModifier, each->menu()->actionGeometry(action).center());
    }
  }
  FAIL() << "there is no " << entry.toStdString();
}

/// An item of a list that opens.
void choose_item(QComboBox& box, const QString& text) {
  const int row = box.findText(text, Qt::MatchStartsWith);
  ASSERT_GE(row, 0) << text.toStdString();
  box.showPopup();
  QAbstractItemView& view = *box.view();
  const QModelIndex index = box.model()->index(row, 0);
  view.scrollTo(index);
  QTest::qWait(QApplication::doubleClickInterval() + 50);  // a click before that is the one that opened it
  QTest::mouseClick(view.viewport(), Qt::LeftButton, Qt::NoModifier, view.visualRect(index).center());
  ASSERT_EQ(box.currentIndex(), row) << text.toStdString();
}

TEST(ToTheJoint, FromPlainFilesToSpringsPerBoltByMouse) {
  const Measured rig("bolts", "uff");
  const QTemporaryDir folder;
  MainWindow window;
  window.resize(1280, 800);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  ASSERT_TRUE(drop(window, without_positions(rig.files(), folder)));
  ASSERT_TRUE(wait([&] { return window.count() == 1 && !window.current()->data_page()->is_busy(); }));
  Project& project = *window.current();
  ASSERT_TRUE(wait([&] { return project.data_page()->files().size() == 3; }));
  choose_entry(window, "&Edit", "&Joint assistant…");
  auto* const assistant = project.findChild<QDialog*>("joint_assistant");
  ASSERT_NE(assistant, nullptr);
  for (const auto& [below, above] :
       {std::pair("118", "201"), std::pair("120", "203"), std::pair("128", "211"), std::pair("130", "213")}) {
    choose_item(*find<QComboBox>(*assistant, "joint_first"), below);
    choose_item(*find<QComboBox>(*assistant, "joint_second"), above);
    click(*find(*assistant, "joint_add"));
  }
  click(*assistant->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok));
  ASSERT_TRUE(project.checked().scene) << project.editor()->text();
  QTabBar& bar = *project.pages()->tabBar();
  QTest::mouseClick(&bar, Qt::LeftButton, Qt::NoModifier, bar.tabRect(project.pages()->indexOf(project.solve_page())).center());
  click(*find(*project.solve_page(), "solve"));
  ASSERT_TRUE(wait([&] { return !project.solve_page()->runs().empty(); })) << project.solve_page()->status().toStdString();
  const ident::Solution& solution = project.solve_page()->runs().front().solution;
  ASSERT_EQ(solution.unknowns.size(), 24U);
  const double truth[] = {1.0e8, 1.1e8, 2.0e8};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(solution.unknowns[i].value, truth[i], 0.05 * truth[i]) << solution.unknowns[i].name;
  project.editor()->document()->setModified(false);
}

/// Two free masses of 2 and 3 kg, hit three times at the first one; `coupled` by a spring and a damper.
constexpr double first_kg = 2.0, second_kg = 3.0, rate_hz = 2048.0;
const double reduced_kg = first_kg * second_kg / (first_kg + second_kg), omega = 2.0 * std::numbers::pi * 60.0,
             spring = omega * omega * reduced_kg, damper = 0.1 * omega * reduced_kg;

/// A half sine of 8 samples, a second apart.
double force_at(double seconds) {
  const double in = std::fmod(seconds, 1.0) - 0.1, length = 8.0 / rate_hz;
  return in > 0.0 && in < length ? 100.0 * std::sin(std::numbers::pi * in / length) : 0.0;
}

std::string record_of_mass(double kg) {
  std::string text = "time [s],hammer [N],a [m/s^2],c [m/s^2]\n";
  for (int i = 0; i < 3 * static_cast<int>(rate_hz); ++i) {
    const QString motion = QString::number(force_at(i / rate_hz) / kg, 'g', 12);  // of both sensors of a rigid mass
    text += QStringLiteral("%1,%2,%3,%3\n")
                .arg(i / rate_hz, 0, 'g', 12)
                .arg(force_at(i / rate_hz), 0, 'g', 12)
                .arg(motion)
                .toStdString();
  }
  return text;
}

/// In small steps of the midpoint rule.
std::string record_of_both() {
  constexpr int fine = 32;
  const double h = 1.0 / (rate_hz * fine);
  double gap = 0.0, speed = 0.0;  // of the first mass less the second
  const auto pull = [&](double x, double v) { return spring * x + damper * v; };
  const auto slope = [&](double t, double x, double v) { return force_at(t) / first_kg - pull(x, v) / reduced_kg; };
  std::string text = "time [s],hammer [N],a [m/s^2],b [m/s^2],c [m/s^2]\n";
  for (int i = 0; i < 3 * static_cast<int>(rate_hz); ++i) {
    const double t = i / rate_hz, between = pull(gap, speed);
    text += QStringLiteral("%1,%2,%3,%4,%3\n")
                .arg(t, 0, 'g', 12)
                .arg(force_at(t), 0, 'g', 12)
                .arg((force_at(t) - between) / first_kg, 0, 'g', 12)
                .arg(between / second_kg, 0, 'g', 12)
                .toStdString();
    for (int k = 0; k < fine; ++k) {
      const double now = t + k * h, half_gap = gap + 0.5 * h * speed, half_speed = speed + 0.5 * h * slope(now, gap, speed);
      gap += h * half_speed;
      speed += h * slope(now + 0.5 * h, half_gap, half_speed);
    }
  }
  return text;
}

/// FRFs of the impacts at two points of a rigid mass, which one record holds for, into the scene.
void take_records(RecordsPage& page, const QString& record, const QString& channels, const QString& points, bool of_assembly) {
  const QString other = QString(record).replace(".csv", "_other.csv");
  write_file(other, read_file(record));
  page.open({record, other});
  ASSERT_TRUE(wait([&] { return !page.is_busy(); }));
  page.choose_tool("frf");
  const std::pair<const char*, QString> fields[] = {
      {"channel", channels}, {"reference", points}, {"block", "0.8"}, {"pretrigger", "0.02"}};
  for (const auto& [field, text] : fields) find<QLineEdit>(page, (std::string("records_frf_") + field).c_str())->setText(text);
  page.run();
  ASSERT_TRUE(wait([&] { return !page.is_busy(); }));
  ASSERT_NE(page.shown(), nullptr) << page.status().toStdString();
  find<QComboBox>(page, "records_role")->setCurrentIndex(of_assembly ? 1 : 0);
  page.write_frfs(QString(record).replace(".csv", ".h5"));
}

/// The assembly was not hit at node 2: the likelihood needs a start.
constexpr const char* joint_of_records = R"(
[frequency]
range = [20, 150]

[joint]
dofs = ["1:+Z", "2:+Z"]

[joint.stiffness]
springs = [["1:+Z", "2:+Z"]]

[joint.viscous_damping]
springs = [["1:+Z", "2:+Z"]]

[identify]
method = "likelihood"
start = { stiffness = [[1e5, -1e5], [-1e5, 1e5]], viscous_damping = [[30, -30], [-30, 30]] }
)";

TEST(ToTheJoint, FromRecordsOfAHammerToTheSpring) {
  const QTemporaryDir folder;
  const QString one = folder.filePath("one.csv"), two = folder.filePath("two.csv"), both = folder.filePath("both.csv");
  write_file(one, record_of_mass(first_kg));
  write_file(two, record_of_mass(second_kg));
  write_file(both, record_of_both());
  MainWindow window;
  window.show();
  window.open({one});
  ASSERT_TRUE(wait([&] { return window.count() == 1; }));
  Project& project = *window.current();
  RecordsPage& page = *project.records_page();
  take_records(page, one, "hammer=1:+Z N; a=1:+Z m/s^2; c=3:+Z m/s^2", "1:+Z, 3:+Z", false);
  take_records(page, two, "hammer=2:+Z N; a=2:+Z m/s^2; c=4:+Z m/s^2", "2:+Z, 4:+Z", false);
  take_records(page, both, "hammer=1:+Z N; a=1:+Z m/s^2; b=2:+Z m/s^2; c=3:+Z m/s^2", "1:+Z, 3:+Z", true);
  project.editor()->replace_text(project.editor()->text() + joint_of_records);
  ASSERT_TRUE(wait([&] { return project.checked().scene.has_value(); })) << project.editor()->text();
  project.solve_page()->solve();
  ASSERT_TRUE(wait([&] { return !project.solve_page()->is_busy(); }));
  ASSERT_FALSE(project.solve_page()->runs().empty()) << project.solve_page()->status().toStdString();
  const auto& unknowns = project.solve_page()->runs().front().solution.unknowns;
  ASSERT_EQ(unknowns.size(), 2U);
  EXPECT_NEAR(unknowns[0].value, spring, 0.05 * spring);
  EXPECT_NEAR(unknowns[1].value, damper, 0.15 * damper);
  project.editor()->document()->setModified(false);
}

TEST(DrawnBeforeItIsRun, ARecordOverItsTimesWhichAreNoChannel) {
  const QTemporaryDir folder;
  write_file(folder.filePath("both.csv"), record_of_both());
  RecordsPage page;
  page.show();
  page.open({folder.filePath("both.csv")});
  ASSERT_TRUE(wait([&] { return !page.is_busy(); }));
  EXPECT_EQ(page.shown(), nullptr);
  EXPECT_EQ(page.status().toStdString(), "Channels: hammer, a, b, c");
  const std::vector<report::CurvePlot>& plots = page.plots()->findChild<Chart*>()->curve_plots();
  ASSERT_EQ(plots.size(), 4U);
  EXPECT_EQ(plots[0].x.label, "time (s)");
  EXPECT_THAT(plots[0].y.label, HasSubstr("hammer"));
  EXPECT_NEAR(plots[0].x_values.back(), 3.0, 0.01);
  EXPECT_NEAR(*std::ranges::max_element(plots[0].series.front().y), 100.0, 5.0) << "peaks are kept";
}

TEST(DrawnBeforeItIsRun, ALoadingCurve) {
  const QTemporaryDir folder;
  std::string text = "displacement [mm],force [N]\n";
  for (int i = 0; i < 50; ++i) text += std::to_string(0.001 * i) + "," + std::to_string(100.0 * std::sqrt(i)) + "\n";
  write_file(folder.filePath("softening.csv"), text);
  LoadingCurvePage page;
  page.show();
  page.open({folder.filePath("softening.csv")});
  ASSERT_TRUE(wait([&] { return !page.is_busy(); }));
  const std::vector<report::CurvePlot>& plots = page.plots()->findChild<Chart*>()->curve_plots();
  ASSERT_EQ(plots.size(), 1U);
  ASSERT_EQ(plots[0].series.size(), 1U);
  EXPECT_EQ(plots[0].x_values.size(), 50U);
  EXPECT_EQ(page.laws()->cells()->rowCount(), 0);
}

}  // namespace
}  // namespace jointid::gui
