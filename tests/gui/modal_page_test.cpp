#include "gui/modal/modal_page.hpp"

#include <gmock/gmock.h>

#include <QDoubleSpinBox>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include "frf/uff/uff55.hpp"
#include "gui/look/paths.hpp"
#include "gui/plot/chart.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/plot/heat_chart.hpp"
#include "gui/table/cell_table.hpp"
#include "ident/scene/read_scene.hpp"
#include "report/modalfit/modal_text.hpp"
#include "report/modalfit/stabilisation.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

struct Fitting {
  Measured measured{"rig1"};
  ModalPage page;

  Fitting() {
    page.resize(1000, 800);
    page.show();
    (void)QTest::qWaitForWindowExposed(&page);
    page.set_scene(ident::read_scene(as_path(measured.scene())));
    find_box("modal_low")->setValue(250.0);
    find_box("modal_high")->setValue(1000.0);
  }
  QDoubleSpinBox* find_box(const char* name) { return page.findChild<QDoubleSpinBox*>(QString::fromLatin1(name)); }
  bool rests() {
    return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000);
  }
  bool find() {
    page.run();
    return rests() && page.shown() != nullptr;
  }
  std::vector<double> frequencies() const {
    std::vector<double> out;
    for (const auto& mode : page.shown()->fit.modes) out.push_back(mode.pole.frequency_hz);
    return out;
  }
  std::size_t modes() const { return page.shown()->fit.modes.size(); }
  /// A click as a user makes it, on a mode above the poles.
  void click_mode(std::size_t mode) {
    QCoreApplication::processEvents();
    QTest::mouseClick(page.chart()->canvas(), Qt::LeftButton, Qt::NoModifier, page.chart()->pixel_of(report::of_fit, mode));
  }
};

/// The JSON of the command, of a command line as the page copies it.
nlohmann::json json_of_command(QString line) {
  QProcess process;
  process.start("/bin/sh", {"-c", line.replace(0, 7, shell_word(JOINTID_COMMAND)) + " --json -"});
  if (!process.waitForFinished(60000)) return {};
  return nlohmann::json::parse(process.readAllStandardOutput().toStdString(), nullptr, false);  // written for poor fits, too
}

/// To the last bit.
void expect_the_commands_modes(const ModalPage& page) {
  const nlohmann::json json = json_of_command(page.command_line());
  ASSERT_TRUE(json.contains("modes")) << page.command_line().toStdString();
  const auto& modes = page.shown()->fit.modes;
  ASSERT_EQ(json["modes"].size(), modes.size());
  for (std::size_t r = 0; r < modes.size(); ++r) {
    EXPECT_EQ(json["modes"][r]["frequency_hz"].get<double>(), modes[r].pole.frequency_hz);
    EXPECT_EQ(json["modes"][r]["damping"].get<double>(), modes[r].pole.damping);
    EXPECT_EQ(json["modes"][r]["frequency_std"].get<double>(), modes[r].frequency_deviation_hz);
  }
}

TEST(ModalPage, FindsWhatTheCommandFinds) {
  Fitting fitting;
  EXPECT_EQ(fitting.page.shown(), nullptr);
  find<QPushButton>(fitting.page, "modal_find")->click();
  ASSERT_TRUE(fitting.rests());
  ASSERT_NE(fitting.page.shown(), nullptr) << fitting.page.status().toStdString();
  EXPECT_GT(fitting.modes(), 2U);
  EXPECT_GT(fitting.page.chart()->scatter().groups[report::at_mode].points.size(), 50U);
  EXPECT_EQ(fitting.page.plot()->curves().size(), 2U);
  const int all = static_cast<int>(fitting.modes());
  EXPECT_EQ(fitting.page.mac()->cells()->rowCount(), all);
  EXPECT_EQ(fitting.page.mac()->cells()->index(0, 0).data().toString(), "1.000");
  EXPECT_THAT(fitting.page.status().toStdString(), HasSubstr("dB rms"));
  expect_the_commands_modes(fitting.page);
}

