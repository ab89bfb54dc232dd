#include "gui/page/findings_page.hpp"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "base/control.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/scrolled.hpp"
#include "gui/page/job_line.hpp"

namespace jointid::gui {

FindingsPage::FindingsPage(const Names& names, QWidget* parent) : QWidget(parent) {
  setAccessibleName(names.title);
  line_ = new JobLine(names.name, names.status, tr("Stop without showing results"));
  outputs_ = new OutputButtons(names.name, *line_);
  command_ =
      push_button((names.name + "_command").c_str(), tr("Copy as command"), tr("Copy the command line with the same results"));
  plots_ = new PlotMenu((names.name + "_plots").c_str(), names.plots, names.plot_hint);
  tables_ = new TableMenu(names.name + "_tables", names.tables);
  auto* both = named(new QSplitter(Qt::Vertical), (names.name + "_both").c_str(), tr("Diagram and tables"));
  both->addWidget(plots_);
  both->addWidget(tables_);
  both->setStretchFactor(0, 1);
  both->setSizes({430, 220});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(line_);
  all->addWidget(scrolled(both), 1);
  connect(line_, &JobLine::failed, this, &FindingsPage::failed);
  connect(line_, &JobLine::busy_changed, this, [this] { show_buttons(); });
  connect(command_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_line()); });
}

void FindingsPage::add_above(QWidget* widget) { static_cast<QVBoxLayout*>(layout())->insertWidget(above_++, widget); }

QLayout* FindingsPage::buttons_behind(std::initializer_list<QWidget*> first) {
  auto* row = new QHBoxLayout;
  for (QWidget* each : first) row->addWidget(each);
  row->addLayout(row_of({line_->cancel_button()}, {outputs_, command_}), 1);
  return row;
}

bool FindingsPage::is_busy() const { return line_->is_busy(); }

QString FindingsPage::status() const { return line_->status(); }

void FindingsPage::cancel() { line_->cancel(); }

void FindingsPage::ask(std::function<Findings(const Worker::Watch&)> find) {
  line_->say(tr("Computing …"));
  line_->worker().add([this, find = std::move(find)](const Worker::Watch& watch) -> Worker::Deliver {
    auto found = std::make_shared<const Findings>(find(watch));
    stop_if(watch.interrupted);
    return [this, found] {
      found_ = found;
      line_->say(found->said, found->is_bad);
      outputs_->offer(found->outputs);
      plots_->show_groups(found->plots, found->maps);
      tables_->show_tables(found->tables);
      show_buttons();
    };
  });
}

}  // namespace jointid::gui
