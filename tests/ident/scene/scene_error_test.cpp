#include <gmock/gmock.h>

#include "base/error.hpp"
#include "ident/scene/equivalent_scene.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {
namespace {

using ::testing::HasSubstr;

struct Wrong {
  std::string text;   ///< the wrong part of a scene
  std::string place;  ///< line and key as the message gives them
  std::string problem;
};

void expect_error(const std::string& text, const std::string& place, const std::string& problem) {
  try {
    parse_scene(text, "dir/bad.toml");
    ADD_FAILURE() << "no error for:\n" << text;
  } catch (const InputError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage) << text;
    EXPECT_THAT(error.what(), HasSubstr("dir/bad.toml: " + place)) << text;
    EXPECT_THAT(error.what(), HasSubstr(problem)) << text;
  }
}

/// Lines 1 and 2, then 3 and 4 of a right scene; what is wrong begins at line 5 unless a test leaves one out.
const std::string right_data = "data.substructures = ['a.h5']\ndata.assembly = ['b.h5']\n";
const std::string right_joint = "joint.dofs = ['4:+Y', '5:+Y']\njoint.stiffness.pattern = 'symmetric'\n";

TEST(SceneErrors, Toplevel) {
  for (const Wrong& wrong : std::vector<Wrong>{
           {"titel = 'x'", "line 5, titel", "the key 'titel' is not known here; did you mean title?"},
           {"zzzzzzzzzzzz = 1", "line 5, zzzzzzzzzzzz", "use title, data, frequency"},
           {"[solver]", "line 5, [solver]", "the key 'solver' is not known here"},
           {"title = 3", "line 5, title", "expected a string, found the integer 3"},
           {"title = 1979-05-27", "line 5, title", "expected a string, found a date or time"},
           {"frequency = 'all'", "line 5, frequency", "expected a table, found the string \"all\""},
           {"title = ", "line 5, column", "parsing"},
           {"data.assembly = 1", "line 5, column", "assembly"},
       }) {
    expect_error(right_data + right_joint + wrong.text, wrong.place, wrong.problem);
  }
  expect_error("", "", "the key 'data' is missing");
}

TEST(SceneErrors, Data) {
  for (const Wrong& wrong : std::vector<Wrong>{
           {"", "line 1, [data]", "the key 'substructures' is missing"},
           {"substructures = ['a.h5']", "line 1, [data]", "the key 'assembly' is missing"},
           {"substructures = []", "line 2, [data] substructures", "the list is empty"},
           {"substructures = 'a.h5'", "line 2, [data] substructures", "expected an array, found the string \"a.h5\""},
           {"substructures = ['']", "line 2, [data] substructures[1]", "the string is empty"},
           {"substructures = ['a.h5',\n4]", "line 3, [data] substructures[2]", "expected a string, found the integer 4"},
           {"substructures = ['a.h5', 'a.h5']", "line 2, [data] substructures[2]", "'a.h5' is named twice"},
           {"substructures = ['a']\nassembly = ['a']", "line 3, [data] assembly[1]", "'a' is named twice"},
           {"substructure = ['a.h5']", "line 2, [data] substructure", "did you mean substructures?"},
           {"substructures = ['a']\nassembly = ['b']\nreciprocity = 1", "line 4, [data] reciprocity",
            "expected true or false, found the integer 1"},
       }) {
    expect_error("[data]\n" + wrong.text, wrong.place, wrong.problem);
  }
}

