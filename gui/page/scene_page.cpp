#include "gui/page/scene_page.hpp"

#include <QComboBox>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "gui/scene/completion_place.hpp"

namespace jointid::gui {

constexpr int usual_trials = 200;

ScenePage::ScenePage(SceneKind kind, QWidget* parent)
    : FindingsPage({kind.name, kind.title, tr("Status: %1").arg(kind.title), kind.plots, kind.plot_hint, kind.tables}, parent),
      kind_(std::move(kind)) {
  add_above(make_top());
  show_buttons();
}

QWidget* ScenePage::make_top() {
  auto* top = named(new QWidget, (kind_.name + "_top").c_str(), kind_.title);
  jobs_ = named(new QComboBox, (kind_.name + "_jobs").c_str(), tr("Task of the scene"));
  for (const SceneJob& each : kind_.jobs) jobs_->addItem(each.title);
  trials_ = number_box((kind_.name + "_trials").c_str(), tr("trials"), 2, usual_trials);
  run_ = push_button((kind_.name + "_run").c_str(), job().run, job().run_hint);
  auto* rows = new QVBoxLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(buttons_behind({jobs_, trials_, run_}));
  jobs_->setVisible(kind_.jobs.size() > 1);  // not before: without a parent it would be a window
  connect(run_, &QPushButton::clicked, this, &ScenePage::run);
  connect(jobs_, &QComboBox::currentIndexChanged, this, &ScenePage::show_buttons);
  return top;
}

void ScenePage::show_buttons() {
  run_->setText(job().run);
  run_->setToolTip(job().run_hint);
  run_->setAccessibleName(job().run_hint);
  run_->setEnabled(task_.has_value() && !is_busy());
  jobs_->setEnabled(!is_busy());
  trials_->setVisible(job().counts_trials);
  command()->setEnabled(task_.has_value());
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
  outputs()->protect(task_ ? task_->inputs : std::vector<std::filesystem::path>());
  show_buttons();
  return wrong;
}

void ScenePage::run() {
  if (!task_ || is_busy()) return;
  ask([run = task_->run.at(static_cast<std::size_t>(jobs_->currentIndex())),
       trials = static_cast<std::size_t>(trials_->value())](const Worker::Watch& watch) { return run(watch, trials); });
}

const SceneJob& ScenePage::job() const { return kind_.jobs[static_cast<std::size_t>(jobs_->currentIndex())]; }

QString ScenePage::command_line() const {
  const QString text = job().command + " " + shell_word(file_.isEmpty() ? tr("SCENE.toml") : file_) + job().after;
  return job().counts_trials ? text + QStringLiteral(" --trials %1").arg(trials_->value()) : text;
}

bool has_table(const std::string& text, const std::string& table) { return line_of_key(text, table, "") > 0; }

}  // namespace jointid::gui
