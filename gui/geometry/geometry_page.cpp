#include "gui/geometry/geometry_page.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalBlocker>
#include <QSlider>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <numbers>

#include "gui/geometry/structure_view.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/scene/scene_edit.hpp"
#include "gui/work/worker.hpp"

namespace jointid::gui {
namespace {

constexpr int picture_ms = 40;
constexpr int dof_role = Qt::UserRole;
constexpr double percent = 0.01;

QSlider* slider(const char* name, const QString& title, int value) {
  auto* made = named(new QSlider(Qt::Horizontal), name, title, title);
  made->setRange(1, 100);
  made->setValue(value);
  made->setMaximumWidth(120);
  return made;
}

std::vector<frf::Dof> references_of(const std::vector<LoadedFile>& files) {
  std::vector<frf::Dof> out;
  for (const LoadedFile& file : files) {
    if (!file.is_assembly || !file.error.empty()) continue;
    for (const frf::Dof& dof : file.header.reference) {
      if (!frf::has(out, dof)) out.push_back(dof);
    }
  }
  return out;
}

}  // namespace

GeometryPage::GeometryPage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Geometry"));
  worker_ = new Worker(this);
  view_ = new StructureView;
  list_ = named(new QListWidget, "dofs", tr("Measured DOFs; ticked: of the joint"),
                tr("Space ticks a DOF: it goes into [joint] dofs, or out of it"));
  status_ = named(new QLabel, "geometry_status", tr("About the structure"));
  status_->setWordWrap(true);
  status_->setTextFormat(Qt::PlainText);
  auto* both = named(new QSplitter(Qt::Horizontal), "dofs_and_structure", tr("DOFs and structure"));
  both->addWidget(list_);
  both->addWidget(view_);
  both->setStretchFactor(1, 1);
  both->setSizes({130, 600});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(make_controls());
  all->addWidget(both, 1);
  all->addWidget(status_);
  timer_.setInterval(picture_ms);
  connect(&timer_, &QTimer::timeout, this, &GeometryPage::next_picture);
  connect(list_, &QListWidget::itemChanged, this, &GeometryPage::item_changed);
  connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item != nullptr) view_->set_current(frf::Dof::parse(item->data(dof_role).toString().toStdString()));
  });
  connect(view_, &StructureView::dof_clicked, this, &GeometryPage::toggle);
  connect(worker_, &Worker::failed, this, [this](const InputError& error) { status_->setText(QString::fromUtf8(error.what())); });
}

QWidget* GeometryPage::make_controls() {
  auto* top = named(new QWidget, "geometry_top", tr("Motion"));
  reference_ = named(new QComboBox, "force_at", tr("Force at"), tr("Where a harmonic force moves the assembly"));
  reference_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  frequency_ = named(new QDoubleSpinBox, "force_frequency", tr("Frequency of the force"), tr("Follows the cursor of the plots"));
  frequency_->setRange(0.0, 1e6);
  frequency_->setSuffix(tr(" Hz"));
  frequency_->setKeyboardTracking(false);
  frequency_->findChild<QLineEdit*>()->setAccessibleName(tr("Frequency of the force"));
  play_ = named(new QToolButton, "play", tr("Move"), tr("Show the motion"));
  play_->setText(tr("Move"));
  play_->setCheckable(true);
  play_->setFocusPolicy(Qt::StrongFocus);
  amplitude_ = slider("amplitude", tr("Amplitude"), 25);
  speed_ = slider("speed", tr("Speed"), 30);
  auto* undeformed = named(new QCheckBox(tr("undeformed")), "undeformed", tr("Show the structure at rest, too"));
  undeformed->setChecked(true);
  auto* names = named(new QCheckBox(tr("numbers")), "node_numbers", tr("Show the numbers of nodes"));
  names->setChecked(true);
  auto* rows = new QVBoxLayout(top);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({new QLabel(tr("Force at")), reference_, frequency_, play_}, {undeformed, names}));
  rows->addLayout(row_of({new QLabel(tr("amplitude")), amplitude_, new QLabel(tr("speed")), speed_}, {}));
  connect(reference_, &QComboBox::activated, this, &GeometryPage::read_deflection);
  connect(frequency_, &QDoubleSpinBox::valueChanged, this, &GeometryPage::read_deflection);
  connect(amplitude_, &QSlider::valueChanged, this, &GeometryPage::show_deflection);
  connect(undeformed, &QCheckBox::toggled, view_, &StructureView::set_undeformed);
  connect(names, &QCheckBox::toggled, view_, &StructureView::set_names);
  connect(play_, &QToolButton::toggled, this, [this](bool on) {
    if (on)
      timer_.start();
    else
      timer_.stop();
    read_deflection();
  });
  return top;
}

bool GeometryPage::is_busy() const { return worker_->is_busy(); }

QString GeometryPage::status() const { return status_->text(); }

