"""The kinds of scenes, and the least that the reader wants to see of each table before it names the keys of another."""

from dataclasses import dataclass, field

Lines = dict[str, str]


@dataclass
class SceneTable:
    """`path` with dots; `several`: [[path]]. `variants`: lines that make other keys valid, by a word for each."""

    path: str
    lines: Lines = field(default_factory=dict)
    several: bool = False
    always: bool = False
    variants: dict[str, Lines] = field(default_factory=dict)
    #: Tables that have to go when this one is asked.
    without: tuple[str, ...] = ()
    name: str = ""
    #: Lines beside which the reader looks at the value of keys that need others.
    companions: tuple[Lines, ...] = ()
    #: What keys take of whose value the reader says nothing beside any lines, as what it needs before is a file or another table.
    stated: dict[str, str] = field(default_factory=dict)

    @property
    def header(self) -> str:
        return f"[[{self.path}]]" if self.several else f"[{self.path}]"

    @property
    def title(self) -> str:
        return self.name or (self.header if self.path else "at the top")


@dataclass
class Kind:
    """A kind of scene: the command that reads it, the pages that describe it."""

    word: str
    title: str
    command: list[str]
    pages: list[str]
    tables: list[SceneTable]


T = SceneTable
PARTS = {"parts": '["a", "b"]'}
PAIR = '["1:+X", "2:+X"]'
FILE_KEYS = T("data.files.a", name='`[data.files."NAME"]`')
MATRICES = [T(f"joint.{kind}", {"pattern": '"full"'}) for kind in ("mass", "viscous_damping", "hysteretic_damping")]
IDENTIFY = T("identify", companions=({"bootstrap": "200"},))
IDENTIFY_LINES = T("identify", companions=IDENTIFY.companions, stated={"start": "not here: no joint of matrices"})

SOLVE = Kind("solve", "Scenes of `solve`, `plan`, `check`, `study`, `compare`", ["plan"], ["scene", "gains", "virtual-points"], [
    T("", {}),
    T("data", {"substructures": '["a", "b"]', "assembly": '["c"]'}, always=True),
    FILE_KEYS,
    T("data.gains", {"gain": "0.01"}, several=True),
    T("data.masses", {"dofs": '["1:+X"]', "files": '["a"]', "mass": "0.003"}, several=True),
    T("frequency"),
    T("frequency.exclude_resonances", {"of": '["assembly"]', "half_width": "0.01"}),
    T("joint", {"dofs": PAIR}, always=True),
    T("joints", {"name": '"x"', "dofs": PAIR, "stiffness": '{ pattern = "full" }'}, several=True, without=("joint", "joint.stiffness")),
    T("joint.stiffness", {"pattern": '"full"'}, always=True),
    *MATRICES,
    IDENTIFY,
    T("identify.start", stated=dict.fromkeys(("stiffness", "mass", "viscous_damping", "hysteretic_damping"),
                                             "a number, list of numbers, matrix, or a table of unknowns")),
    T("noise", {"model": '"gaussian"', "level": "0.01"}, companions=({"model": '"hammer"', "averages": "10"},),
      variants={"hammer": {"model": '"hammer"'}, "modal": {"model": '"modal"', "level": "0.01"}}),
    T("noise.gross", {"share": "0.01", "factor": "10"}),
    T("geometry"),
    T("truth"),
    T("virtual_points", {"name": '"VP1"', "position": "[0, 0, 0]", "plane": '"XY"', "sensors": '["7:+X", "7:+Y", "8:+Y"]'}, several=True),
])

COUPLE = Kind("couple", "Scenes of `couple`", ["couple", "--out", "x.h5"], ["scene", "coupling", "virtual-points"], [
    T("", stated={"nodes": "a table"}),
    T("data", PARTS, always=True),
    T("frequency"),
    T("couple", {"join": f"[{PAIR}]"}, always=True,
      companions=({"join": f"[{PAIR}]", "threshold": '"fixed"'}, {"join": f"[{PAIR}]", "method": '"mtc"', "threshold": '"alpha"'})),
    T("couple.joint", {"dofs": PAIR, "stiffness": "{ matrix = [[1, -1], [-1, 1]] }"}, several=True,
      variants={"identified": {"identified": '"x.toml"'}}),
    T("geometry"),
    T("couple.joint.stiffness", name="`stiffness` and other matrices of `[[couple.joint]]`"),
])

