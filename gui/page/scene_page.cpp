#include "gui/page/scene_page.hpp"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QPushButton>
#include <QSpinBox>
#include <QSplitter>
#include <QVBoxLayout>

#include "base/control.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "gui/page/job_line.hpp"
#include "gui/scene/completion_place.hpp"

namespace jointid::gui {

constexpr int usual_trials = 200;

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
  jobs_ = named(new QComboBox, (kind_.name + "_jobs").c_str(), tr("What the scene is asked for"));
  for (const SceneJob& each : kind_.jobs) jobs_->addItem(each.title);
  trials_ = number_box((kind_.name + "_trials").c_str(), tr("trials"), 2, usual_trials);
  run_ = push_button((kind_.name + "_run").c_str(), job().run, job().run_hint);
  command_ = push_button((kind_.name + "_command").c_str(), tr("Copy as command"), tr("Copy the command line that finds the same"));
  outputs_ = new OutputButtons(kind_.name, *line_);
  auto* rows = new QVBoxLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({jobs_, trials_, run_, line_->cancel_button()}, {outputs_, command_}));
  jobs_->setVisible(kind_.jobs.size() > 1);  // not before: without a parent it would be a window
  connect(run_, &QPushButton::clicked, this, &ScenePage::run);
  connect(jobs_, &QComboBox::currentIndexChanged, this, &ScenePage::show_buttons);
  connect(command_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_line()); });
  return top;
}

bool ScenePage::is_busy() const { return line_->is_busy(); }

QString ScenePage::status() const { return line_->status(); }

void ScenePage::cancel() { line_->cancel(); }

void ScenePage::show_buttons() {
  run_->setText(job().run);
  run_->setToolTip(job().run_hint);
  run_->setAccessibleName(job().run_hint);
  run_->setEnabled(task_.has_value() && !is_busy());
  jobs_->setEnabled(!is_busy());
  trials_->setVisible(job().counts_trials);
  command_->setEnabled(task_.has_value());
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
  outputs_->protect(task_ ? task_->inputs : std::vector<std::filesystem::path>());
  show_buttons();
  return wrong;
}

void ScenePage::run() {
  if (!task_ || is_busy()) return;
  line_->say(tr("Computing …"));
  const auto ask = task_->run.at(static_cast<std::size_t>(jobs_->currentIndex()));
  const auto trials = static_cast<std::size_t>(trials_->value());
  line_->worker().add([this, ask, trials](const Worker::Watch& watch) -> Worker::Deliver {
    auto found = std::make_shared<const SceneFindings>(ask(watch, trials));
    stop_if(watch.interrupted);
    return [this, found] { show_found(found); };
  });
}

void ScenePage::show_found(std::shared_ptr<const SceneFindings> found) {
  found_ = std::move(found);
  line_->say(found_->said, found_->is_bad);
  outputs_->offer(found_->outputs);
  plots_->show_groups(found_->plots);
  tables_->show_tables(found_->tables);
  show_buttons();
}

const SceneJob& ScenePage::job() const { return kind_.jobs[static_cast<std::size_t>(jobs_->currentIndex())]; }

QString ScenePage::command_line() const {
  const QString text = job().command + " " + shell_word(file_.isEmpty() ? tr("SCENE.toml") : file_) + job().after;
  return job().counts_trials ? text + QStringLiteral(" --trials %1").arg(trials_->value()) : text;
}

bool has_table(const std::string& text, const std::string& table) { return line_of_key(text, table, "") > 0; }

}  // namespace jointid::gui
