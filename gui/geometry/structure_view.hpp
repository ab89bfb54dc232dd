#pragma once

#include <QWidget>
#include <optional>

#include "gui/geometry/camera.hpp"
#include "gui/geometry/drawn_springs.hpp"
#include "gui/geometry/line_pen.hpp"

class QPainter;

namespace jointid::gui {

/// A structure in space: nodes, lines, an arrow for every measured DOF, those of the joint in another colour, and how it
/// deflects. Drag or arrow keys turn it, the wheel or + and − zoom, Home or a double click show all; a click chooses a DOF, or a
/// node while lines are drawn. By QPainter.
class StructureView : public QWidget {
  Q_OBJECT

 public:
  explicit StructureView(QWidget* parent = nullptr);

  void set_structure(Structure structure);
  const Structure& structure() const { return structure_; }
  void set_joint(std::vector<frf::Dof> joint);
  /// The DOF that the list or a click has in front.
  void set_current(const std::optional<frf::Dof>& dof);
  /// `amplitude`: of the node that moves most, in parts of the structure's size.
  void set_shape(Shape shape, double amplitude);
  /// Of the motion Re(shape e^iφ).
  void set_phase(double phase_rad);
  void set_undeformed(bool on);
  void set_names(bool on);
  /// Springs of the joint as a solution found them: loose ones red, with their share of the others.
  void set_springs(std::vector<DrawnSpring> springs);
  const std::vector<DrawnSpring>& springs() const { return springs_; }
  /// Lines drawn by hand, beside those of the files; nodes that are not there are left out of the picture.
  void set_own_lines(std::vector<frf::NodeLine> lines);
  const std::vector<frf::NodeLine>& own_lines() const { return pen_.own(); }
  /// While it is on, clicks and keys pick the two nodes of a line.
  void set_drawing(bool on);
  const LinePen& pen() const { return pen_; }
  /// Looks along an axis, or from above one side.
  void look(Camera::Side side);

  /// As it stands, PNG, SVG or PDF.
  QByteArray picture(const QString& ending) const;
  /// One period of the motion, as it stands, as a GIF.
  QByteArray film();
  bool moves() const { return !shape_.empty(); }
  /// Nodes with their positions in m and, where they move, the complex displacement of the shape.
  std::string table(char separator) const;

  /// Where the numbers of nodes are drawn, none over another: those of the joint are all there, others where there is room.
  std::vector<std::pair<std::int64_t, QRectF>> name_places() const;
  /// Of the part that a node belongs to, where there are several.
  QColor part_colour(const frf::Node& node) const;
  /// Where the tip of the arrow of a DOF is drawn.
  QPointF tip_of(const frf::Dof& dof) const;
  /// Where a node is drawn.
  QPointF place_of(std::int64_t node) const;
  QSize sizeHint() const override { return {500, 400}; }

 Q_SIGNALS:
  void dof_clicked(const jointid::frf::Dof& dof);
  void pen_wanted();         ///< or no longer
  void drawing_changed();    ///< what the pen has picked or chosen
  void own_lines_changed();  ///< one more by hand, or one less

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  Vector moved(const frf::Node& node) const;
  Vector drawn_position(std::int64_t node) const;
  void turn(double azimuth, double elevation);
  void zoom(double factor);
  void show_all();
  void paint(QPainter& painter) const;
  void draw_lines(QPainter& painter, bool deflected) const;
  void draw_nodes(QPainter& painter) const;
  void draw_springs(QPainter& painter) const;
  void draw_scale(QPainter& painter) const;
  double share_of(const frf::Node& node) const;
  void draw_arrows(QPainter& painter) const;
  void draw_axes(QPainter& painter) const;
  std::optional<frf::Dof> dof_at(const QPointF& at) const;
  std::optional<std::int64_t> node_at(const QPointF& at) const;
  std::vector<frf::NodeLine> drawn_own_lines() const;
  std::vector<frf::NodeLine> all_lines() const;
  std::optional<frf::NodeLine> own_line_at(const QPointF& at) const;
  void draw_pen(QPainter& painter) const;
  bool is_drawn(const frf::NodeLine& line) const { return place_.contains(line[0]) && place_.contains(line[1]); }
  void pick(std::int64_t node);
  void click_with_pen(const QPointF& at);
  bool draw_by_key(int key);

  Structure structure_;
  Camera camera_;
  std::map<std::int64_t, std::size_t> place_;  ///< of a node among the nodes
  std::vector<frf::Dof> joint_;
  std::optional<frf::Dof> current_;
  Shape shape_;
  double scale_ = 0.0;  ///< m of picture for a unit of the shape
  double phase_ = 0.0;
  bool undeformed_ = true, names_ = true;
  double largest_ = 0.0;  ///< motion of a node in the shape
  std::vector<DrawnSpring> springs_;
  LinePen pen_;
  bool drawing_ = false;
  QPointF pressed_, last_;
  bool turned_ = false;
};

}  // namespace jointid::gui