LINES = Kind("lines", "Scenes of `solve` with the joint at every line", ["solve"], ["joint-line-by-line", "scene", "gains"], [
    T("", stated={"nodes": "a table", "joints": "not here: one joint"}),
    T("data", {"substructures": '["a", "b"]', "assembly": '["c"]'}, always=True),
    T("data.gains", {"gain": "0.01"}, several=True),
    T("frequency"),
    T("joint", {"dofs": PAIR, "lines": '"massless"'}, always=True,
      companions=tuple({"dofs": PAIR, "lines": '"massless"', **more} for more in ({"laws": '"all"'}, {"smooth": '"marginal"'}))),
    T("geometry"),
    T("joint.lines", {"matrix": '[["a", "-a"], ["-a", "a"]]'}),
    IDENTIFY_LINES,
])

DECOUPLE = Kind("decouple", "Scenes of `decouple`", ["decouple", "--out", "x.h5"], ["joint-line-by-line", "scene", "gains"], [
    T("", stated={"nodes": "a table"}),
    T("data", {"substructures": '["a"]', "assembly": '["c"]'}, always=True),
    T("data.gains", {"gain": "0.01"}, several=True),
    T("frequency"),
    T("geometry"),
    T("decouple", {"interface": PAIR}, always=True),
    IDENTIFY_LINES,
])

EQUIVALENT = Kind("equivalent", "Scenes of `equivalent`", ["equivalent"], ["scene", "loading-curves"], [
    T("", {}),
    T("data", PARTS, always=True),
    T("frequency"),
    T("equivalent", {"dofs": PAIR, "levels": '[{ assembly = "c", displacement = 1e-6 }]'}, always=True),
    T("equivalent.levels", {"assembly": '"c"', "displacement": "1e-6"}, several=True),
])

MODEL = {"mass": "[[1, 0], [0, 1]]", "stiffness": "[[2, -1], [-1, 2]]"}
SPRING = '{ dofs = [1, 2], stiffness = 1.0 }'
ANY_LAW = {"law": '"spring"', "parameters": "[1.0]"}
RESPONSE = Kind("response", "Scenes of `response`", ["response"], ["response"], [
    T("", {"joints": f"[{SPRING}]"}, always=True),
    T("data", PARTS, without=("structure",)),
    T("structure", MODEL, always=True),
    T("joints", {"dofs": "[1, 2]", "stiffness": "1.0"}, several=True, companions=({"dofs": "[1, 2]", **ANY_LAW},)),
    T("joints.parts", ANY_LAW, several=True, name="`parts` of `[[joints]]`", companions=({"law": '"series"'},)),
    T("joints.parameters", name="`parameters` of the law `generalised`", companions=({"slip": "[[1.0, 1.0]]"},)),
    T("force", {"dof": "1", "amplitudes": "[1.0]"}, always=True),
    T("frequency", {"range": "[1, 2]"}, always=True),
    T("response", {"dofs": "[1]"}, always=True),
    T("curves", {"along": '"force"', "range": "[1, 2]", "frequency": "1.5"}, several=True,
      companions=({"along": '"stiffness"', "range": "[1, 2]", "frequency": "1.5", "joint": "1"},)),
    T("clamping", {"range": "[0.1, 10]"}, companions=({"range": "[0.1, 10]", "joints": "[1]"},)),
    T("equivalent", {"amplitudes": "[1e-6]"}),
    T("transient", {"duration": "1.0", "method": '"one"', "delta": "0.001"},
      companions=({"duration": "1.0", "method": '"two"', "delta": "0.001"},)),
    T("transient.forces", {"dof": "1", "file": '"x.csv"', "column": '"x"'}, several=True),
    T("transient.normal", {"joint": "1", "load": "[[0, 1.0], [1, 2.0]]", "nominal": "1.0"}, several=True,
      stated={"load": "list of lists", "nominal": "a number", "period": "a number", "sliders": "a number"}),
    T("transient.pulses", {"dof": "1", "amplitude": "1.0", "length": "0.1"}, several=True),
])

