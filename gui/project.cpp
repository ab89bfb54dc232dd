#include "gui/project.hpp"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QTextDocument>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/compare/compare_page.hpp"
#include "gui/couple/couple_page.hpp"
#include "gui/data/data_page.hpp"
#include "gui/forms/scene_form.hpp"
#include "gui/geometry/geometry_page.hpp"
#include "gui/joint/joint_assistant.hpp"
#include "gui/laws/law_kind.hpp"
#include "gui/lines/line_kind.hpp"
#include "gui/loading_curve/loading_curve_page.hpp"
#include "gui/look/message_bar.hpp"
#include "gui/look/named.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "gui/modal/modal_page.hpp"
#include "gui/oscillate/oscillate_kind.hpp"
#include "gui/page/scene_page.hpp"
#include "gui/plan/plan_page.hpp"
#include "gui/records/records_page.hpp"
#include "gui/response/response_kind.hpp"
#include "gui/scene/completion_place.hpp"
#include "gui/scene/scene_edit.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/study/study_page.hpp"
#include "gui/table/cell_table.hpp"
#include "gui/work/control_of.hpp"
#include "ident/scene/drawn_lines.hpp"
#include "ident/scene/read_scene.hpp"

namespace jointid::gui {
namespace {

/// As a path from the folder of the scene.
std::string path_from(const QString& file, const std::filesystem::path& folder) {
  std::error_code none;
  const std::filesystem::path near = std::filesystem::proximate(as_path(file), folder.empty() ? "." : folder, none);
  return (none ? as_path(file) : near).generic_string();
}

}  // namespace

Project::Project(QWidget* parent) : QWidget(parent) {
  editor_ = new SceneEditor;
  problem_ = named(new QLabel, "problem", tr("Error in the scene"));
  problem_->setWordWrap(true);
  problem_->setTextFormat(Qt::PlainText);
  problem_->setContentsMargins(4, 2, 4, 2);
  messages_ = new MessageBar;
  auto* left = new QWidget;
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(make_views(), 1);
  column->addWidget(problem_);
  splitter_ = named(new QSplitter(Qt::Horizontal), "splitter", tr("Scene and pages"));
  splitter_->addWidget(left);
  add_pages();
  splitter_->setStretchFactor(1, 1);
  splitter_->setSizes({500, 780});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(messages_);
  all->addWidget(splitter_, 1);
  setAccessibleName(tr("Project"));
  connect(editor_, &SceneEditor::settled, this, &Project::check);
  connect(editor_->document(), &QTextDocument::modificationChanged, this, &Project::title_changed);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, &Project::file_changed);
}

/// The text, and the same as a form.
QWidget* Project::make_views() {
  form_ = new SceneForm;
  views_ = named(new QTabWidget, "scene_views", tr("Scene as text or form"));
  views_->setDocumentMode(true);
  views_->addTab(editor_, tr("Text"));
  views_->addTab(form_, tr("Form"));
  connect(views_, &QTabWidget::currentChanged, this, &Project::show_form);
  connect(form_, &SceneForm::edit_wanted, this, &Project::edit);
  connect(form_, &SceneForm::text_wanted, editor_, &SceneEditor::replace_text);
  return views_;
}

void Project::show_form() {
  if (views_->currentWidget() != form_) return;
  form_->set_folder(as_name(path().parent_path()));
  form_->show_text(editor_->text(), editor_->error(), of_another_kind_);
}

void Project::switch_view(bool to_form) {
  views_->setCurrentIndex(to_form ? 1 : 0);
  if (!to_form) return editor_->setFocus();
  if (!form_->go_to_error()) form_->go_to_first();
}

void Project::go_to_error() {
  const auto& error = editor_->error();
  if (!error || (views_->currentWidget() == form_ && form_->go_to_error())) return;
  views_->setCurrentIndex(0);
  editor_->go_to_line(error->line);
}

void Project::commit() { form_->commit(); }

void Project::undo() {
  editor_->undo();
  check();
}

void Project::redo() {
  editor_->redo();
  check();
}

bool Project::is_modified() const { return editor_->document()->isModified(); }

