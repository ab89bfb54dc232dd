#include "gui/page/scene_page.hpp"

#include <QApplication>
#include <QClipboard>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "base/control.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/named.hpp"
#include "gui/look/output.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "gui/page/job_line.hpp"
#include "gui/scene/completion_place.hpp"

namespace jointid::gui {

ScenePage::ScenePage(SceneKind kind, QWidget* parent) : QWidget(parent), kind_(std::move(kind)) {
  setAccessibleName(kind_.title);
  line_ = new JobLine(kind_.name, tr("Status: %1").arg(kind_.title), tr("Stop; nothing is shown then"));
  plots_ = new PlotMenu((kind_.name + "_plots").c_str(), kind_.plots, kind_.plot_hint);
  tables_ = new TableMenu(kind_.name + "_tables", kind_.tables);
  auto* both = named(new QSplitter(Qt::Vertical), (kind_.name + "_both").c_str(), tr("Diagram and tables"));
  both->addWidget(plots_);
  both->addWidget(tables_);
  both->setStretchFactor(0, 1);
  both->setSizes({430, 220});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(make_top());
  all->addWidget(line_);
  all->addWidget(both, 1);
  connect(line_, &JobLine::failed, this, &ScenePage::failed);
  connect(line_, &JobLine::busy_changed, this, &ScenePage::show_buttons);
  show_buttons();
}

QWidget* ScenePage::make_top() {
  auto* top = named(new QWidget, (kind_.name + "_top").c_str(), kind_.title);
  run_ = push_button((kind_.name + "_run").c_str(), kind_.run, kind_.run_hint);
  command_ = push_button((kind_.name + "_command").c_str(), tr("Copy as command"), tr("Copy the command line that finds the same"));
  auto* report = push_button((kind_.name + "_report").c_str(), tr("Report…"), tr("Save the page that the command writes with --report"));
  auto* json = push_button((kind_.name + "_json").c_str(), tr("JSON…"), tr("Save what the command writes with --json"));
  auto* csv = push_button((kind_.name + "_csv").c_str(), tr("CSV…"), tr("Save what the command writes with --csv"));
  outputs_ = {report, json, csv};
  auto* rows = new QVBoxLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({run_, line_->cancel_button()}, {report, json, csv, command_}));
  connect(run_, &QPushButton::clicked, this, &ScenePage::run);
  connect(command_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_line()); });
  connect(report, &QPushButton::clicked, this, [this] { ask_and_write(tr("Pages (*.html)"), QStringLiteral("html")); });
  connect(json, &QPushButton::clicked, this, [this] { ask_and_write(tr("JSON (*.json)"), QStringLiteral("json")); });
  connect(csv, &QPushButton::clicked, this, [this] { ask_and_write(tr("Tables (*.csv)"), QStringLiteral("csv")); });
  return top;
}

bool ScenePage::is_busy() const { return line_->is_busy(); }

QString ScenePage::status() const { return line_->status(); }

void ScenePage::cancel() { line_->cancel(); }

void ScenePage::show_buttons() {
  run_->setEnabled(task_.has_value() && !is_busy());
  command_->setEnabled(task_.has_value());
  for (QPushButton* button : outputs_) button->setEnabled(found_ != nullptr && !is_busy());
}

std::optional<SceneError> ScenePage::set_scene(const std::string& text, const std::filesystem::path& path, const QString& file) {
  task_.reset();
  file_ = file;
  std::optional<SceneError> wrong;
  if (is_of(text)) {
    try {
      task_ = kind_.read(text, path);
    } catch (const InputError& error) {
      wrong = located(error, text);
    }
  }
  show_buttons();
  return wrong;
}

void ScenePage::run() {
  if (!task_ || is_busy()) return;
  line_->say(tr("Computing …"));
  line_->worker().add([this, task = *task_](const Worker::Watch& watch) -> Worker::Deliver {
    auto found = std::make_shared<const SceneFindings>(task.run(watch));
    stop_if(watch.interrupted);
    return [this, found] { show_found(found); };
  });
}

void ScenePage::show_found(std::shared_ptr<const SceneFindings> found) {
  found_ = std::move(found);
  line_->say(found_->said, found_->is_bad);
  plots_->show_groups(found_->plots);
  tables_->show_tables(found_->tables);
  show_buttons();
}

QString ScenePage::command_line() const {
  return kind_.command + " " + shell_word(file_.isEmpty() ? tr("SCENE.toml") : file_);
}

void ScenePage::ask_and_write(const QString& filter, const QString& ending) {
  const QString file = choose_file_to_save(this, tr("Save the results"), {}, filter, ending);
  if (!file.isEmpty()) write(file, ending);
}

void ScenePage::write(const QString& file, const QString& ending) {
  if (!found_) return;
  try {
    write_output(file, found_->outputs.at(ending)(), task_ ? task_->inputs : std::vector<std::filesystem::path>());
    line_->say(tr("Written to %1.").arg(file));
  } catch (const InputError& error) {
    line_->say(QString::fromUtf8(error.what()), true);
  }
}

bool has_table(const std::string& text, const std::string& table) { return line_of_key(text, table, "") > 0; }

}  // namespace jointid::gui
