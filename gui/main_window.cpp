#include "gui/main_window.hpp"

#include <QApplication>
#include <QCloseEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTextDocument>
#include <QVBoxLayout>

#include "gui/begin/example_dialog.hpp"
#include "gui/data/data_page.hpp"
#include "gui/geometry/geometry_page.hpp"
#include "gui/help/help_keys.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/file_drop.hpp"
#include "gui/look/job_progress.hpp"
#include "gui/look/language.hpp"
#include "gui/look/message_bar.hpp"
#include "gui/look/named.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/quiet_wheel.hpp"
#include "gui/look/said.hpp"
#include "gui/open/dropped_files.hpp"
#include "gui/open/variable_dialog.hpp"
#include "gui/project.hpp"
#include "gui/recent_files.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/scene/scene_words.hpp"
#include "gui/solve/difference_tab.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/work/worker.hpp"

namespace jointid::gui {
namespace {

constexpr int layout_version = 1;

const char* const first_text = R"(# The parts without the joint, and the parts with it. Paths are relative to this file.
[data]
substructures = []
assembly = []

# Joint DOFs on both sides, and what is unknown between them.
[joint]
dofs = []

[joint.stiffness]
pattern = "symmetric"
)";

bool is_scene(const QString& file) { return QFileInfo(file).suffix().compare(QStringLiteral("toml"), Qt::CaseInsensitive) == 0; }

}  // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent) {
  named(this, "main_window", tr("jointid workbench"));
  keep_wheel_from_fields(*this);
  QApplication::instance()->installEventFilter(new HelpKeys(this));
  let_drop_files(*this, [this](const QStringList& files) { open(files); });
  auto* hint = named(new QLabel(tr("Drop FRF files of the substructures and of the assembly here, one file to look at, or a scene.\n\n"
                                   "Ctrl+O opens files, Ctrl+N starts an empty scene, Ctrl+Shift+O opens an example.\n"
                                   "File – New from template has scenes to be filled in.")),
                     "hint", tr("Getting started"));
  hint->setAlignment(Qt::AlignCenter);
  tabs_ = named(new QTabWidget, "projects", tr("Projects"));
  tabs_->setTabsClosable(true);
  tabs_->setMovable(true);
  tabs_->setDocumentMode(true);
  stack_ = named(new QStackedWidget, "stack", tr("Projects, or getting started"));
  stack_->addWidget(hint);
  stack_->addWidget(tabs_);
  messages_ = new MessageBar;
  auto* all = named(new QWidget, "content", tr("Content"));
  auto* column = new QVBoxLayout(all);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(messages_);
  column->addWidget(stack_, 1);
  setCentralWidget(all);
  worker_ = new Worker(this);
  connect(worker_, &Worker::failed, this, [this](const InputError& error) { messages_->warn(QString::fromUtf8(error.what())); });
  connect(tabs_, &QTabWidget::tabCloseRequested, this, &MainWindow::close_project);
  connect(tabs_, &QTabWidget::currentChanged, this, &MainWindow::show_titles);
  worker_->add([](const Worker::Watch&) -> Worker::Deliver {
    ask_for_everything();
    return {};
  });
  add_menus();
  restore_layout();
  show_titles();
}

Project* MainWindow::current() const { return qobject_cast<Project*>(tabs_->currentWidget()); }

int MainWindow::count() const { return tabs_->count(); }

Project* MainWindow::add_project() {
  auto* project = new Project;
  project->restore_layout(QSettings().value(QStringLiteral("project_layout")).toByteArray());
  tabs_->addTab(project, {});
  tabs_->setCurrentWidget(project);
  connect(project, &Project::title_changed, this, &MainWindow::show_titles);
  project->solve_page()->differences()->set_elsewhere([this, project] { return runs_beside(*project); });
  return project;
}

/// Runs of all other projects, with the names of their scenes.
std::vector<std::pair<QString, std::vector<ident::Estimate>>> MainWindow::runs_beside(const Project& project) const {
  std::vector<std::pair<QString, std::vector<ident::Estimate>>> out;
  for (int i = 0; i < tabs_->count(); ++i) {
    const auto* const other = qobject_cast<Project*>(tabs_->widget(i));
    if (other == &project) continue;
    for (const Solved& run : other->solve_page()->runs())
      out.emplace_back(tr("%1, run %2").arg(other->title(), q(run.name)), run.solution.unknowns);
  }
  return out;
}

