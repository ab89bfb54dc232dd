#include "gui/joint/joint_assistant.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <algorithm>

#include "base/text.hpp"
#include "frf/text/direction_names.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

using tasks::JointForm;
using tasks::NodePair;

constexpr int node_role = Qt::UserRole, part_role = Qt::UserRole + 1;

QString direction_name(std::size_t i) {
  const std::string_view name = frf::direction_names[i];
  return QString::fromLatin1(name.data(), static_cast<int>(name.size()));
}

QString directions_text(const NodePair& pair) {
  QStringList words;
  for (const frf::Direction direction : pair.directions)
    words << direction_name(static_cast<std::size_t>(direction) - 1);
  return words.join(QStringLiteral(", "));
}

std::vector<NodePair> found_in(const std::vector<frf::FrfHeader>& parts) {
  std::vector<const frf::FrfHeader*> all;
  for (const frf::FrfHeader& part : parts) all.push_back(&part);
  return tasks::propose_pairs(all);
}

}  // namespace

JointAssistant::JointAssistant(std::vector<frf::FrfHeader> parts, QWidget* parent) : QDialog(parent), parts_(std::move(parts)) {
  named(this, "joint_assistant", tr("Joint assistant"));
  setWindowTitle(tr("Joint assistant"));
  list_ = named(new QTreeWidget, "joint_pairs", tr("Pairs of nodes. Ticked: joined"), tr("Space joins the nodes of a pair, or parts them"));
  list_->setHeaderLabels({tr("Nodes"), tr("Gap in mm"), tr("Directions")});
  list_->setRootIsDecorated(false);
  auto* hint = named(new QLabel(tr("Tick the pairs of nodes that a bolt, a weld or a pad joins.")), "joint_hint", tr("What to do"));
  hint->setWordWrap(true);
  word_ = named(new QLabel, "joint_word", tr("About the number of unknowns"));
  word_->setWordWrap(true);
  buttons_ = named(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel), "joint_buttons",
                   tr("Write the joint, or leave it"));
  auto* all = new QVBoxLayout(this);
  all->addWidget(hint);
  all->addWidget(list_, 1);
  all->addLayout(make_adding());
  all->addLayout(make_directions());
  all->addLayout(make_forms());
  all->addWidget(word_);
  all->addWidget(buttons_);
  for (const NodePair& pair : found_in(parts_)) add(pair);
  if (pairs_.empty()) hint->setText(tr("No two nodes of different parts lie near each other. Add the pairs that are joined."));
  connect(list_, &QTreeWidget::itemChanged, this, &JointAssistant::show_counts);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  show_counts();
  resize(520, 520);
  list_->setFocus();
}

/// Two nodes of different parts, for files without positions.
QLayout* JointAssistant::make_adding() {
  first_ = named(new QComboBox, "joint_first", tr("Node of one part"));
  second_ = named(new QComboBox, "joint_second", tr("Node of another part"));
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const QString file = QFileInfo(q(parts_[part].file)).fileName();
    for (const std::int64_t node : tasks::couplable_nodes(parts_[part])) {
      QComboBox* const box = part == 0 ? first_ : second_;
      for (QComboBox* each : parts_.size() > 2 ? std::vector{first_, second_} : std::vector{box}) {
        each->addItem(QStringLiteral("%1 (%2)").arg(node).arg(file), static_cast<qlonglong>(node));
        each->setItemData(each->count() - 1, static_cast<qulonglong>(part), part_role);
      }
    }
  }
  auto* more = push_button("joint_add", tr("Add pair"), tr("Add the two nodes to the pairs"));
  more->setAutoDefault(false);  // Enter writes the joint
  connect(more, &QPushButton::clicked, this, &JointAssistant::add_chosen);
  return row_of({first_, second_, more}, {});
}

QLayout* JointAssistant::make_directions() {
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Directions:")));
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const QString name = direction_name(i);
    directions_[i] = named(new QCheckBox(name), ("joint_" + name.toLower()).toLatin1().constData(), tr("Joined along %1").arg(name));
    directions_[i]->setChecked(true);
    directions_[i]->hide();
    row->addWidget(directions_[i]);
    connect(directions_[i], &QCheckBox::toggled, this, &JointAssistant::show_counts);
  }
  row->addStretch(1);
  return row;
}