LAWS = Kind("laws", "Scenes of friction laws from vibration: `solve`, `plan`, `study`", ["plan"], ["friction-from-vibration", "scene"], [
    T("", {}),
    T("data", PARTS, always=True),
    T("data.levels", {"responses": '"c"', "amplitude": "1.0", "force_dofs": '["1:+X"]'}, several=True, always=True,
      companions=tuple({of: '["c"]', "force_dofs": '["1:+X"]', **more}
                       for of, more in (("responses", {}), ("records", {}), ("records", {"sweep": "true"})))),
    T("frequency"),
    T("joint", without=("joint.friction",), lines={"friction": '[{ dofs = ["1:+X", "2:+X"] }]'}),
    T("joint.friction", {"dofs": PAIR}, several=True, always=True),
    T("errors", {"relative": "0.01"}),
    IDENTIFY,
])

OSCILLATE = Kind("oscillate", "Scenes of `oscillate`", ["oscillate"], ["oscillations"], [
    T("", {}),
    T("system", {"kind": '"belt_chain"', "masses": "2", "velocity": "0.1"}, always=True,
      variants={"cantilever": {"kind": '"cantilever"', "velocity": "0.1"},
                "matrices": {"kind": '"matrices"', "velocity": "0.1", **MODEL, "contact": "[1, 0]"}},
      companions=tuple({"kind": '"belt_chain"', "masses": "2", other: "0.1"} for other in ("amplitude", "frequency"))),
    T("friction", {"kinetic": "0.2", "static": "0.3", "normal": "1.0"}, always=True),
    T("start"),
    T("motion", {"length": "10", "step": "0.1"}, always=True),
    T("orbit", {"slips": "1"}, stated={"cycles": "a number"}),
    T("exponents", {"length": "100", "interval": "1"}),
    T("sweep", {"parameter": '"velocity"', "range": "[0.1, 0.2]", "points": "3", "length": "10"}),
    T("reduction", {"bases": '["pod"]', "orders": "[1]"}),
    T("normal_vibrations", {"mass": "1.0", "stiffness": "1.0", "extension_stiffness": "1.0", "slope": "0.1", "offset": "0.1"},
      stated={key: "a number" for key in ("damping", "extension_damping")}),
])

MESH = {"youngs_modulus": "1.0", "width": "1.0", "length": "1.0", "members": "2", "height": "1.0"}
HISTORY = Kind("history", "Scenes of one joint along a history: `loading-curve FILE.toml`", ["loading-curve"], ["loading-curves"], [
    T("", {}),
    T("joint", ANY_LAW, always=True, companions=({"law": '"series"'},)),
    T("mesh", {**MESH, **ANY_LAW}, without=("joint",), companions=({**MESH, "law": '"series"'},)),
    T("history", {"displacements": "[1.0]"}, always=True, variants={"a sine": {"amplitude": "1.0"}},
      companions=({"amplitude": "1.0", "algorithm": '"A"'},)),
])

MODELS = Kind("model", "Descriptions of parts that are models", ["plan"], ["model-parts"], [
    T("", {**MODEL, "dofs": '["1:+X", "2:+X"]'}, always=True,
      stated={"damping_ratio": "a number", "residual_flexibility": "a matrix, or a string: its file"},
      variants={"modes of a universal file": {"modes": '"x.uff"'},
                "modes in arrays": {"shapes": '"x.mat:s"', "frequencies": '"x.mat:f"'}}),
    *(T(key, {"range": "[0, 500]", "error": "0.01"}, several=True, stated={"range": "`[lo, hi]`", "error": "a number"})
      for key in ("stiffness_error", "mass_error")),
])

KINDS = [SOLVE, LINES, LAWS, COUPLE, DECOUPLE, EQUIVALENT, RESPONSE, OSCILLATE, HISTORY, MODELS]