TEST(ModalPage, AClickLeavesAModeAndUndoBringsItBack) {
  Fitting fitting;
  ASSERT_TRUE(fitting.find());
  const std::vector<double> before = fitting.frequencies();
  const QSignalSpy changed(&fitting.page, &ModalPage::modes_changed);
  fitting.click_mode(1);
  ASSERT_TRUE(fitting.rests());
  ASSERT_EQ(fitting.modes(), before.size() - 1);
  EXPECT_EQ(changed.count(), 1);
  EXPECT_NEAR(fitting.frequencies()[0], before[0], 1e-3 * before[0]);
  EXPECT_NEAR(fitting.frequencies()[1], before[2], 1e-3 * before[2]);
  expect_the_commands_modes(fitting.page);
  QTest::keyClick(fitting.page.chart()->canvas(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(fitting.rests());
  EXPECT_EQ(fitting.frequencies(), before);
  find<QPushButton>(fitting.page, "modal_redo")->click();
  ASSERT_TRUE(fitting.rests());
  EXPECT_EQ(fitting.modes(), before.size() - 1);
}

/// From nothing, by clicks on poles of the diagram: the same modes again.
TEST(ModalPage, PolesArePickedOneByOne) {
  Fitting fitting;
  ASSERT_TRUE(fitting.find());
  const std::vector<double> sought = fitting.frequencies();
  find<QPushButton>(fitting.page, "modal_none")->click();
  ASSERT_TRUE(fitting.rests());
  ASSERT_EQ(fitting.modes(), 0U);
  EXPECT_FALSE(find<QPushButton>(fitting.page, "modal_command")->isEnabled());
  const auto& loose = fitting.page.chart()->scatter().groups[report::elsewhere].points;
  const auto nearest =
      std::ranges::min_element(loose, {}, [&](const report::Point& point) { return std::abs(point.x - sought[2]); });
  QCoreApplication::processEvents();
  const QPoint at = fitting.page.chart()->pixel_of(report::elsewhere, static_cast<std::size_t>(nearest - loose.begin()));
  QTest::mouseClick(fitting.page.chart()->canvas(), Qt::LeftButton, Qt::NoModifier, at);
  ASSERT_TRUE(fitting.rests());
  ASSERT_EQ(fitting.modes(), 1U);
  EXPECT_NEAR(fitting.frequencies()[0], sought[2], 0.02 * sought[2]);
  EXPECT_FALSE(fitting.page.chart()->scatter().groups[report::at_mode].points.empty());
}

TEST(ModalPage, TheKeyboardDoesAllOfIt) {
  Fitting fitting;
  ASSERT_TRUE(fitting.find());
  const std::size_t before = fitting.modes();
  fitting.page.results()->setCurrentWidget(fitting.page.modes());
  fitting.page.modes()->setFocus();
  fitting.page.modes()->selectRow(0);
  QTest::keyClick(fitting.page.modes(), Qt::Key_Delete);
  ASSERT_TRUE(fitting.rests());
  EXPECT_EQ(fitting.modes(), before - 1);
  QTest::keyClick(fitting.page.modes(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(fitting.rests());
  EXPECT_EQ(fitting.modes(), before);
  QTest::keyClick(fitting.page.chart()->canvas(), Qt::Key_Right);
  QTest::keyClick(fitting.page.chart()->canvas(), Qt::Key_Return);
  ASSERT_TRUE(fitting.rests());
  EXPECT_TRUE(fitting.page.picked().can_undo());
}

TEST(ModalPage, WritesTheShapesAndFrfsOfTheCommand) {
  Fitting fitting;
  ASSERT_TRUE(fitting.find());
  const QTemporaryDir folder;
  fitting.page.write_shapes(folder.filePath("page.uff"));
  fitting.page.write_regenerated(folder.filePath("page.uff58.uff"));
  QProcess process;
  QString line = fitting.page.command_line() + " --shapes " + shell_word(folder.filePath("command.uff")) + " --regenerate " +
                 shell_word(folder.filePath("command58.uff"));
  process.start("/bin/sh", {"-c", line.replace(0, 7, shell_word(JOINTID_COMMAND))});
  ASSERT_TRUE(process.waitForFinished(60000));
  ASSERT_EQ(process.exitCode(), 0);
  EXPECT_EQ(read_file(folder.filePath("page.uff")), read_file(folder.filePath("command.uff")));
  EXPECT_EQ(frf::read_uff55(as_path(folder.filePath("page.uff"))).size(), fitting.modes());
  EXPECT_EQ(read_file(folder.filePath("page.uff58.uff")), read_file(folder.filePath("command58.uff")));
  fitting.page.write_shapes(fitting.measured.files().front());
  EXPECT_THAT(fitting.page.status().toStdString(), HasSubstr("input"));
}

TEST(ModalPage, CancelKeepsWhatIsFoundAndDestructionWaits) {
  for (const int wait : {0, 20, 80}) {
    Fitting fitting;
    fitting.page.run();
    QTest::qWait(wait);
    fitting.page.cancel();
    ASSERT_TRUE(fitting.rests());
    EXPECT_FALSE(fitting.page.status().isEmpty());
    fitting.page.run();
    QTest::qWait(wait);
  }
}

TEST(ModalPage, SaysWhatIsWrongWithTheFiles) {
  ModalPage page;
  page.set_scene(ident::parse_scene(small_scene, "/nowhere/scene.toml"));
  const QSignalSpy failed(&page, &ModalPage::failed);
  page.run();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page.is_busy(); }, 60000));
  EXPECT_EQ(failed.count(), 1);
  EXPECT_THAT(page.status().toStdString(), HasSubstr("a.uff"));
  EXPECT_EQ(page.command_line().toStdString(), "jointid modalfit '/nowhere/a.uff'");
}

TEST(ModalCommand, SaysWhatIsNotAsUsual) {
  ModalStructure structure{"a", {{"a b.mat", {}}}};
  structure.files[0].options.quantity = frf::Quantity::mobility;
  structure.files[0].options.response = {frf::Dof::parse("1:+Z")};
  modalfit::FitOptions options;
  options.kind = {modalfit::Damping::hysteretic, true};
  options.range_hz = {10.5, std::numeric_limits<double>::max()};
  options.poles = {{51.5, 0.001}, {0.1, 0.25}};
  EXPECT_EQ(modal_command(structure, options).toStdString(),
            "jointid modalfit 'a b.mat' --quantity mobility --response 1:+Z --range 10.5: --real --damping hysteretic --poles "
            "51.5:0.001,0.10000000000000001:0.25");
}

TEST(PickedPoles, AreUndoneAndRedone) {
  PickedPoles picked;
  EXPECT_FALSE(picked.now());
  picked.undo();
  picked.pick({{1.0, 0.1}});
  picked.pick({});
  picked.undo();
  ASSERT_TRUE(picked.now());
  EXPECT_EQ(picked.now()->size(), 1U);
  picked.redo();
  EXPECT_TRUE(picked.now()->empty());
  picked.undo();
  picked.undo();
  EXPECT_FALSE(picked.now());
  picked.pick({{2.0, 0.1}});
  EXPECT_FALSE(picked.can_redo());
}

TEST(ModalPage, TheMouseOverAPoleStatesFrequencyDampingAndOrder) {
  Fitting fitting;
  ASSERT_TRUE(fitting.find());
  QCoreApplication::processEvents();
  const report::ScatterPlot& plot = fitting.page.chart()->scatter();
  const report::Point& pole = plot.groups[report::at_mode].points.front();
  move_mouse(fitting.page.chart()->canvas(), fitting.page.chart()->pixel_of(report::at_mode, 0));
  QCoreApplication::processEvents();
  const std::string said = fitting.page.chart()->readout().toStdString();
  EXPECT_THAT(said, testing::AllOf(HasSubstr("Hz"), HasSubstr("ζ"),
                                   HasSubstr("order (pole pairs) " + std::to_string(static_cast<int>(pole.y)))));
  move_mouse(fitting.page.chart()->canvas(), QPoint(1, 1));
  QCoreApplication::processEvents();
  EXPECT_EQ(fitting.page.chart()->readout().toStdString(), "");
}

TEST(ModalPage, ModesAreComparedWithThoseOfAFile) {
  Fitting fitting;
  QTemporaryDir folder;
  const QString file = folder.filePath("shapes.uff");
  fitting.page.compare_with(file);
  EXPECT_THAT(fitting.page.status().toStdString(), HasSubstr("No modes are found yet"));
  ASSERT_TRUE(fitting.find());
  fitting.page.write_shapes(file);
  fitting.page.compare_with(file);
  const HeatPlot& map = fitting.page.cross_mac()->plot();
  ASSERT_EQ(map.rows.size(), fitting.modes());
  ASSERT_EQ(map.columns.size(), fitting.modes());
  for (std::size_t mode = 0; mode < fitting.modes(); ++mode) EXPECT_NEAR(map.values[mode * fitting.modes() + mode], 1.0, 1e-9);
  const QString json = folder.filePath("fit.json");
  write_file(json, report::modal_json(*fitting.page.shown()));
  fitting.page.compare_with(json);
  ASSERT_EQ(map.columns.size(), fitting.modes()) << "of the JSON of modalfit";
  for (std::size_t mode = 0; mode < fitting.modes(); ++mode) EXPECT_NEAR(map.values[mode * fitting.modes() + mode], 1.0, 1e-12);
  fitting.click_mode(0);  // leaves it
  ASSERT_TRUE(fitting.rests());
  EXPECT_EQ(fitting.page.cross_mac()->plot().rows.size(), map.columns.size() - 1);
  fitting.page.compare_with(folder.filePath("nothing.uff"));
  EXPECT_TRUE(fitting.page.cross_mac()->plot().values.empty());
}

}  // namespace
}  // namespace jointid::gui