QLayout* JointAssistant::make_forms() {
  const char* const names[] = {"joint_springs", "joint_equal", "joint_full"};
  const QString titles[] = {tr("A spring for every pair and direction"), tr("Equal bolts: a spring for every direction"),
                            tr("Full symmetric matrices")};
  auto* column = new QVBoxLayout;
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    forms_[i] = named(new QRadioButton, names[i], titles[i]);
    column->addWidget(forms_[i]);
  }
  forms_[0]->setChecked(true);
  damping_ = named(new QCheckBox(tr("with hysteretic damping")), "joint_damping", tr("Hysteretic damping beside every stiffness"));
  damping_->setChecked(true);
  column->addWidget(damping_);
  for (QRadioButton* each : forms_) connect(each, &QRadioButton::toggled, this, &JointAssistant::show_counts);
  connect(damping_, &QCheckBox::toggled, this, &JointAssistant::show_counts);
  return column;
}

void JointAssistant::add(const NodePair& pair) {
  const QSignalBlocker quiet(list_);
  const QString gap = pair.gap_m ? q(digits(*pair.gap_m * 1e3, "%.3g")) : QString();
  auto* item = new QTreeWidgetItem(list_, {QStringLiteral("%1 – %2").arg(pair.first).arg(pair.second), gap, directions_text(pair)});
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  item->setCheckState(0, pair.likely ? Qt::Checked : Qt::Unchecked);
  if (list_->currentItem() == nullptr) list_->setCurrentItem(item);
  pairs_.push_back(pair);
  for (const frf::Direction direction : pair.directions) directions_[static_cast<std::size_t>(direction) - 1]->show();
}

void JointAssistant::add_chosen() {
  const auto part = [](const QComboBox& box) { return static_cast<std::size_t>(box.currentData(part_role).toULongLong()); };
  if (first_->currentIndex() < 0 || second_->currentIndex() < 0) return;
  const std::size_t one = part(*first_), other = part(*second_);
  if (one == other) return word_->setText(tr("Both nodes are of one part: take nodes of two parts."));
  NodePair pair = tasks::pair_of(parts_[one], first_->currentData(node_role).toLongLong(), parts_[other],
                                 second_->currentData(node_role).toLongLong());
  if (pair.directions.empty()) return word_->setText(tr("The two nodes share no direction that is response and reference."));
  const auto same = [&](const NodePair& known) { return known.first == pair.first && known.second == pair.second; };
  if (std::ranges::any_of(pairs_, same)) return word_->setText(tr("The pair is in the list."));
  pair.likely = true;
  add(pair);
  show_counts();
  const auto next = [](QComboBox& box) { box.setCurrentIndex(std::min(box.currentIndex() + 1, box.count() - 1)); };
  next(*first_);
  next(*second_);
}

JointForm JointAssistant::form() const {
  const auto chosen = std::ranges::find_if(forms_, [](const QRadioButton* each) { return each->isChecked(); });
  return static_cast<JointForm>(chosen - forms_.begin());
}

tasks::JointLayout JointAssistant::joint_in(JointForm form) const {
  tasks::JointLayout out{{}, form, damping_->isChecked()};
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (list_->topLevelItem(static_cast<int>(i))->checkState(0) != Qt::Checked) continue;
    NodePair pair = pairs_[i];
    std::erase_if(pair.directions, [this](frf::Direction each) { return !directions_[static_cast<std::size_t>(each) - 1]->isChecked(); });
    if (!pair.directions.empty()) out.pairs.push_back(std::move(pair));
  }
  return out;
}

void JointAssistant::show_counts() {
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    const auto unknowns = static_cast<int>(tasks::unknowns_of(joint_in(static_cast<JointForm>(i))));
    forms_[i]->setText(tr("%1: %n unknown(s)", nullptr, unknowns).arg(forms_[i]->accessibleName()));
  }
  const tasks::JointLayout now = joint();
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(!now.pairs.empty());
  const bool many = tasks::unknowns_of(now) > tasks::many_unknowns;
  word_->setText(many ? tr("Few tests determine more than %1 unknowns, and solving takes long.").arg(tasks::many_unknowns) : QString());
}

}  // namespace jointid::gui
