#include "gui/records/records_page.hpp"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "base/error.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/file_drop.hpp"
#include "gui/look/named.hpp"
#include "gui/look/output.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "gui/page/job_line.hpp"
#include "gui/records/record_preview.hpp"
#include "gui/records/record_tools.hpp"
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

RecordsPage::RecordsPage(QWidget* parent)
    : FindingsPage({"records", tr("Time records"), tr("Status of the time records"), tr("Results of the time records"),
                    tr("Drop a time record here, or choose it: text, UFF 58, MATLAB, HDF5 or numpy, one column per "
                       "channel.\nChoose an analysis and the channels, then run it."),
                    tr("Tables of the time records")},
                   parent),
      all_(record_tools()) {
  let_drop_files(*this, [this](const QStringList& files) { open(files); });
  add_above(make_top());
  forms_ = named(new QStackedWidget, "records_forms", tr("Options of the analysis"));
  for (const RecordTool& each : all_) {
    auto* const form = new ToolForm(each);
    forms_->addWidget(form);
    if (each.runs_again) connect(form, &ToolForm::changed, this, &RecordsPage::run_again);
  }
  forms_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  add_above(forms_);
  fit_forms();
  connect(tool_, &QComboBox::currentIndexChanged, this, &RecordsPage::show_tool);
  show_buttons();
}

QWidget* RecordsPage::make_top() {
  auto* top = named(new QWidget, "records_top", tr("Time records"));
  auto* choose = push_button("records_files", tr("Files…"), tr("Choose time records: text, UFF 58, MATLAB, HDF5 or numpy"));
  tool_ = named(new QComboBox, "records_tool", tr("Analysis of the time records"));
  for (const RecordTool& each : all_) tool_->addItem(each.title);
  run_ = push_button("records_run", tr("Run"), tr("Run the analysis, as the command does"));
  names_ = named(new QLabel, "records_names", tr("Files"));
  names_->setTextFormat(Qt::PlainText);
  names_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // long names make no page wide
  auto* rows = new QVBoxLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(buttons_behind({choose, run_}));
  role_ = named(new QComboBox, "records_role", tr("What the FRFs are of"));
  role_->addItems({tr("of a substructure"), tr("of the assembly")});
  to_scene_ =
      push_button("records_to_scene", tr("To the scene…"), tr("Write the FRFs into a file, and name it in [data] of the scene"));
  auto* second = new QHBoxLayout;
  second->addWidget(tool_);
  second->addWidget(names_, 1);
  for (QWidget* each : std::initializer_list<QWidget*>{role_, to_scene_}) second->addWidget(each);
  rows->addLayout(second);
  connect(choose, &QPushButton::clicked, this, [this] {
    const QStringList files = choose_files_to_open(this);
    if (!files.isEmpty()) open(files);
  });
  connect(run_, &QPushButton::clicked, this, &RecordsPage::run);
  connect(to_scene_, &QPushButton::clicked, this, &RecordsPage::ask_and_write_frfs);
  return top;
}

const RecordTool& RecordsPage::tool() const { return all_[static_cast<std::size_t>(tool_->currentIndex())]; }

ToolForm& RecordsPage::form() const { return *static_cast<ToolForm*>(forms_->widget(tool_->currentIndex())); }

void RecordsPage::choose_tool(const std::string& name) {
  const auto found = std::ranges::find(all_, name, &RecordTool::name);
  if (found != all_.end()) tool_->setCurrentIndex(static_cast<int>(found - all_.begin()));
}

/// What was set since, where something is shown and the tool is quick.
void RecordsPage::run_again() {
  if (shown() == nullptr || !tool().runs_again || form().values() == used_) return;
  line()->cancel();
  begin();
}

void RecordsPage::ask_and_write_frfs() {
  const QFileInfo record(files_.front());
  const QString file =
      choose_file_to_save(this, tr("Save the FRFs"), record.absolutePath() + "/" + record.completeBaseName() + "_frf.h5",
                          tr("FRFs (*.h5 *.uff)"), QStringLiteral("h5"));
  if (!file.isEmpty()) write_frfs(file);
}

void RecordsPage::write_frfs(const QString& file) {
  if (shown() == nullptr || !shown()->write_frfs) return;
  try {
    check_output(file, paths_of(files_));
    shown()->write_frfs(as_path(file));
  } catch (const InputError& error) {
    return line()->say(QString::fromUtf8(error.what()), true);
  }
  line()->say(tr("Written to %1.").arg(file));
  Q_EMIT frfs_written(file, role_->currentIndex() == 1);
}

/// As high as the form in front.
void RecordsPage::fit_forms() {
  for (int i = 0; i < forms_->count(); ++i) {
    const bool is_in_front = i == tool_->currentIndex();
    forms_->widget(i)->setSizePolicy(QSizePolicy::Preferred, is_in_front ? QSizePolicy::Preferred : QSizePolicy::Ignored);
  }
}

void RecordsPage::show_tool() {
  fit_forms();
  forms_->setCurrentIndex(tool_->currentIndex());
  line()->say(tool().plot_hint);
  show_buttons();
}

void RecordsPage::show_buttons() {
  run_->setEnabled(!files_.isEmpty() && !is_busy());
  tool_->setEnabled(!is_busy());
  command()->setEnabled(!files_.isEmpty());
  const bool makes_frfs = tool().runs_again;
  for (QWidget* each : std::initializer_list<QWidget*>{role_, to_scene_}) each->setVisible(makes_frfs);
  to_scene_->setEnabled(!is_busy() && shown() != nullptr && shown()->write_frfs != nullptr);
}

/// The channels of the first file are offered.
void RecordsPage::open(const QStringList& files) {
  files_ = files;
  QStringList names;
  for (const QString& file : files_) names << QFileInfo(file).fileName();
  names_->setText(names.join(QStringLiteral(", ")));
  line()->worker().add([this, path = as_path(files_.front())](const Worker::Watch& watch) -> Worker::Deliver {
    const auto samples = records::open_samples(path);
    QStringList channels;
    for (const auto& channel : samples->channels()) channels << q(channel.name);
    report::PlotGroup preview;
    try {
      preview = record_preview(path, watch.interrupted);
    } catch (const InputError&) {
      preview = {};  // what is wrong is said when it is run
    }
    return [this, channels, preview] {
      plots()->show_groups({{tr("record"), preview}});
      for (int k = 0; k < forms_->count(); ++k) static_cast<ToolForm*>(forms_->widget(k))->offer(channels);
      line()->say(tr("Channels: %1").arg(channels.join(QStringLiteral(", "))));
    };
  });
  show_buttons();
}

void RecordsPage::run() {
  if (!files_.isEmpty() && !is_busy()) begin();
}

void RecordsPage::begin() {
  if (files_.size() > 1 && !tool().takes_several) {
    line()->say(tr("%1 takes one file; %2 were opened.").arg(tool().title).arg(files_.size()), true);
    return;
  }
  const ToolValues values = form().values();
  used_ = values;
  outputs()->protect(inputs_of(tool(), files_, values));
  ask([find = tool().run, files = paths_of(files_), values](const Worker::Watch& watch) { return find(files, values, watch); });
}

QString RecordsPage::command_line() const {
  QString text = tool().command;
  for (const QString& file : files_) text += " " + shell_word(file);
  return text + options_of(tool(), form().values());
}

}  // namespace jointid::gui
