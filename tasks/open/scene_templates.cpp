#include "tasks/open/scene_templates.hpp"

namespace jointid::tasks {
namespace {

constexpr std::string_view joint = R"(# Two substructures and the assembly that a joint makes of them.
# Paths are relative to this file.
[data]
substructures = ["part_1.uff", "part_2.uff"]
assembly = ["assembly.uff"]

# Joint DOFs on both sides, as the files name them.
[joint]
dofs = ["1:+Z", "2:+Z"]

# Unknown: a spring with hysteretic damping between the two.
[joint.stiffness]
springs = [["1:+Z", "2:+Z"]]

[joint.hysteretic_damping]
springs = [["1:+Z", "2:+Z"]]
)";

constexpr std::string_view coupling = R"(# FRFs of an assembly, predicted from those of its substructures.
# Paths are relative to this file.
[data]
parts = ["part_1.uff", "part_2.uff"]

# The DOFs of each list move as one.
[couple]
join = [["1:+Z", "2:+Z"]]
)";

constexpr std::string_view decoupling = R"(# FRFs of a substructure, from those of the assembly and of the rest.
# Paths are relative to this file.
[data]
parts = ["assembly.uff", "fixture.uff"]

# The interface: the DOFs of the rest and those of the assembly there.
# More pairs inside the rest make an extended interface.
[couple]
join = [["1:+Z", "11:+Z"]]
remove = ["fixture.uff"]
)";

constexpr std::string_view virtual_points = R"(# An isolator between two plates. On either side three sensors and
# impacts around it become one virtual point with six DOFs.
# Paths are relative to this file; the files have the nodes' positions.
[data]
substructures = ["part_1.uff", "part_2.uff"]
assembly = ["assembly.uff"]

[[virtual_points]]
name = "VP1"
position = [0.0, 0.0, 0.0]  # m
sensors = ["11:+X", "11:+Y", "11:+Z", "12:+X", "12:+Y", "12:+Z", "13:+X", "13:+Y", "13:+Z"]
impacts = ["11:+X", "11:+Y", "11:+Z", "12:+X", "12:+Y", "12:+Z", "13:+X", "13:+Y", "13:+Z"]

[[virtual_points]]
name = "VP2"
position = [0.0, 0.0, 0.03]  # m
sensors = ["21:+X", "21:+Y", "21:+Z", "22:+X", "22:+Y", "22:+Z", "23:+X", "23:+Y", "23:+Z"]
impacts = ["21:+X", "21:+Y", "21:+Z", "22:+X", "22:+Y", "22:+Z", "23:+X", "23:+Y", "23:+Z"]

[joint]
dofs = [
  "VP1:+X", "VP1:+Y", "VP1:+Z", "VP1:+RX", "VP1:+RY", "VP1:+RZ",
  "VP2:+X", "VP2:+Y", "VP2:+Z", "VP2:+RX", "VP2:+RY", "VP2:+RZ",
]

# Unknown: a spring with hysteretic damping for every motion.
[joint.stiffness]
springs = [
  ["VP1:+X", "VP2:+X"], ["VP1:+Y", "VP2:+Y"], ["VP1:+Z", "VP2:+Z"],
  ["VP1:+RX", "VP2:+RX"], ["VP1:+RY", "VP2:+RY"], ["VP1:+RZ", "VP2:+RZ"],
]

[joint.hysteretic_damping]
springs = [
  ["VP1:+X", "VP2:+X"], ["VP1:+Y", "VP2:+Y"], ["VP1:+Z", "VP2:+Z"],
  ["VP1:+RX", "VP2:+RX"], ["VP1:+RY", "VP2:+RY"], ["VP1:+RZ", "VP2:+RZ"],
]
)";

constexpr std::string_view friction = R"(# The friction law of a joint, from responses at several force levels.
# Paths are relative to this file.
[data]
parts = ["part_1.uff", "part_2.uff"]  # FRFs of the uncoupled parts

# One table for each force level: phasors of the responses and of the force.
[[data.levels]]
name = "1 N"
responses = "level_1.uff"
amplitude = 1.0  # N, of the force
force_dofs = ["5:+Z"]

[[data.levels]]
name = "10 N"
responses = "level_10.uff"
amplitude = 10.0
force_dofs = ["5:+Z"]

[[joint.friction]]
name = "joint"
dofs = ["1:+Z", "2:+Z"]  # slip is the first less the second
law = ["bilinear", "iwan", "ren"]  # one of them
)";

}  // namespace

const std::vector<SceneTemplate>& scene_templates() {
  static const std::vector<SceneTemplate> all = {{"joint", joint},
                                                 {"coupling", coupling},
                                                 {"decoupling", decoupling},
                                                 {"virtual-points", virtual_points},
                                                 {"friction", friction}};
  return all;
}

}  // namespace jointid::tasks