void Project::check() {
  const std::string text = editor_->text();
  checked_ = check_scene(text, path());
  check_other_kinds(text);
  editor_->set_error(checked_.error);
  show_problem();
  show_form();
  show_scene();
}

/// Scenes of other kinds are checked by their pages, whose tabs are seen with a scene of their kind.
void Project::check_other_kinds(const std::string& text) {
  of_another_kind_ = false;
  const auto tell = [this](auto& later, bool is_of_kind) {
    of_another_kind_ = of_another_kind_ || is_of_kind;
    if (later.made() != nullptr) {
      later.tell();
    } else if (is_of_kind) {
      later.get();
    }
    later.set_tab_visible(is_of_kind);
  };
  tell(couple_page_, is_couple_scene(text));
  tell(response_page_, response_kind().is_of(text));
  tell(laws_page_, law_kind().is_of(text));
  tell(oscillate_page_, oscillate_kind().is_of(text));
  tell(lines_page_, line_kind().is_of(text));
}

void Project::protect_inputs(QWidget& page) const {
  for (CellTable* table : page.findChildren<CellTable*>()) table->protect(inputs_of(checked_.seen()));
}

void Project::show_scene() {
  protect_inputs(*pages_);
  solve_page_->set_file(file_, editor_->text());
  solve_page_->set_scene(checked_.scene);
  compare_page_.tell();
  plan_page_.tell();
  study_page_.tell();
  modal_page_.tell();
  if (!checked_.seen()) return;
  const std::string files = path().parent_path().string() + '\n' + tables_below(editor_->text(), "data");
  data_page_->set_scene(*checked_.seen(), files);
  geometry_page_->set_scene(*checked_.seen(), files);
  geometry_page_->set_own_lines(ident::readable_lines(editor_->text()));
}

/// Planning and solving know more than the reader of scenes: what they say stands below its line, too.
void Project::show_failure(const InputError& error) {
  if (checked_.error) return;
  editor_->set_error(located(error, editor_->text()));
  show_form();
}

/// A value that was chosen on a page or in the form, as a step of the text that can be undone; an empty one leaves the key out.
void Project::edit(const std::string& table, const std::string& key, const std::string& value) {
  const std::string text = editor_->text();
  editor_->replace_text(value.empty() ? without_value(text, table, key) : with_value(text, table, key, value));
}

void Project::fold_text() {
  QWidget* const text = splitter_->widget(0);
  text->setVisible(!text->isVisible());
  if (!text->isVisible()) pages_->currentWidget()->setFocus();
}

double Project::seconds_of_runs() const {
  double seconds = 0.0;
  for (const Solved& run : solve_page_->runs()) {
    if (run.kept.isEmpty()) seconds += run.solution.runtime_s.total;
  }
  return seconds;
}

/// A command line names the file, in which unsaved edits are not.
void Project::watch_commands(QWidget& page) {
  for (QPushButton* button : page.findChildren<QPushButton*>()) {
    if (!button->objectName().endsWith(QLatin1String("command"))) continue;
    connect(button, &QPushButton::clicked, this, [this] {
      if (is_modified() || file_.isEmpty())
        messages_->say(tr("The command line is copied. It names the saved scene; your edits since are not in it. Ctrl+S saves them."));
    });
  }
}

void Project::cancel() {
  solve_page_->cancel();
  const auto cancel_made = [](const auto&... pages) { ((pages.made() != nullptr ? pages.made()->cancel() : void()), ...); };
  cancel_made(compare_page_, study_page_, modal_page_, couple_page_, loading_curve_page_, plan_page_, response_page_, laws_page_,
              oscillate_page_, lines_page_, records_page_);
}

/// A way of a comparison becomes that of the scene, one step that can be undone, and is solved.
void Project::open_way(const study::Way& way) {
  editor_->replace_text(with_way(editor_->text(), way));
  check();
  pages_->setCurrentWidget(solve_page_);
  solve_page_->solve();
}