TEST(SceneErrors, FilesOfTheData) {
  for (const Wrong& wrong : std::vector<Wrong>{
           {"[data.files.'c.h5']", "line 5, [data.files.\"c.h5\"]", "did you mean a.h5?"},
           {"[data.files]\n'a.h5' = 'UFF'", "line 6, [data.files] \"a.h5\"", "expected a table, found the string"},
           {"[data.files.'a.h5']\nquantity = 'mobilty'", "line 6, [data.files.\"a.h5\"] quantity", "mobility"},
           {"[data.files.'a.h5']\nunit = 'm'", "line 6, [data.files.\"a.h5\"] unit", "unit 'm' is no motion over a force"},
           {"[data.files.'a.h5']\nunit = 'V/N'", "line 6, [data.files.\"a.h5\"] unit", "unknown unit 'V/N'"},
           {"[data.files.'a.h5']\nunits = 'm/N'", "line 6, [data.files.\"a.h5\"] units", "did you mean unit?"},
           {"[data.files.'a.h5']\ndofs = ['4']", "line 6, [data.files.\"a.h5\"] dofs[1]", "'4' is not a DOF"},
           {"[data.files.'a.h5']\ndofs = []", "line 6, [data.files.\"a.h5\"] dofs", "the list is empty"},
           {"[data.files.'b.h5']\nreference_dofs = ['4:Y']", "line 6, [data.files.\"b.h5\"] reference_dofs", "without dofs"},
           {"[data.files.'a.h5']\nquantity = 'inertia'", "line 6, [data.files.\"a.h5\"] quantity", "unknown FRF quantity"},
           {"[data.files.'a.h5']\nquantity = 'admittance'", "line 6, [data.files.\"a.h5\"] quantity",
            "write receptance for displacement over force"},
           {"[data.files.'a.h5']\nflip = '4:Y'", "line 6, [data.files.\"a.h5\"] flip", "expected an array"},
           {"[data.files.'a.h5']\nflip = ['4:Y', '4:-Y']", "line 6, [data.files.\"a.h5\"] flip[2]", "is here twice"},
           {"[data.files.'a.h5']\nflips = ['4:Y']", "line 6, [data.files.\"a.h5\"] flips", "did you mean flip?"},
           {"[data.files.'a.h5']\nrename = { '4' = '5:Y' }", "line 6, [data.files.\"a.h5\".rename] 4", "'4' is not a DOF"},
           {"[data.files.'a.h5']\nrename = { '4:Y' = '5:Y', '3:Y' = '5:Y' }", "line 6, [data.files.\"a.h5\".rename] \"",
            "5:+Y is here twice"},
           {"[data.files.'a.h5']\nrename = {}", "line 6, [data.files.\"a.h5\".rename]", "the table is empty"},
           {"[data.files.'a.h5']\ngain = 0", "line 6, [data.files.\"a.h5\"] gain", "expected a number above 0, found 0"},
           {"[data.files.'a.h5']\ngain = { '4:Y' = -1.0 }", "line 6, [data.files.\"a.h5\".gain] \"4:Y\"",
            "expected a number above 0, found -1"},
           {"[data.files.'a.h5']\ndelay = 20.0", "line 6, [data.files.\"a.h5\"] delay", "a delay of 20 s is longer than 1 s"},
           {"[data.files.'a.h5']\nfrequency_scale = 101", "line 6, [data.files.\"a.h5\"] frequency_scale",
            "is not between 0.5 and 2"},
           {"[data.files.'a.h5']\nconjugate = 1", "line 6, [data.files.\"a.h5\"] conjugate", "expected true or false"},
           {"[data.files.'a.h5']\nsensor_mass = 0.003", "line 6, [data.files.\"a.h5\"] sensor_mass", "expected a table, found"},
           {"[data.files.'a.h5']\nsensors = 'fixed'", "line 6, [data.files.\"a.h5\"] sensors",
            "sensors is given without sensor_mass"},
           {"[data.files.'a.h5']\nsensor_mass = { '4:Y' = 0.003 }\nsensors = 'glued'", "line 7, [data.files.\"a.h5\"] sensors",
            "roving, triaxial or fixed"},
           {"[data.files.'b.h5']\nvariable = ''", "line 6, [data.files.\"b.h5\"] variable", "the string is empty"},
       }) {
    expect_error(right_data + right_joint + wrong.text, wrong.place, wrong.problem);
  }
}