void GeometryPage::set_scene(const ident::Scene& scene, const std::string& signature) {
  joint_.clear();
  for (const auto& each : scene.joints) joint_.insert(joint_.end(), each.dofs.begin(), each.dofs.end());
  data_ = scene.data;
  wanted_signature_ = signature;
  show_joint();
  open_files_if_seen();
}

void GeometryPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  open_files_if_seen();
}

void GeometryPage::open_files_if_seen() {
  if (!isVisible() || wanted_signature_.empty() || wanted_signature_ == signature_) return;
  signature_ = wanted_signature_;
  worker_->cancel();
  worker_->add([this, data = data_](const Worker::Watch& watch) -> Worker::Deliver {
    const auto files = std::make_shared<std::vector<LoadedFile>>(open_files(data, watch.interrupted));
    return [this, files, structure = structure_of(*files, drawn_lines(data, watch.interrupted))] {
      files_ = files;
      show_structure(structure);
    };
  });
}

void GeometryPage::show_structure(const Structure& structure) {
  view_->set_structure(structure);
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const auto* dofs : {&structure.dofs, &structure.unplaced}) {
    for (const frf::Dof& dof : *dofs) {
      auto* item = new QListWidgetItem(q(dof.name()), list_);
      item->setData(dof_role, q(dof.name()));
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
      item->setCheckState(Qt::Unchecked);
    }
  }
  reference_->clear();
  for (const frf::Dof& dof : references_of(*files_)) reference_->addItem(q(dof.name()));
  status_->setText(tr("%1 nodes, %2 lines, %3 DOFs. Click an arrow, or tick a DOF, to take it into the joint or out of it.")
                       .arg(structure.nodes.size())
                       .arg(structure.lines.size())
                       .arg(structure.dofs.size() + structure.unplaced.size()));
  show_joint();
  read_deflection();
}

void GeometryPage::show_joint() {
  view_->set_joint(joint_);
  const QSignalBlocker quiet(list_);
  for (int i = 0; i < list_->count(); ++i) {
    const frf::Dof dof = frf::Dof::parse(list_->item(i)->data(dof_role).toString().toStdString());
    list_->item(i)->setCheckState(frf::has(joint_, dof) ? Qt::Checked : Qt::Unchecked);
  }
}

QListWidgetItem* GeometryPage::item_of(const frf::Dof& dof) const {
  for (int i = 0; i < list_->count(); ++i) {
    if (frf::Dof::parse(list_->item(i)->data(dof_role).toString().toStdString()).same_coordinate(dof)) return list_->item(i);
  }
  return nullptr;
}

/// By the list, which tells the rest.
void GeometryPage::toggle(const frf::Dof& dof) {
  QListWidgetItem* const item = item_of(dof);
  if (item == nullptr) return;
  list_->setCurrentItem(item);
  item->setCheckState(item->checkState() == Qt::Checked ? Qt::Unchecked : Qt::Checked);
}

void GeometryPage::item_changed(QListWidgetItem* item) {
  const frf::Dof dof = frf::Dof::parse(item->data(dof_role).toString().toStdString());
  const bool wanted = item->checkState() == Qt::Checked;
  if (wanted == frf::has(joint_, dof)) return;
  if (wanted)
    joint_.push_back(dof);
  else
    std::erase_if(joint_, [&](const frf::Dof& each) { return each.same_coordinate(dof); });
  view_->set_joint(joint_);
  Q_EMIT edit_wanted("joint", "dofs", written(joint_));
}

void GeometryPage::set_frequency(double frequency_hz) { frequency_->setValue(frequency_hz); }

void GeometryPage::read_deflection() {
  const std::size_t number = ++*wanted_;
  if (!play_->isChecked() || files_ == nullptr || reference_->count() == 0) {
    deflection_ = {};
    return show_deflection();
  }
  const frf::Dof reference = frf::Dof::parse(reference_->currentText().toStdString());
  const double f = frequency_->value();
  worker_->add([this, number, wanted = wanted_, files = files_, reference, f](const Worker::Watch&) -> Worker::Deliver {
    if (number != *wanted) return {};
    return [this, number, found = deflection_at(*files, reference, f)] {
      if (number != *wanted_) return;
      deflection_ = found;
      show_deflection();
      status_->setText(tr("The assembly under a force at %1, at its line %2 Hz.")
                           .arg(reference_->currentText())
                           .arg(deflection_.frequency_hz));
    };
  });
}

void GeometryPage::show_deflection() { view_->set_shape(deflection_.shape, percent * amplitude_->value()); }

/// A turn takes from half a second to five.
void GeometryPage::next_picture() {
  const double turns_per_second = 0.02 * speed_->value() + 0.2;
  phase_ = std::fmod(phase_ + 2.0 * std::numbers::pi * turns_per_second * picture_ms / 1000.0, 2.0 * std::numbers::pi);
  view_->set_phase(phase_);
}

}  // namespace jointid::gui
