#include <QAction>
#include <QComboBox>
#include <QDateTime>
#include <QFile>
#include <QMenu>
#include <QMessageBox>
#include <QTabWidget>
#include <QToolButton>

#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/page/job_line.hpp"
#include "gui/page/plot_menu.hpp"
#include "gui/solve/difference_tab.hpp"
#include "gui/solve/frf_tab.hpp"
#include "gui/solve/joint_tab.hpp"
#include "gui/solve/kept_runs.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/solve/worth_row.hpp"
#include "gui/table/cell_table.hpp"
#include "ident/identify.hpp"

/// Runs that are kept beside the scene, and read again with it.
namespace jointid::gui {
namespace {

/// "17:31" of today, else with the date.
QString time_text(const std::string& made) {
  const QDateTime time = QDateTime::fromString(q(made), Qt::ISODate);
  return time.toString(time.date() == QDate::currentDate() ? QStringLiteral("HH:mm") : QStringLiteral("yyyy-MM-dd HH:mm"));
}

QString run_text(const Solved& run) {
  return SolvePage::tr("%1, %2, %3").arg(q(run.name), q(ident::name(run.solution.status)).replace('_', ' '), time_text(run.made));
}

}  // namespace

QToolButton* SolvePage::make_run_menu() {
  auto* const button = named(new QToolButton, "run_menu", tr("The run in front"), tr("The scene of this run; remove it"));
  button->setText(tr("Run"));
  button->setFocusPolicy(Qt::StrongFocus);
  button->setPopupMode(QToolButton::InstantPopup);
  auto* const menu = new QMenu(button);
  scene_of_run_ = menu->addAction(tr("&Scene of this run"), this, [this] {
    if (const auto run = run_in_front()) Q_EMIT text_wanted(runs_[*run].scene_text);
  });
  scene_of_run_->setObjectName(QStringLiteral("scene_of_run"));
  remove_run_ = menu->addAction(tr("&Remove this run…"), this, &SolvePage::ask_to_remove);
  remove_run_->setObjectName(QStringLiteral("remove_run"));
  button->setMenu(menu);
  return button;
}

void SolvePage::set_file(const QString& file, const std::string& text) {
  text_ = text;
  if (file == file_) return;
  const bool is_first = file_.isEmpty();
  file_ = file;
  if (file_.isEmpty() || text.empty()) return;
  if (is_first && runs_.empty())
    read_runs();
  else
    keep_all();
}

void SolvePage::read_runs() {
  line_->worker().add([this, file = file_](const Worker::Watch&) -> Worker::Deliver {
    KeptRuns kept = read_kept_runs(file);
    if (kept.runs.empty() && kept.failed.isEmpty()) return {};
    return [this, kept = std::move(kept)] { add_kept(kept.runs, kept.failed); };
  });
}

/// Before those of the session, which are newer.
void SolvePage::add_kept(std::vector<Solved> runs, const QStringList& failed) {
  std::size_t front = runs.empty() ? 0 : runs.size() - 1;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].kept == wanted_run_) front = i;
  }
  if (const auto shown = run_in_front()) front = runs.size() + *shown;
  runs_.insert(runs_.begin(), std::make_move_iterator(runs.begin()), std::make_move_iterator(runs.end()));
  for (std::size_t i = 0; i < runs_.size(); ++i)
    runs_[i].name = std::to_string(i + 1) + ": " + ident::name(runs_[i].solution.used.method);
  if (!runs_.empty()) list_runs(front);
  if (failed.isEmpty()) return;
  renew_status_ = false;
  line_->say(tr("Some kept runs cannot be read. %1").arg(failed.join(QLatin1Char(' '))), true);
}

/// All runs beside a scene that was saved elsewhere.
void SolvePage::keep_all() {
  if (runs_.empty()) return;
  line_->worker().add([this, file = file_, runs = runs_](const Worker::Watch&) mutable -> Worker::Deliver {
    std::vector<std::pair<std::string, QString>> kept;
    for (Solved& run : runs) {
      keep_run(run, file);
      kept.emplace_back(run.name, run.kept);
    }
    return [this, kept = std::move(kept)] { note_kept(kept); };
  });
}

/// By the names of the runs, of which some may be gone.
void SolvePage::note_kept(const std::vector<std::pair<std::string, QString>>& kept) {
  for (const auto& [name, file] : kept) {
    for (Solved& run : runs_) {
      if (run.name == name) run.kept = file;
    }
  }
}

void SolvePage::list_runs(std::size_t front) {
  run_choice_->clear();
  for (const Solved& run : runs_) run_choice_->addItem(run_text(run));
  choose_run(front);
}

void SolvePage::choose_run(std::size_t run) {
  if (run >= runs_.size()) return;
  run_choice_->setCurrentIndex(static_cast<int>(run));
  show_run(static_cast<int>(run));
}

std::optional<std::size_t> SolvePage::run_in_front() const {
  const int run = run_choice_->currentIndex();
  return run < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(run));
}

void SolvePage::want_run(const QString& kept_file) {
  wanted_run_ = kept_file;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (runs_[i].kept == kept_file) choose_run(i);
  }
}

/// Of a kept run, which has none before it is looked at: its FRFs need one.
void SolvePage::ask_for_plan(std::size_t run) {
  line_->worker().add([this, asked = runs_[run]](const Worker::Watch& watch) mutable -> Worker::Deliver {
    watch.progress("planning", 0, 0);
    try {
      make_plan_of(asked);
    } catch (const InputError& error) {
      return [this, what = QString::fromUtf8(error.what())] {
        line_->say(tr("The FRFs of this run are not drawn: %1").arg(what), true);
      };
    }
    return [this, name = asked.name, plan = asked.plan] {
      for (std::size_t i = 0; i < runs_.size(); ++i) {
        if (runs_[i].name != name) continue;
        runs_[i].plan = plan;
        if (run_in_front() == i) show_run(static_cast<int>(i));
      }
    };
  });
}

void SolvePage::ask_to_remove() {
  const auto run = run_in_front();
  if (!run) return;
  const auto answer = QMessageBox::question(this, tr("Remove a run"), tr("Remove run %1 and its file?").arg(q(runs_[*run].name)),
                                            QMessageBox::Yes | QMessageBox::Cancel, QMessageBox::Cancel);
  if (answer == QMessageBox::Yes) remove_run();
}

void SolvePage::remove_run() {
  const auto run = run_in_front();
  if (!run) return;
  if (const QString file = runs_[*run].kept; !file.isEmpty() && !QFile::remove(file))
    return line_->say(tr("%1 cannot be removed.").arg(file), true);
  runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(*run));
  if (!runs_.empty()) return list_runs(std::min(*run, runs_.size() - 1));
  run_choice_->clear();
  clear_results();
}

/// Where the last run is gone.
void SolvePage::clear_results() {
  worth_->show_answers({});
  for (CellTable* table : {unknowns_, springs_, findings_, run_table_}) table->show_rows({});
  results_->setTabVisible(results_->indexOf(springs_), false);
  results_->setTabVisible(results_->indexOf(iterations_menu_), false);
  joint_tab_->show_run({});
  frf_tab_->clear();
  difference_tab_->clear();
  scene_of_run_->setEnabled(false);
  remove_run_->setEnabled(false);
  line_->say(tr("There is no run."));
}

}  // namespace jointid::gui