TEST(SceneErrors, Frequency) {
  for (const Wrong& wrong : std::vector<Wrong>{
           {"range = [1000, 400]", "range", "expected lo < hi, found [1000, 400]"},
           {"range = [400, 400]", "range", "expected lo < hi"},
           {"range = [-1, 400]", "range[1]", "expected a number of at least 0, found -1"},
           {"range = [1, 2, 3]", "range", "expected [lo, hi], found an array of 3"},
           {"range = [1, '2']", "range[2]", "expected a number, found the string \"2\""},
           {"range = [1, inf]", "range[2]", "expected a finite number, found inf"},
           {"range = [1, nan]", "range[2]", "expected a finite number"},
           {"range = [1, 2], step = 0", "step", "expected a number above 0, found 0"},
           {"range = [1, 2], step = -5.0", "step", "expected a number above 0, found -5"},
           {"range = [1, 2], step = 1e-9", "step", "more than ten million lines"},
           {"step = 1.0", "step", "a step needs a range"},
           {"exclude = [[3, 2]]", "exclude[1]", "expected lo < hi"},
           {"exclude = [3, 2]", "exclude[1]", "expected [lo, hi], found the integer 3"},
           {"ranges = [1, 2]", "ranges", "did you mean range?"},
           {"exclude_resonances = true", "exclude_resonances", "expected a table, found the boolean true"},
       }) {
    expect_error(right_data + right_joint + "frequency = {" + wrong.text + "}", "line 5, [frequency] " + wrong.place,
                 wrong.problem);
  }
  for (const Wrong& wrong : std::vector<Wrong>{
           {"half_width = 0.1", "line 5, [frequency.exclude_resonances]", "the key 'of' is missing"},
           {"of = ['joint']", "line 5, [frequency.exclude_resonances] of[1]", "use substructures or assembly"},
           {"of = []", "line 5, [frequency.exclude_resonances] of", "the list is empty"},
           {"of = ['assembly', 'assembly']", "line 5, [frequency.exclude_resonances] of[2]", "is named twice"},
           {"of = ['assembly'], half_width = 1.0", "line 5, [frequency.exclude_resonances] half_width",
            "not between 0 and 1"},
           {"of = ['assembly'], half_width = 0", "line 5, [frequency.exclude_resonances] half_width",
            "not between 0 and 1"},
       }) {
    expect_error(right_data + right_joint + "frequency.exclude_resonances = {" + wrong.text + "}", wrong.place,
                 wrong.problem);
  }
}

TEST(SceneErrors, Joint) {
  for (const Wrong& wrong : std::vector<Wrong>{
           {"", "line", "declare [joint] or [[joints]]"},
           {"joints = []", "line 3, joints", "the list is empty"},
           {"[joint]", "line 3, [joint]", "the key 'dofs' is missing"},
           {"[joint]\ndofs = []", "line 4, [joint] dofs", "the list is empty"},
           {"[joint]\ndofs = ['4:+Y', '5:+Q']", "line 4, [joint] dofs[2]", "'5:+Q' is not a DOF; write node:direction"},
           {"[joint]\ndofs = ['4:+Y', '4:-Y']", "line 4, [joint] dofs[2]", "coordinate of 4:-Y is here twice"},
           {"[joint]\ndofs = ['4:+Y']", "line 3, [joint]", "the joint has no matrix"},
           {"[joint]\nname = 'a'", "line 4, [joint] name", "is not known here"},
           {"[joint]\ndamping = 1", "line 4, [joint] damping", "is not known here"},
           {"[joint.stifness]", "line 3, [joint.stifness]", "did you mean stiffness?"},
           {"[joint]\ndofs = ['4:+Y']\nbands = []", "line 5, [joint] bands", "the list is empty"},
           {"[joint]\ndofs = ['4:+Y']\nbands = [[1, 3], [2, 4]]", "line 5, [joint] bands[2]", "do not overlap"},
           {"[joint]\ndofs = ['4:+Y']\nbands = [[3, 1]]", "line 5, [joint] bands[1]", "expected lo < hi"},
           {right_joint + "[[joints]]", "line 3, [joint]", "both [joint] and [[joints]]"},
       }) {
    expect_error(right_data + wrong.text, wrong.place, wrong.problem);
  }
}

