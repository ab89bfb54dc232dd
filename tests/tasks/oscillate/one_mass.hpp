#pragma once

#include <string>

namespace jointid::tasks {

/// One mass on a belt with Coulomb friction, whose motion is known in closed form.
inline const std::string one_mass = R"(
[system]
kind = "belt_chain"
masses = 1
mass = 1.3
stiffness = 2.1
velocity = 0.2

[friction]
kinetic = 0.3
static = 0.5
normal = 1.7

[start]
velocity = [0.2]

[motion]
transient = 5.0
length = 53.0433253402657
step = 0.01
)";

}  // namespace jointid::tasks
