#include "tasks/equivalent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/control.hpp"
#include "base/error.hpp"
#include "base/statistics.hpp"
#include "frf/set/frf_system.hpp"
#include "ident/plan/data_source.hpp"
#include "models/model_file.hpp"
#include "weighting/line_selection.hpp"

namespace jointid::tasks {
namespace {

/// FRFs of a system at chosen DOFs over its lines, [line, row, column].
struct Measured {
  std::vector<double> frequency_hz;
  std::size_t entries = 0;
  std::vector<Complex> values;

  Complex at(std::size_t line, std::size_t entry) const { return values[line * entries + entry]; }
};

Measured read(const std::string& name, ident::Sources files, frf::Composition composition, bool reciprocity,
              const std::vector<frf::Dof>& rows, const std::vector<frf::Dof>& columns,
              const weighting::LineSelection& selection) {
  frf::FrfSystem system(name, std::move(files), composition, reciprocity);
  const std::vector<std::size_t> lines = weighting::select_lines(system.frequency_hz(), selection);
  Measured out;
  out.entries = rows.size() * columns.size();
  out.values.resize(lines.size() * out.entries);
  for (const std::size_t line : lines) out.frequency_hz.push_back(system.frequency_hz()[line]);
  if (!lines.empty()) frf::BlockReader(system, rows, columns).read(lines, out.values);
  return out;
}

/// The parts; models at the lines of the first level where no part is measured.
ident::Sources open_parts(const ident::EquivalentScene& scene) {
  const bool measured =
      std::ranges::any_of(scene.parts, [](const ident::DataFile& part) { return !models::is_model_file(part.path); });
  std::vector<std::vector<ident::DataFile>> systems = {scene.parts};
  if (!measured) systems.push_back({scene.levels.front().assembly});
  return std::move(open_systems(systems, scene.frequency, scene.file).front());
}

bool finite(Complex value) { return std::isfinite(value.real()) && std::isfinite(value.imag()); }

/// The measurements of a scene that all levels share.
class Levels {
 public:
  explicit Levels(const ident::EquivalentScene& scene)
      : scene_(scene),
        selection_{
            .range_hz = scene.frequency.range_hz, .step_hz = scene.frequency.step_hz, .exclude_hz = scene.frequency.exclude_hz},
        ends_(scene.dofs.begin(), scene.dofs.end()),
        parts_(
            read("substructures", open_parts(scene), frf::Composition::uncoupled, scene.reciprocity, ends_, ends_, selection_)) {
    if (scene.rigid) rigid_ = assembly(*scene.rigid);
  }

  LevelJoint find(const ident::DisplacementLevel& level) const {
    LevelJoint out{.file = level.assembly.path.string(), .displacement = level.displacement};
    const JointLines lines = lines_of(assembly(level.assembly));
    if (lines.a.empty()) fail(level);
    out.lines = lines.a.size();
    out.joint = equivalent_joint(lines);
    return out;
  }

 private:
  Measured assembly(const ident::DataFile& file) const {
    return read("assembly", ident::open_all({file}), frf::Composition::merged, false, ends_, {ends_.front()}, selection_);
  }

  [[noreturn]] void fail(const ident::DisplacementLevel& level) const {
    throw InputError(
        {.kind = ErrorKind::data,
         .file = level.assembly.path.string(),
         .place = "FRFs of " + ends_[0].name() + " and " + ends_[1].name(),
         .problem = "no line of the range has them together with those of the parts" +
                    std::string(rigid_ ? " and of the rigid joint" : ""),
         .remedy = "both responses to " + ends_[0].name() + " are needed; `jointid info` prints what the file holds"});
  }

  /// Lines on which all that is needed was measured.
  JointLines lines_of(const Measured& level) const {
    JointLines out;
    out.relative = scene_.relative;
    std::vector<Complex> h1_rigid, h3_rigid;
    const std::vector<std::size_t> at = frf::match_lines(parts_.frequency_hz, level.frequency_hz);
    const std::vector<std::size_t> at_rigid = rigid_ ? frf::match_lines(parts_.frequency_hz, rigid_->frequency_hz) : at;
    for (std::size_t line = 0; line < at.size(); ++line) {
      if (at[line] == frf::npos || at_rigid[line] == frf::npos) continue;
      std::array<Complex, 5> all = {parts_.at(line, 0), parts_.at(line, 3), parts_.at(line, 1), level.at(at[line], 0),
                                    level.at(at[line], 1)};
      if (!std::ranges::all_of(all, finite)) continue;
      if (rigid_) {
        const Complex h1 = rigid_->at(at_rigid[line], 0), h3 = rigid_->at(at_rigid[line], 1);
        if (!finite(h1) || !finite(h3)) continue;
        h1_rigid.push_back(h1);
        h3_rigid.push_back(h3);
      }
      if (scene_.real) std::ranges::transform(all.begin(), all.begin() + 3, all.begin(), real_frf);
      out.a.push_back(all[0]);
      out.b.push_back(all[1]);
      out.c.push_back(all[2]);
      out.h1.push_back(all[3]);
      out.h3.push_back(all[4]);
    }
    out.gap = rigid_ ? rigid_gap(out, h1_rigid, h3_rigid) : difference_gap(out);
    return out;
  }

  const ident::EquivalentScene& scene_;
  weighting::LineSelection selection_;
  std::vector<frf::Dof> ends_;
  Measured parts_;
  std::optional<Measured> rigid_;
};

/// No spring or damper beyond the 95 % interval, or a stiffness whose error is larger than itself.
bool is_impossible(const EquivalentJoint& joint) {
  return joint.stiffness < 0.0 || joint.damping < -normal_95 * joint.deviation || joint.deviation > std::abs(joint.stiffness);
}

}  // namespace

std::vector<LevelJoint> find_equivalent(const ident::EquivalentScene& scene, const ident::Control& control) {
  if (control.progress) control.progress("reading and fitting", 0, 0);
  const Levels levels(scene);
  std::vector<LevelJoint> out;
  for (const ident::DisplacementLevel& level : scene.levels) {
    stop_if(control.interrupted);
    out.push_back(levels.find(level));
  }
  return out;
}

std::string equivalent_status(const std::vector<LevelJoint>& levels) {
  if (!all_settled(levels)) return "not_usable";
  return equivalent_doubt(levels).empty() ? "ok" : "doubtful";
}

std::string equivalent_doubt(const std::vector<LevelJoint>& levels) {
  const auto count = [&](const auto& is) {
    return static_cast<std::size_t>(
        std::ranges::count_if(levels, [&](const LevelJoint& level) { return is(level.joint); }));
  };
  const std::size_t impossible = count(is_impossible);
  if (impossible > 0) {
    return fmt::format(
        "at {} of {} levels no spring and damper: negative beyond the error, or a stiffness whose error is larger than itself; "
        "the errors of the FRFs outweigh the joint",
        impossible, levels.size());
  }
  const std::size_t unknown =
      count([](const EquivalentJoint& joint) { return joint.deviation > std::abs(joint.damping); });
  return 2 * unknown <= levels.size()
             ? ""
             : fmt::format("the damping is not known: its error is larger than itself at {} of {} levels", unknown,
                           levels.size());
}

bool all_settled(const std::vector<LevelJoint>& levels) {
  return std::ranges::all_of(levels, [](const LevelJoint& level) { return level.joint.settled; });
}

}  // namespace jointid::tasks