TEST(SceneErrors, SeveralJoints) {
  const auto joint = [](const std::string& name, const std::string& dof) {
    return "[[joints]]\n" + name + "\ndofs = ['" + dof + "']\nstiffness.pattern = 'full'\n";
  };
  for (const Wrong& wrong : std::vector<Wrong>{
           {joint("", "1:X") + joint("name = 'b'", "2:X"), "line 7, [joints[2]]", "no name"},
           {joint("name = 'a'", "1:X") + joint("name = 'a'", "2:X"), "line 7, [joints[2]]", "two joints have this name"},
           {joint("name = 'a'", "1:X") + joint("name = 'b'", "1:-X"), "line 7, [joints[2]]", "a DOF of joint 'a'"},
           {joint("name = 'a.b'", "1:X"), "line 4, [joints[1]] name", "has a dot"},
           {joint("name = ''", "1:X"), "line 4, [joints[1]] name", "the string is empty"},
           {"[joints]", "line 3, [joints]", "[joints] is one table; write [[joints]]"},
           {joint("name = 'a'", "1:X") + "mass.matrix = [['a*b']]", "line 7, [joints[1].mass] matrix[1][1]",
            "'a*b' multiplies"},
       }) {
    expect_error(right_data + wrong.text, wrong.place, wrong.problem);
  }
}

TEST(SceneErrors, MatricesOfTheJoint) {
  for (const Wrong& wrong : std::vector<Wrong>{
           {"", "line 4, [joint.mass]", "the matrix has no form"},
           {"pattern = 'full'\nmatrix = [['a']]", "line 4, [joint.mass]", "more than one form"},
           {"pattern = 'symetric'", "line 5, [joint.mass] pattern", "did you mean symmetric?"},
           {"pattern = 'Full'", "line 5, [joint.mass] pattern", "did you mean full?"},
           {"patern = 'full'", "line 5, [joint.mass] patern", "did you mean pattern?"},
           {"matrix = []", "line 5, [joint.mass] matrix", "the list is empty"},
           {"matrix = [['a']]", "line 5, [joint.mass] matrix", "1 rows, but the joint has 2 DOFs"},
           {"matrix = [['a', 'b'], ['c']]", "line 5, [joint.mass] matrix", "row 2 has 1 elements"},
           {"matrix = [['a', 'b'],\n['a*b', 1]]", "line 6, [joint.mass] matrix[2][1]", "'a*b' multiplies the unknowns"},
           {"matrix = [['a', '2k'], [1, 1]]", "line 5, [joint.mass] matrix[1][2]", "lacks an operator (character 2)"},
           {"matrix = [['a', true], [1, 1]]", "line 5, [joint.mass] matrix[1][2]", "expected a number, found the boolean"},
           {"matrix = ['a', 'b']", "line 5, [joint.mass] matrix[1]", "expected an array, found the string"},
           {"springs = []", "line 5, [joint.mass] springs", "the list is empty"},
           {"springs = [['4:+Y']]", "line 5, [joint.mass] springs[1]", "a spring has two ends, found 1"},
           {"springs = [['ground', 'ground']]", "line 5, [joint.mass] springs[1][2]", "'ground' is not a DOF"},
           {"springs = [['4:+Y', '6:+Y']]", "line 5, [joint.mass] springs", "6:+Y is not a DOF of the joint"},
           {"springs = [['4:+Y', '4:-Y']]", "line 5, [joint.mass] springs", "both ends on one DOF"},
           {"springs = [['4:+Y', '5:+Y'], ['5:+Y', '4:+Y']]", "line 5, [joint.mass] springs", "parallel"},
           {"pattern = 'free'\n[nodes]\n4 = [0, 0, 0]\n5 = [0, 0, 0]\n6 = [1]", "line 9, [nodes] 6",
            "three coordinates, found 1"},
           {"pattern = 'free'\n[nodes]\nleft = [0, 0, 0]", "line 7, [nodes] left", "'left' is not a node number"},
           {"pattern = 'free'\n[nodes]\n4 = [0, 0, 0]\n04 = [1, 0, 0]", "line 8, [nodes] 04", "here twice"},
           {"pattern = 'free'\n[nodes]\n4 = [0, 0, 'a']", "line 7, [nodes] 4[3]", "expected a number"},
           {"pattern = 'free'\n[nodes]\n4 = [0, 0, 0]\n5 = [0, 1e200, 0]", "line 5, [joint.mass] pattern",
            "position of node 5 is out of range"},
       }) {
    expect_error(right_data + "joint.dofs = ['4:+Y', '5:+Y']\n[joint.mass]\n" + wrong.text, wrong.place, wrong.problem);
  }
}