void MainWindow::open_scene(const QString& file) {
  const QString whole = QFileInfo(file).absoluteFilePath();
  for (int i = 0; i < tabs_->count(); ++i) {
    if (qobject_cast<Project*>(tabs_->widget(i))->file() == whole) return tabs_->setCurrentIndex(i);
  }
  Project* const project = add_project();
  if (project->open(file)) return project->editor()->setFocus();
  const QString why = project->messages()->text();
  tabs_->removeTab(tabs_->indexOf(project));
  delete project;
  messages_->warn(why);
  show_titles();
}

void MainWindow::open(const QStringList& files) {
  messages_->hide();
  QStringList others;
  for (const QString& file : files) {
    if (is_scene(file))
      open_scene(file);
    else
      others << file;
  }
  if (!others.isEmpty()) open_data(others);
}

void MainWindow::open_data(const QStringList& files, const ChosenNames& variables) {
  QStringList whole;
  for (const QString& file : files) whole << QFileInfo(file).absoluteFilePath();
  const QString folder = QFileInfo(whole.front()).absolutePath();
  messages_->say(tr("Reading %n file(s) …", nullptr, static_cast<int>(files.size())));
  worker_->add([this, whole, folder, variables](const Worker::Watch& watch) -> Worker::Deliver {
    return [this, whole, folder, variables, dropped = sort_dropped(whole, folder, watch.interrupted, variables)] {
      messages_->hide();
      if (!dropped.undecided.empty()) return ask_for_variables(dropped, whole, variables);
      show_dropped(dropped, folder);
      if (!dropped.failed.isEmpty()) messages_->warn(dropped.failed.join(QLatin1Char('\n')));
    };
  });
}

/// A choice in place of an error.
void MainWindow::ask_for_variables(const DroppedFiles& dropped, const QStringList& files, const ChosenNames& variables) {
  auto* const dialog = new VariableDialog(dropped.undecided, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, files, variables] {
    ChosenNames all = dialog->chosen();
    all.insert(variables.begin(), variables.end());
    open_data(files, all);
  });
  dialog->open();
}

/// Each in its place: a scene in a tab, records and curves on their pages.
void MainWindow::show_dropped(const DroppedFiles& dropped, const QString& folder) {
  if (dropped.geometry) {
    Project* const project = start_project(*dropped.geometry, folder);
    project->pages()->setCurrentWidget(project->geometry_page());
    project->messages()->say(tr("These files have nodes and no FRFs."));
  }
  if (dropped.scene) {
    Project* const project = start_project(*dropped.scene, folder);
    if (dropped.is_proposal) {
      project->say_proposed();
    } else {
      project->pages()->setCurrentWidget(project->data_page());
      project->messages()->say(
          dropped.why.empty() ? tr("Data, Geometry and Modes show the file. Open those of the parts and of the assembly together "
                                   "for a joint.")
                              : tr("Data, Geometry and Modes show the files. %1").arg(q(dropped.why)));
    }
  }
  if (!dropped.curves.isEmpty()) project_for_pages()->open_curves(dropped.curves);
  if (!dropped.records.isEmpty()) project_for_pages()->open_records(dropped.records);
}

Project* MainWindow::start_project(const std::string& text, const QString& folder) {
  Project* const project = add_project();
  project->start(text, folder);
  show_titles();
  project->editor()->setFocus();
  return project;
}

/// The project in front; one without a scene where there is none.
Project* MainWindow::project_for_pages() {
  if (Project* const project = current()) return project;
  Project* const project = start_project({}, {});
  project->editor()->document()->setModified(false);
  return project;
}

void MainWindow::new_scene() { start_project(first_text, {}); }

/// Its files go into a folder, its scene or its data into the window.
void MainWindow::open_example() {
  auto* const dialog = new ExampleDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, name = [dialog] { return std::pair(dialog->name(), dialog->folder()); }] {
    messages_->say(tr("Writing the example …"));
    worker_->add([this, wanted = name()](const Worker::Watch&) -> Worker::Deliver {
      return [this, file = write_example(wanted.first, wanted.second)] { open({file}); };
    });
  });
  dialog->open();
}

void MainWindow::choose_files() { open(choose_files_to_open(this)); }

