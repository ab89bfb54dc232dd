#include "gui/begin/example_dialog.hpp"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "base/error.hpp"
#include "gui/help/help_keys.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "problems/kinds/problem_kind.hpp"

namespace jointid::gui {

ExampleDialog::ExampleDialog(QWidget* parent) : QDialog(parent) {
  named(this, "example_dialog", tr("Open example"));
  setWindowTitle(tr("Open example"));
  filter_ = named(new QLineEdit, "example_filter", tr("Words that the example has"));
  filter_->setPlaceholderText(tr("Search: bolt, rubber, friction …"));
  filter_->setClearButtonEnabled(true);
  list_ = named(new QTreeWidget, "examples", tr("Examples with known answers"));
  list_->setHeaderLabels({tr("Name"), tr("What it is")});
  list_->setRootIsDecorated(false);
  list_->setAllColumnsShowFocus(true);
  buttons_ = named(new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel | QDialogButtonBox::Help),
                   "example_buttons", tr("Open the example, or leave it"));
  auto* all = new QVBoxLayout(this);
  all->addWidget(filter_);
  all->addWidget(list_, 1);
  all->addLayout(make_folder());
  all->addWidget(buttons_);
  fill();
  connect(filter_, &QLineEdit::textChanged, this, &ExampleDialog::show_matching);
  connect(list_, &QTreeWidget::currentItemChanged, this, &ExampleDialog::show_state);
  connect(list_, &QTreeWidget::itemActivated, this, &QDialog::accept);
  connect(folder_, &QLineEdit::textChanged, this, &ExampleDialog::show_state);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons_, &QDialogButtonBox::helpRequested, this, [this] { show_help_of(this); });
  resize(760, 520);
  show_state();
}

QLayout* ExampleDialog::make_folder() {
  folder_ = named(new QLineEdit(QDir::homePath() + QStringLiteral("/jointid-examples")), "example_folder", tr("Folder of the examples"),
                  tr("The files go into a folder of their own below this one"));
  auto* choose = push_button("example_choose", tr("Folder…"), tr("Choose the folder of the examples"));
  choose->setAutoDefault(false);
  connect(choose, &QPushButton::clicked, this, [this] {
    const QString chosen = QFileDialog::getExistingDirectory(this, tr("Folder of the examples"), folder_->text());
    if (!chosen.isEmpty()) folder_->setText(chosen);
  });
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Files to")));
  row->addWidget(folder_, 1);
  row->addWidget(choose);
  return row;
}

void ExampleDialog::fill() {
  for (const problems::ProblemKind& kind : problems::all_kinds()) {
    for (const problems::ProblemInfo& problem : kind.list()) {
      auto* item = new QTreeWidgetItem(list_, {q(problem.name), q(problem.description)});
      item->setToolTip(1, q(problem.description));
    }
  }
  list_->resizeColumnToContents(0);
  const QList<QTreeWidgetItem*> first = list_->findItems(QStringLiteral("bolts"), Qt::MatchExactly);
  list_->setCurrentItem(first.isEmpty() ? list_->topLevelItem(0) : first.front());
}

void ExampleDialog::show_matching() {
  const QStringList words = filter_->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  QTreeWidgetItem* first = nullptr;
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* const item = list_->topLevelItem(i);
    const QString text = item->text(0) + QLatin1Char(' ') + item->text(1);
    const bool has_all = std::ranges::all_of(words, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
    item->setHidden(!has_all);
    if (has_all && first == nullptr) first = item;
  }
  if (list_->currentItem() == nullptr || list_->currentItem()->isHidden()) list_->setCurrentItem(first);
  show_state();
}

void ExampleDialog::show_state() {
  buttons_->button(QDialogButtonBox::Open)->setEnabled(!name().empty() && !folder_->text().trimmed().isEmpty());
}

std::string ExampleDialog::name() const {
  const QTreeWidgetItem* const item = list_->currentItem();
  return item == nullptr || item->isHidden() ? std::string() : item->text(0).toStdString();
}

QString ExampleDialog::folder() const { return QDir(folder_->text().trimmed()).filePath(q(name())); }

QString write_example(const std::string& name, const QString& folder) {
  const problems::ProblemKind* const kind = problems::kind_of(problems::all_kinds(), name);
  if (kind == nullptr) throw InputError({ErrorKind::usage, "", name, "is no example", "choose one of the list"});
  QString target = folder;
  for (int copy = 2; QDir(target).exists() && !QDir(target).isEmpty(); ++copy) target = QStringLiteral("%1-%2").arg(folder).arg(copy);
  return as_name(kind->write(name, as_path(target), {}).file);
}

}  // namespace jointid::gui