TEST(SceneErrors, Identify) {
  for (const Wrong& wrong : std::vector<Wrong>{
           {"method = 'tow'", "line 6, [identify] method", "did you mean two?"},
           {"method = 1", "line 6, [identify] method", "expected a string, found the integer 1"},
           {"equations = []", "line 6, [identify] equations", "the list is empty"},
           {"equations = ['nn', 'jk']", "line 6, [identify] equations[2]", "'jk' is not a valid word"},
           {"equations = ['nn', 'nn']", "line 6, [identify] equations[2]", "named twice"},
           {"weighting = 'wbs'", "line 6, [identify] weighting", "did you mean WBS?"},
           {"delta = 2", "line 6, [identify] delta", "outside 0 <= delta < 2"},
           {"delta = -0.1", "line 6, [identify] delta", "outside 0 <= delta < 2"},
           {"solver = 'spqrr'", "line 6, [identify] solver", "did you mean spqr?"},
           {"threads = 2", "line 6, [identify] threads", "is not known here"},
           {"start = [[1]]", "line 6, [identify] start", "expected a table, found an array of 1"},
           {"start.stiffness = [[1]]", "line 6, [identify.start] stiffness", "found 1 rows, expected 2"},
           {"start.stiffness = [[1, 2],\n[3]]", "line 7, [identify.start] stiffness[2]", "found 1 elements, expected 2"},
           {"start.mass = [[1, 2], [3, 4]]", "line 6, [identify.start]", "no joint has that matrix"},
       }) {
    expect_error(right_data + right_joint + "[identify]\n" + wrong.text, wrong.place, wrong.problem);
  }
}

TEST(SceneErrors, NoiseAndTruth) {
  for (const Wrong& wrong : std::vector<Wrong>{
           {"[noise]\nlevel = 0.05", "line 5, [noise]", "the key 'model' is missing"},
           {"[noise]\nmodel = 'uniform'", "line 5, [noise]", "the key 'level' is missing"},
           {"[noise]\nmodel = 'gausian'\nlevel = 1", "line 6, [noise] model", "did you mean gaussian?"},
           {"[noise]\nmodel = 'uniform'\nlevel = -1", "line 7, [noise] level", "at least 0, found -1"},
           {"[truth]\nstiffness = [[1, 2, 3], [1, 2, 3], [1, 2, 3]]", "line 6, [truth] stiffness", "found 3 rows"},
           {"[truth]\nstiffness = [[1, 'k'], [1, 2]]", "line 6, [truth] stiffness[1][2]", "expected a number"},
           {"[truth]\ndamping = [[1]]", "line 6, [truth] damping", "is not known here"},
       }) {
    expect_error(right_data + right_joint + wrong.text, wrong.place, wrong.problem);
  }
}

TEST(SceneErrors, TablesAndListsOfTables) {
  expect_error("data.substructures = ['a.h5']\ndata.assembly = ['b.h5']\n[[joint]]\ndofs = ['4:+Y']\nstiffness.pattern = 'full'\n",
               "line 3, joint",
               "[[joint]] is a list of tables; one joint is [joint]; each of several is [[joints]]");
  expect_error("data.substructures = ['a.h5']\ndata.assembly = ['b.h5']\n[joints]\ndofs = ['4:+Y']\nstiffness.pattern = 'full'\n",
               "line 3, [joints]", "write [[joints]], once for each joint");
  expect_error("[[data]]\nsubstructures = ['a.h5']\n", "line 1, data", "expected a table, found an array of 1; [[data]] should be [data]");
  expect_error(right_data + right_joint + "[virtual_points]\nname = 'VP1'\n", "line 5, [virtual_points]",
               "[virtual_points] should be [[virtual_points]]");
  expect_error(right_data + right_joint + "[data.gains]\ndof = '4:+Y'\n", "line 5, [data.gains]",
               "[data.gains] should be [[data.gains]]");
  expect_error(right_data + right_joint + "[data.masses]\ndof = '4:+Y'\n", "line 5", "[data.masses] should be [[data.masses]]");
}

