#include "gui/geometry/geometry_page.hpp"

#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include "gui/geometry/motion_bar.hpp"
#include "gui/geometry/structure_view.hpp"
#include "gui/look/buttons.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/named.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "gui/plot/picture.hpp"
#include "gui/scene/scene_edit.hpp"
#include "gui/work/worker.hpp"
#include "ident/scene/scene_files.hpp"
#include "tasks/correlate/compared_files.hpp"

namespace jointid::gui {
namespace {

constexpr int dof_role = Qt::UserRole;

std::vector<frf::Dof> references_of(const std::vector<LoadedFile>& files) {
  std::vector<frf::Dof> out;
  for (const LoadedFile& file : files) {
    if (!shows_motion(file, files)) continue;
    for (const frf::Dof& dof : file.header.reference) {
      if (!frf::has(out, dof)) out.push_back(dof);
    }
  }
  return out;
}

Saveable saveable(StructureView& view) {
  return {[&view](const QString& ending) { return ending == QLatin1String("gif") ? view.film() : view.picture(ending); },
          [&view](char separator) { return view.table(separator); }, view.moves()};
}

}  // namespace

GeometryPage::GeometryPage(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Geometry"));
  worker_ = new Worker(this);
  view_ = new StructureView;
  motion_ = new MotionBar;
  list_ = named(new QListWidget, "dofs", tr("Measured DOFs. Ticked: joint DOFs"),
                tr("Space adds a DOF to [joint] dofs, or removes it"));
  list_->setMinimumWidth(200);
  status_ = named(new QLabel, "geometry_status", tr("About the structure"));
  status_->setWordWrap(true);
  status_->setTextFormat(Qt::PlainText);
  auto* both = named(new QSplitter(Qt::Horizontal), "dofs_and_structure", tr("DOFs and structure"));
  both->addWidget(list_);
  both->addWidget(view_);
  both->setStretchFactor(1, 1);
  both->setSizes({200, 530});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  all->addWidget(motion_);
  all->addWidget(both, 1);
  all->addLayout(make_foot());
  connect_motion();
  connect(list_, &QListWidget::itemChanged, this, &GeometryPage::item_changed);
  connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item != nullptr) view_->set_current(frf::Dof::parse(item->data(dof_role).toString().toStdString()));
  });
  connect(view_, &StructureView::dof_clicked, this, &GeometryPage::toggle);
  connect(worker_, &Worker::failed, this, [this](const InputError& error) { status_->setText(QString::fromUtf8(error.what())); });
}

QLayout* GeometryPage::make_foot() {
  auto* front = push_button("geometry_front", tr("Front"), tr("Look along y: x to the right, z up (F)"));
  auto* side = push_button("geometry_side", tr("Side"), tr("Look along x: y to the right, z up (S)"));
  auto* top = push_button("geometry_top", tr("Top"), tr("Look down: x to the right, y up (T)"));
  pen_ = make_pen();
  auto* copy = push_button("geometry_copy", tr("Copy"), tr("Copy the nodes for a spreadsheet, and the picture"));
  auto* save = push_button("geometry_save", tr("Save…"), tr("Save as PNG, SVG, PDF or CSV; a motion as a film (GIF), too"));
  auto* rows = new QVBoxLayout;
  rows->addWidget(status_);
  rows->addLayout(row_of({front, side, top, pen_}, {copy, save}));
  connect(front, &QPushButton::clicked, this, [this] { view_->look(Camera::Side::front); });
  connect(side, &QPushButton::clicked, this, [this] { view_->look(Camera::Side::side); });
  connect(top, &QPushButton::clicked, this, [this] { view_->look(Camera::Side::top); });
  connect(copy, &QPushButton::clicked, this, [this] { copy_plot(saveable(*view_)); });
  connect(save, &QPushButton::clicked, this,
          [this] { ask_and_save(this, saveable(*view_), inputs_, QStringLiteral("geometry.png")); });
  return rows;
}

/// Lines between nodes, by hand; they are kept in the scene.
QPushButton* GeometryPage::make_pen() {
  auto* pen = push_button("geometry_lines", tr("Lines"), tr("Draw lines between nodes, or remove them (L)"));
  pen->setCheckable(true);
  connect(pen, &QPushButton::toggled, this, [this](bool on) {
    view_->set_drawing(on);
    if (on)
      view_->setFocus();
    else
      say_structure();
  });
  connect(view_, &StructureView::pen_wanted, pen, &QPushButton::toggle);
  connect(view_, &StructureView::drawing_changed, this, [this, pen] {
    if (pen->isChecked()) status_->setText(view_->pen().text());
  });
  connect(view_, &StructureView::own_lines_changed, this, [this] {
    const auto& lines = view_->own_lines();
    Q_EMIT edit_wanted("geometry", "lines", lines.empty() ? std::string() : written(lines));
  });
  return pen;
}

void GeometryPage::set_own_lines(std::vector<frf::NodeLine> lines) { view_->set_own_lines(std::move(lines)); }

