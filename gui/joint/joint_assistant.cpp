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
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/text/direction_names.hpp"
#include "gui/help/help_keys.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/job_progress.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

using tasks::JointForm;
using tasks::NodePair;

constexpr int forecast_after_ms = 400;
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

/// Why the pairs are no plates, or nothing.
QString plate_fault(const tasks::JointLayout& layout, const std::vector<frf::FrfHeader>& parts) {
  try {
    tasks::plate_of(layout.pairs, parts);
  } catch (const InputError& error) {
    return QString::fromUtf8(error.what());
  }
  return {};
}

QString percent_text(double share) { return std::isfinite(share) ? q(percent(share)) : JointAssistant::tr("without limit"); }

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
  forecast_text_ = named(new QLabel, "joint_forecast", tr("Expected time and intervals"));
  forecast_text_->setWordWrap(true);
  forecast_text_->setTextFormat(Qt::PlainText);
  worker_ = new Worker(this);
  later_.setSingleShot(true);
  later_.setInterval(forecast_after_ms);
  connect(&later_, &QTimer::timeout, this, &JointAssistant::ask_forecast);
  connect(worker_, &Worker::failed, this,
          [this](const InputError& error) { forecast_text_->setText(tr("No forecast: %1").arg(QString::fromUtf8(error.what()))); });
  buttons_ = named(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::Help),
                   "joint_buttons", tr("Write the joint, or leave it"));
  auto* all = new QVBoxLayout(this);
  all->addWidget(hint);
  all->addWidget(list_, 1);
  all->addLayout(make_adding());
  all->addLayout(make_directions());
  all->addLayout(make_forms());
  all->addWidget(word_);
  all->addWidget(forecast_text_);
  all->addWidget(buttons_);
  for (const NodePair& pair : found_in(parts_)) add(pair);
  if (pairs_.empty()) hint->setText(tr("No two nodes of different parts lie near each other. Add the pairs that are joined."));
  connect(list_, &QTreeWidget::itemChanged, this, &JointAssistant::show_counts);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons_, &QDialogButtonBox::helpRequested, this, [this] { show_help_of(this); });
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
  const char* const names[] = {"joint_springs", "joint_equal", "joint_full", "joint_plate"};
  const QString titles[] = {tr("A spring for every pair and direction"), tr("Equal bolts: a spring for every direction"),
                            tr("Full symmetric matrices"), tr("Rigid plates: six springs between two virtual points")};
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
  if (form == JointForm::plate && plate_fault(out, parts_).isEmpty()) out.plate = tasks::plate_of(out.pairs, parts_);
  return out;
}

void JointAssistant::show_counts() {
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    const auto unknowns = static_cast<int>(tasks::unknowns_of(joint_in(static_cast<JointForm>(i))));
    forms_[i]->setText(tr("%1: %n unknown(s)", nullptr, unknowns).arg(forms_[i]->accessibleName()));
  }
  show_word();
  if (!forecast_) return;
  ++asked_;
  worker_->cancel();
  forecast_text_->clear();
  if (buttons_->button(QDialogButtonBox::Ok)->isEnabled()) later_.start();
}

void JointAssistant::show_word() {
  const tasks::JointLayout now = joint();
  const bool no_plate = now.form == JointForm::plate && !now.plate;
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(!now.pairs.empty() && !no_plate);
  if (no_plate) return word_->setText(plate_fault(now, parts_));
  const bool many = tasks::unknowns_of(now) > tasks::many_unknowns;
  word_->setText(many ? tr("Few tests determine more than %1 unknowns, and solving takes long.").arg(tasks::many_unknowns) : QString());
}

void JointAssistant::set_forecast(Forecast forecast) {
  forecast_ = std::move(forecast);
  show_counts();
}

QString JointAssistant::forecast() const { return forecast_text_->text(); }

void JointAssistant::ask_forecast() {
  forecast_text_->setText(tr("Forecasting time and intervals …"));
  worker_->add([this, number = asked_, layout = joint(), forecast = forecast_](const Worker::Watch& watch) -> Worker::Deliver {
    return [this, number, found = forecast(layout, watch)] {
      if (number == asked_) show_forecast(found);
    };
  });
}

void JointAssistant::show_forecast(const tasks::JointForecast& found) {
  const QString time = found.seconds < 1.0 ? tr("Less than a second") : tr("About %1").arg(duration_text(found.seconds));
  if (found.bounds.empty()) return forecast_text_->setText(tr("%1. No intervals: %2.").arg(time, q(found.why)));
  const auto [middle, worst] = tasks::relative_intervals(found);
  forecast_text_->setText(tr("%1. 95 % intervals, about: ± %2 in the middle, ± %3 of the worst unknown.")
                              .arg(time, percent_text(middle), percent_text(worst)));
}

}  // namespace jointid::gui
