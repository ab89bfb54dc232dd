#pragma once

#include <optional>
#include <vector>

#include "friction/joint/distributed_slip.hpp"
#include "friction/path/masing_path.hpp"
#include "response/time/jointed_structure.hpp"
#include "response/time/normal_load.hpp"

namespace jointid::response {

/// The force of a joint from step to step: along a Masing path, of sliders under a changing normal load (algorithm A), or of a
/// spring, which has no memory.
class JointPath {
 public:
  /// `element` must outlive it. Throws InputError for a spring under a normal load.
  explicit JointPath(const friction::Element& element, NormalLoad load = {});

  /// The time at the end of the step that follows: its normal load counts.
  void set_time(double time);

  /// At q, reached without turning; the joint stays where it is.
  friction::Response response(double q) const;
  /// The same, and goes there.
  friction::Response advance(double q);

 private:
  friction::MasingPath path_;
  bool spring_;
  NormalLoad load_;
  double share_ = 1.0;  ///< of the normal load
  std::optional<friction::DistributedSlip> sliders_;
};

/// Of every joint; `loads`: one for each, or none at all. Throws InputError for another number of them.
std::vector<JointPath> joint_paths(const JointedStructure& structure, const std::vector<NormalLoad>& loads);

}  // namespace jointid::response