void GeometryPage::save(const QString& file) const { save_plot(file, saveable(*view_), inputs_); }

void GeometryPage::connect_motion() {
  connect(motion_, &MotionBar::motion_changed, this, &GeometryPage::read_deflection);
  connect(motion_, &MotionBar::look_changed, this, &GeometryPage::show_deflection);
  connect(motion_, &MotionBar::phase_changed, view_, &StructureView::set_phase);
  connect(motion_, &MotionBar::undeformed_wanted, view_, &StructureView::set_undeformed);
  connect(motion_, &MotionBar::numbers_wanted, view_, &StructureView::set_names);
  connect(motion_, &MotionBar::shapes_wanted, this, [this] {
    for (const QString& file : choose_modes_to_open(this)) open_shapes(file);
  });
}

bool GeometryPage::is_busy() const { return worker_->is_busy(); }

QString GeometryPage::status() const { return status_->text(); }

void GeometryPage::set_scene(const ident::Scene& scene, const std::string& signature) {
  joint_.clear();
  for (const auto& each : scene.joints) joint_.insert(joint_.end(), each.dofs.begin(), each.dofs.end());
  data_ = scene.data;
  inputs_.clear();
  for (const auto& file : ident::files_of(scene)) inputs_.push_back(file.path);
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
  motion_->set_references(references_of(*files_));
  say_structure();
  show_joint();
  read_deflection();
}

void GeometryPage::say_structure() {
  const Structure& structure = view_->structure();
  const QString springs = springs_text(view_->springs());
  status_->setText((springs.isEmpty() ? QString() : springs + QLatin1Char('\n')) +
                   tr("%1 nodes, %2 lines, %3 DOFs. Click an arrow, or tick a DOF, to add it to the joint or remove it.")
                       .arg(structure.nodes.size())
                       .arg(structure.lines.size() + view_->own_lines().size())
                       .arg(structure.dofs.size() + structure.unplaced.size()));
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

void GeometryPage::set_frequency(double frequency_hz) { motion_->set_frequency(frequency_hz); }

void GeometryPage::set_modes(std::vector<NamedShape> shapes) {
  fitted_ = std::move(shapes);
  offer_modes();
}

void GeometryPage::set_springs(const std::vector<tasks::JointSpring>& springs) {
  view_->set_springs(drawn_springs(springs));
  if (const QString text = springs_text(view_->springs()); !text.isEmpty()) status_->setText(text);
}

void GeometryPage::open_shapes(const QString& file) {
  worker_->add([this, file](const Worker::Watch&) -> Worker::Deliver {
    return [this, shapes = named_shapes(tasks::read_modes(as_path(file)).modes, QFileInfo(file).fileName())] {
      const std::size_t first = fitted_.size() + of_files_.size();
      of_files_.insert(of_files_.end(), shapes.begin(), shapes.end());
      offer_modes();
      motion_->choose_mode(first);
    };
  });
}

void GeometryPage::offer_modes() {
  QStringList names;
  for (const auto* list : {&fitted_, &of_files_}) {
    for (const NamedShape& each : *list) names << each.name;
  }
  motion_->set_modes(names);
}

const NamedShape& GeometryPage::chosen_mode() const {
  const std::size_t mode = *motion_->mode();
  return mode < fitted_.size() ? fitted_[mode] : of_files_[mode - fitted_.size()];
}

void GeometryPage::read_deflection() {
  const std::size_t number = ++*wanted_;
  deflection_ = {};
  if (motion_->moves() && motion_->mode()) {
    deflection_.shape = chosen_mode().shape;
    return show_deflection();
  }
  const auto reference = motion_->reference();
  if (!motion_->moves() || files_ == nullptr || !reference) return show_deflection();
  const double f = motion_->frequency_hz();
  worker_->add([this, number, wanted = wanted_, files = files_, reference, f](const Worker::Watch&) -> Worker::Deliver {
    if (number != *wanted) return {};
    return [this, number, found = deflection_at(*files, *reference, f)] {
      if (number != *wanted_) return;
      deflection_ = found;
      show_deflection();
    };
  });
}

void GeometryPage::show_deflection() {
  const Shape& shape = deflection_.shape;
  const Shape global = in_global_axes(shape, view_->structure().nodes);
  view_->set_shape(motion_->is_of_joint() ? joint_deflection(global, joint_) : global, motion_->amplitude());
  if (shape.empty()) return;
  const QString what = motion_->mode() ? tr("Mode %1.").arg(chosen_mode().name)
                                       : tr("The assembly under a force at %1, at its line %2 Hz.")
                                             .arg(q(motion_->reference()->name()))
                                             .arg(deflection_.frequency_hz);
  const QString joint = joint_motion_text(shape, joint_);
  status_->setText(joint.isEmpty() ? what : what + tr("\nJoint: %1").arg(joint));
}

}  // namespace jointid::gui