bool MainWindow::save(Project& project) { return project.file().isEmpty() ? save_as(project) : project.save(); }

bool MainWindow::save_as(Project& project) {
  const QString file =
      choose_file_to_save(this, tr("Save the scene"), project.suggested_file(), tr("Scenes (*.toml)"), QStringLiteral("toml"));
  return !file.isEmpty() && project.save_as(file);
}

/// Runs of a scene that was not saved are of the session: those that took long are not lost without a word.
bool MainWindow::may_lose_runs(Project& project) {
  const double seconds = project.seconds_of_runs();
  if (!(seconds > 0.0) || seconds < long_runs_s_) return true;
  tabs_->setCurrentWidget(&project);
  const QString text = tr("The runs of %1 took %2. They are lost with it. Save the scene to keep them beside it. Close it?")
                           .arg(project.title(), duration_text(seconds));
  const auto answer =
      QMessageBox::question(this, tr("Runs are lost"), text, QMessageBox::Close | QMessageBox::Cancel, QMessageBox::Cancel);
  return answer == QMessageBox::Close;
}

bool MainWindow::may_close(Project& project) {
  project.commit();
  if (!may_lose_runs(project)) return false;
  if (!project.is_modified()) return true;
  tabs_->setCurrentWidget(&project);
  const auto answer = QMessageBox::question(this, tr("Unsaved scene"), tr("Save the changes of %1?").arg(project.title()),
                                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save(project));
}

bool MainWindow::close_project(int index) {
  auto* const project = qobject_cast<Project*>(tabs_->widget(index));
  if (project == nullptr || !may_close(*project)) return false;
  QSettings().setValue(QStringLiteral("project_layout"), project->layout_state());
  project->keep_layout();
  tabs_->removeTab(index);
  delete project;
  show_titles();
  return true;
}

void MainWindow::show_titles() {
  for (int i = 0; i < tabs_->count(); ++i) {
    const auto* project = qobject_cast<Project*>(tabs_->widget(i));
    tabs_->setTabText(i, project->title() + (project->is_modified() ? QStringLiteral(" *") : QString()));
    tabs_->setTabToolTip(i, project->file());
  }
  stack_->setCurrentIndex(tabs_->count() > 0 ? 1 : 0);
  const Project* project = current();
  if (project != nullptr && !project->folder().isEmpty()) begin_dialogs_in(project->folder());
  setWindowTitle(project == nullptr ? tr("jointid workbench") : tr("%1[*] – jointid workbench").arg(project->title()));
  setWindowModified(project != nullptr && project->is_modified());
}

void MainWindow::set_theme(Theme theme) {
  apply(theme, *qApp);
  QSettings().setValue(QStringLiteral("dark"), theme == Theme::dark);
}

void MainWindow::set_language(const QString& chosen) {
  choose_language(chosen);
  messages_->ask(tr("The language changes with the next start."), tr("Restart now"), [this] { ask_to_begin_anew(); });
}

void MainWindow::ask_to_begin_anew() {
  if (!may_close_all()) return;
  keep_layout();
  QStringList files;
  for (int i = 0; i < tabs_->count(); ++i) {
    const auto* project = qobject_cast<Project*>(tabs_->widget(i));
    if (!project->file().isEmpty()) files << project->file();
  }
  Q_EMIT begin_anew(files);
}

bool MainWindow::may_close_all() {
  for (int i = 0; i < tabs_->count(); ++i) {
    if (!may_close(*qobject_cast<Project*>(tabs_->widget(i)))) return false;
  }
  return true;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_close_all()) return event->ignore();
  keep_layout();
  event->accept();
}

void MainWindow::keep_layout() const {
  QSettings settings;
  settings.setValue(QStringLiteral("geometry"), saveGeometry());
  settings.setValue(QStringLiteral("state"), saveState(layout_version));
  for (int i = 0; i < tabs_->count(); ++i) qobject_cast<Project*>(tabs_->widget(i))->keep_layout();
  if (const Project* project = current()) settings.setValue(QStringLiteral("project_layout"), project->layout_state());
}

void MainWindow::restore_layout() {
  const QSettings settings;
  if (!restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray())) resize(1280, 800);
  restoreState(settings.value(QStringLiteral("state")).toByteArray(), layout_version);
}

}  // namespace jointid::gui
