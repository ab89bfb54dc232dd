#include "gui/records/records_page.hpp"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "base/control.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/named.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "gui/page/job_line.hpp"
#include "gui/records/tool_form.hpp"
#include "records/file/open_samples.hpp"

namespace jointid::gui {
namespace {

std::vector<std::filesystem::path> paths_of(const QStringList& files) {
  std::vector<std::filesystem::path> out;
  for (const QString& file : files) out.push_back(as_path(file));
  return out;
}

/// Files that no output may replace.
std::vector<std::filesystem::path> inputs_of(const RecordTool& tool, const QStringList& files, const ToolValues& values) {
  std::vector<std::filesystem::path> out = paths_of(files);
  for (const ToolField& field : tool.fields) {
    const auto place = values.find(field.option);
    if (field.kind == ToolField::Kind::file && place != values.end()) out.push_back(as_path(place->second));
  }
  return out;
}

}  // namespace

RecordsPage::RecordsPage(QWidget* parent) : QWidget(parent), all_(record_tools()) {
  setAccessibleName(tr("Time records"));
  setAcceptDrops(true);
  line_ = new JobLine("records", tr("Status of the time records"), tr("Stop; nothing is shown then"));
  plots_ = new PlotMenu("records_plots", tr("What the records say"),
                        tr("Drop a time record here, or choose it: text, UFF 58, MATLAB, HDF5 or numpy, a column a channel.\n"
                           "Choose what is asked of it and its channels, and run."));
  tables_ = new TableMenu("records_tables", tr("Numbers of the records"));
  auto* both = named(new QSplitter(Qt::Vertical), "records_both", tr("Diagram and tables"));
  both->addWidget(plots_);
  both->addWidget(tables_);
  both->setStretchFactor(0, 1);
  both->setSizes({430, 220});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(make_top());
  forms_ = named(new QStackedWidget, "records_forms", tr("What the tool wants to know"));
  for (const RecordTool& each : all_) forms_->addWidget(new ToolForm(each));
  forms_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  all->addWidget(forms_);
  all->addWidget(line_);
  all->addWidget(both, 1);
  connect(line_, &JobLine::failed, this, &RecordsPage::failed);
  connect(line_, &JobLine::busy_changed, this, &RecordsPage::show_buttons);
  connect(tool_, &QComboBox::currentIndexChanged, this, &RecordsPage::show_tool);
  show_buttons();
}

QWidget* RecordsPage::make_top() {
  auto* top = named(new QWidget, "records_top", tr("Time records"));
  auto* choose = push_button("records_files", tr("Files…"), tr("Choose time records: text, UFF 58, MATLAB, HDF5 or numpy"));
  tool_ = named(new QComboBox, "records_tool", tr("What is asked of the records"));
  for (const RecordTool& each : all_) tool_->addItem(each.title);
  run_ = push_button("records_run", tr("Run"), tr("Ask it of the records, as the command does"));
  command_ = push_button("records_command", tr("Copy as command"), tr("Copy the command line that finds the same"));
  outputs_ = new OutputButtons("records", *line_);
  names_ = named(new QLabel, "records_names", tr("Files"));
  names_->setTextFormat(Qt::PlainText);
  names_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // long names make no page wide
  auto* rows = new QVBoxLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({choose, run_, line_->cancel_button()}, {outputs_, command_}));
  rows->addLayout(row_of({tool_}, {}));
  rows->addWidget(names_);
  connect(choose, &QPushButton::clicked, this, [this] {
    const QStringList files = choose_files_to_open(this);
    if (!files.isEmpty()) open(files);
  });
  connect(run_, &QPushButton::clicked, this, &RecordsPage::run);
  connect(command_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_line()); });
  return top;
}

const RecordTool& RecordsPage::tool() const { return all_[static_cast<std::size_t>(tool_->currentIndex())]; }

ToolForm& RecordsPage::form() const { return *static_cast<ToolForm*>(forms_->widget(tool_->currentIndex())); }

bool RecordsPage::is_busy() const { return line_->is_busy(); }

QString RecordsPage::status() const { return line_->status(); }

void RecordsPage::cancel() { line_->cancel(); }

void RecordsPage::show_tool() {
  forms_->setCurrentIndex(tool_->currentIndex());
  line_->say(tool().plot_hint);
}

void RecordsPage::show_buttons() {
  run_->setEnabled(!files_.isEmpty() && !is_busy());
  tool_->setEnabled(!is_busy());
  command_->setEnabled(!files_.isEmpty());
}

/// The channels of the first file are offered.
void RecordsPage::open(const QStringList& files) {
  files_ = files;
  QStringList names;
  for (const QString& file : files_) names << QFileInfo(file).fileName();
  names_->setText(names.join(QStringLiteral(", ")));
  line_->worker().add([this, path = as_path(files_.front())](const Worker::Watch&) -> Worker::Deliver {
    const auto samples = records::open_samples(path);
    QStringList channels;
    for (const auto& channel : samples->channels()) channels << q(channel.name);
    return [this, channels] {
      for (int k = 0; k < forms_->count(); ++k) static_cast<ToolForm*>(forms_->widget(k))->offer(channels);
      line_->say(tr("Channels: %1").arg(channels.join(QStringLiteral(", "))));
    };
  });
  show_buttons();
}

void RecordsPage::run() {
  if (files_.isEmpty() || is_busy()) return;
  if (files_.size() > 1 && !tool().takes_several) {
    line_->say(tr("%1 takes one file, and %2 were opened.").arg(tool().title).arg(files_.size()), true);
    return;
  }
  line_->say(tr("Computing …"));
  const ToolValues values = form().values();
  outputs_->protect(inputs_of(tool(), files_, values));
  line_->worker().add([this, ask = tool().run, files = paths_of(files_), values](const Worker::Watch& watch) -> Worker::Deliver {
    auto found = std::make_shared<const SceneFindings>(ask(files, values, watch));
    stop_if(watch.interrupted);
    return [this, found] { show_found(found); };
  });
}

void RecordsPage::show_found(std::shared_ptr<const SceneFindings> found) {
  found_ = std::move(found);
  line_->say(found_->said, found_->is_bad);
  outputs_->offer(found_->outputs);
  plots_->show_groups(found_->plots);
  tables_->show_tables(found_->tables);
  show_buttons();
}

QString RecordsPage::command_line() const {
  QString text = tool().command;
  for (const QString& file : files_) text += " " + shell_word(file);
  return text + options_of(tool(), form().values());
}

void RecordsPage::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void RecordsPage::dropEvent(QDropEvent* event) {
  const QStringList files = local_files(event->mimeData());
  if (!files.isEmpty()) open(files);
}

}  // namespace jointid::gui