TEST(SceneErrors, StartsByNumbers) {
  const std::string springs = right_data + "joint.dofs = ['4:+Y', '5:+Y']\njoint.stiffness.springs = [['4:+Y', '5:+Y']]\n[identify]\n";
  expect_error(right_data + right_joint + "identify.start = 1e6", "line 5, [identify] start", "one number is for springs or a diagonal");
  expect_error(springs + "start = [1e6, 2e6]", "line 6, [identify] start", "2 numbers for 1 unknowns");
  expect_error(springs + "start = { stiffness = { k = 1e6 } }", "line 6, [identify.start.stiffness]", "has no value of K[4:+Y,5:+Y]");
  expect_error(springs + "start = { mass = 1.0 }", "line 6", "no joint has that matrix");
  expect_error(springs + "start = { \"K[4:+Y,5:+Y]\" = 1e6, k = 1e6 }", "line 6, [identify.start] k",
               "the key 'k' is not known here");
  expect_error(springs + "start = { k = 1e6 }", "line 6, [identify.start] k",
               "use stiffness, mass, viscous_damping or hysteretic_damping");
  expect_error(springs + "start = [[1e6]]", "line 6, [identify] start", "write start = { stiffness = [[…], …] }");
}

TEST(SceneErrors, NamesOfSprings) {
  const std::string begin = right_data + "joint.dofs = ['4:+Y', '5:+Y']\njoint.stiffness.springs = ";
  expect_error(begin + "{ '1k' = ['4:+Y', '5:+Y'] }", "line 4", "'1k' is no name of a spring");
  expect_error(begin + "{ k = ['4:+Y', '6:+Y'] }", "line 4", "6:+Y is not a DOF of the joint");
  expect_error(begin + "{ k = ['4:+Y', '4:-Y'] }", "line 4", "the spring has both ends on one DOF");
  expect_error(begin + "{ k = ['4:+Y', '5:+Y'], k = ['5:+Y', 'ground'] }", "line 4",
               "several springs of one name are a list: k1 = [[");
  expect_error(begin + "[{ k = ['4:+Y', '5:+Y'] }]", "line 4, [joint.stiffness.springs[1]]", "or with names { k1 = [");
  expect_error(begin + "['4:+Y', '5:+Y']", "line 4, [joint.stiffness] springs[1]", "write [[\"4:+Y\", \"5:+Y\"], …]");
  expect_error(begin + "[['k', '4:+Y', '5:+Y']]", "line 4, [joint.stiffness] springs[1]", "a name goes before it, { k1 = [");
}

/// GCC 12 destroyed the file's name of such a level twice.
TEST(SceneErrors, AWrongLevelOfAnEquivalentJoint) {
  for (const auto& [wrong, says] : std::vector<std::pair<std::string, std::string>>{{"-1", "expected a number above 0, found -1"},
                                                                                  {"nan", "expected a finite number, found nan"},
                                                                                  {"true", "expected a number, found the boolean true"},
                                                                                  {"{}", "expected a number, found a table"}}) {
    std::string text = "data.parts = ['a.h5']\n[equivalent]\ndofs = ['1:+Y', '2:+Y']\nlevels = [\n";
    for (const std::string& displacement : {std::string("1e-6"), std::string("2e-6"), wrong, std::string("4e-6")}) {
      text += "{ assembly = 'a long name of a file of one level.h5', displacement = " + displacement + " },\n";
    }
    try {
      parse_equivalent_scene(text + "]\n", "some/folder/equivalent.toml");
      ADD_FAILURE() << wrong;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("line 7, [equivalent.levels[3]")) << wrong;
      EXPECT_THAT(error.what(), HasSubstr(says)) << wrong;
    }
  }
}

}  // namespace
}  // namespace jointid::ident