/// A file more in [data], as an edit. A project without a scene gets one beside the file.
void Project::take_frfs(const QString& file, bool of_assembly) {
  if (editor_->document()->isEmpty() && file_.isEmpty()) folder_ = QFileInfo(file).absolutePath();
  std::string text = editor_->text();
  for (const char* key : {"substructures", "assembly"}) {
    if (!value_of(text, "data", key) && !value_of(text, "data", "parts")) text = with_value(text, "data", key, "[]");
  }
  const std::string key = of_assembly ? "assembly" : value_of(text, "data", "parts") ? "parts" : "substructures";
  const std::string name = '"' + path_from(file, path().parent_path()) + '"';
  std::string list = value_of(text, "data", key).value_or("[]");
  if (!list.starts_with('[')) list = "[" + list + "]";
  const std::size_t end = list.rfind(']');
  const std::size_t last = list.find_last_not_of(" \n\t,", end - 1);
  list = list.substr(0, last + 1) + (last == 0 ? "" : ", ") + name + "]";
  editor_->replace_text(with_value(text, "data", key, list));
  check();
  messages_->say(tr("%1 is in [data] %2 of the scene.").arg(QFileInfo(file).fileName(), q(key)));
}

void Project::open_curves(const QStringList& files) {
  pages_->setCurrentWidget(loading_curve_page());
  loading_curve_page()->open(files);
}

void Project::open_records(const QStringList& files) {
  pages_->setCurrentWidget(records_page());
  records_page()->open(files);
}

void Project::say_proposed() {
  messages_->offer(tr("This scene is a proposal from the files. Its comments give the reasons. Check it, then save it."),
                   tr("Joint assistant…"), [this] { open_joint_assistant(); });
}

void Project::open_joint_assistant() {
  if (data_page_->is_busy()) return messages_->say(tr("The files are being read. Ask again in a moment."));
  if (editor_->text().find("[[joints]]") != std::string::npos)
    return messages_->warn(tr("The scene has several joints. Its form shows them one by one (F4)."));
  std::vector<frf::FrfHeader> parts;
  for (const LoadedFile& file : data_page_->files()) {
    if (!file.is_assembly && file.error.empty()) parts.push_back(file.header);
  }
  if (parts.size() < 2) return messages_->warn(tr("The assistant joins two substructures or more. The scene has %1.").arg(parts.size()));
  auto* const assistant = new JointAssistant(std::move(parts), this);
  assistant->setAttribute(Qt::WA_DeleteOnClose);
  connect(assistant, &QDialog::accepted, this, [this, assistant] {
    editor_->replace_text(with_joint(editor_->text(), assistant->joint()));
    check();
  });
  assistant->set_forecast([text = editor_->text(), file = path()](const tasks::JointLayout& layout, const Worker::Watch& watch) {
    return tasks::forecast_joint(ident::parse_scene(with_joint(text, layout), file), control_of(watch));
  });
  assistant->open();
}

void Project::offer_dofs() {
  std::vector<frf::Dof> all;
  for (const LoadedFile& file : data_page_->files()) {
    for (const auto* dofs : {&file.header.response, &file.header.reference}) {
      for (const frf::Dof& dof : *dofs) {
        if (!frf::has(all, dof)) all.push_back(dof);
      }
    }
  }
  std::ranges::sort(all, {}, frf::coordinate_key);
  dofs_.clear();
  for (const frf::Dof& dof : all) dofs_ << QString::fromStdString(dof.name());
  editor_->set_dofs(dofs_);
  form_->set_dofs(dofs_);
  if (PlanPage* const page = plan_page_.made()) page->set_dofs(dofs_);
}

void Project::show_problem() {
  if (editor_->document()->isEmpty()) return problem_->setText(tr("There is no scene. The pages Curves and Records need none."));
  if (!checked_.error) return problem_->setText(tr("The scene is complete."));
  const SceneError& error = *checked_.error;
  const QString place = error.line > 0 ? tr("Line %1: ").arg(error.line) : QString();
  const QString remedy = error.remedy.empty() ? QString() : "; " + QString::fromStdString(error.remedy);
  problem_->setText(place + QString::fromStdString(error.problem) + remedy);
}

QByteArray Project::layout_state() const { return splitter_->saveState(); }

void Project::restore_layout(const QByteArray& state) { splitter_->restoreState(state); }

}  // namespace jointid::gui
