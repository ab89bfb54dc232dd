#pragma once

namespace jointid::ident {

/// A scene that uses every section.
inline constexpr const char* full_scene = R"(
title = "two beams and a soft joint"
[data]
substructures = ["beam_long.uff", "beam_short.h5"]
assembly      = ["assembly.h5"]
reciprocity   = true
[data.files."beam_long.uff"]
quantity = "accelerance"
dofs = ["1:+Y", "4:+Y"]
reference_dofs = ["4:+Y"]
[data.files."assembly.h5"]
variable = "H"
[frequency]
range   = [400.0, 1000.0]
step    = 20
exclude = [[560.0, 566.0]]
exclude_resonances = { of = ["substructures"], half_width = 0.02 }
[joint]
dofs = ["4:+Y", "4:+RZ", "5:+Y", "5:-RZ"]
bands = [[400, 600], [600, 1000]]
[joint.stiffness]
pattern = "symmetric"
[joint.hysteretic_damping]
matrix = [["a","b","-a","b"], ["b","c","-b","d"], ["-a","-b","a",-1.5], ["b","d",-2,"c"]]
[joint.mass]
springs = [["4:+Y","5:+Y"], ["ground", "4:+RZ"]]
[nodes]
4 = [0, 0, 0.0]
"5" = [0.3, 0, 0]
"9" = [1, 2, 3]
[identify]
method    = "likelihood"
equations = ["nn", "jn"]
weighting = "WBS"
delta     = 0.05
solver    = "ceres"
start     = { stiffness = [[1,0,0,0],[0,2,0,0],[0,0,3,0],[0,0,0,4]] }
[noise]
model = "modal"
level = 0.05
[truth]
viscous_damping = [[1,2,3,4],[0,0,0,0],[0,0,0,0],[0,0,0,5]]
)";

}  // namespace jointid::ident
