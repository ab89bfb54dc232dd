#include "tasks/joint_history/joint_history.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "problems/thesis/mesh_joints.hpp"
#include "tests/require.hpp"
#include "tests/test_folder.hpp"

/// Scenes of joints against golden/seeds.json, an independent program (formulas in seeds.md 5 to 9).
namespace jointid::tasks {
namespace {

using nlohmann::json;

std::filesystem::path seeds_file() {
  return std::filesystem::path(JOINTID_EXTERNAL_DATA).parent_path() / "golden" / "seeds.json";
}

/// What is expected of the case of that name; null where there is no file.
json expected_of(const std::string& name) {
  std::ifstream in(seeds_file());
  if (!in) return nullptr;
  const json all = json::parse(in);
  for (const json& each : all["cases"]) {
    if (each["name"] == name) return each["expected"];
  }
  return nullptr;
}

JointHistory history_of(const std::string& text) { return run_joint_history(parse_joint_history(text, "joint.toml")); }

/// "[1.0, 2.0]" of the i-th of every entry.
std::string column(const json& rows, std::size_t i) {
  json all = json::array();
  for (const json& row : rows) all.push_back(row[i].get<double>());
  return all.dump();
}

std::string law(const std::string& name, const json& parameters) {
  std::string text = "[joint]\nlaw = \"" + name + "\"\n";
  if (parameters.is_array()) return text + "parameters = " + parameters.dump() + "\n";
  text += "parameters = { ";
  std::string comma;
  for (const auto& [key, value] : parameters.items()) {
    text += comma + key + " = " + value.dump();
    comma = ", ";
  }
  return text + " }\n";
}

/// The built-in problems of Table 2.8 and case Three, by the scenes that are written.
TEST(JointHistory, MeshProblemsHaveTheirTruth) {
  for (const problems::MeshJoint& problem : problems::list_mesh_joints()) {
    const TestFolder folder;
    const JointHistory found = run_joint_history(read_joint_history(problems::write(problem, folder)));
    ASSERT_EQ(found.ends.size(), 2u) << problem.name;
    EXPECT_NEAR(*found.limit / problem.limit, 1.0, 1e-10) << problem.name;
    const HistoryPoint &there = found.points[found.ends[0]], &back = found.points[found.ends[1]];
    EXPECT_NEAR(there.displacement / problem.displacement, 1.0, 1e-9) << problem.name;
    EXPECT_NEAR(back.displacement / problem.displacement, -1.0, 1e-9) << problem.name;
  }
}

/// u(h) by the scene's key, against the independent program.
TEST(JointHistory, SharesOfSlipAreThoseOfTheLaw) {
  const json one = expected_of("uh_from_slopes_shoukry");
  if (one.is_null()) JOINTID_SKIP("no reference file " << seeds_file());
  const JointHistory found = history_of(law("shoukry", {{"a", one["a"]}, {"b", one["b"]}}) +
                                        "[history]\ndisplacements = [1e-6]\nshares = " + one["h"].dump() + "\n");
  ASSERT_EQ(found.slip_displacements.size(), one["u"].size());
  for (std::size_t i = 0; i < one["u"].size(); ++i) EXPECT_NEAR(found.slip_displacements[i] / one["u"][i].get<double>(), 1.0, 1e-10);
  EXPECT_THROW(history_of(law("shoukry", {{"a", one["a"]}, {"b", one["b"]}}) + "[history]\ndisplacements = [1e-6]\nshares = [1.0]\n"),
               InputError);
}

/// The points of a history after each turn are those of `rows`, [u, F].
void expect_points(const JointHistory& found, const json& rows, double tolerance, const std::string& what) {
  double largest_u = 0.0, largest_f = 0.0;
  for (const json& row : rows) {
    largest_u = std::max(largest_u, std::abs(row[0].get<double>()));
    largest_f = std::max(largest_f, std::abs(row[1].get<double>()));
  }
  ASSERT_EQ(found.ends.size(), rows.size()) << what;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const HistoryPoint& at = found.points[found.ends[i]];
    EXPECT_NEAR(at.displacement, rows[i][0].get<double>(), tolerance * largest_u) << what << " " << i;
    EXPECT_NEAR(at.force, rows[i][1].get<double>(), tolerance * largest_f) << what << " " << i;
  }
}

/// The curve, the loop from its corner and the energy of a cycle of one law.
void expect_law(const std::string& joint, const json& each, const std::string& what) {
  const std::string turns = joint + "[history]\npoints = 1\ndisplacements = ";
  expect_points(history_of(turns + column(each["curve"], 0)), each["curve"], 1e-10, what + " curve");
  expect_points(history_of(turns + column(each["loop"], 0)), each["loop"], 1e-10, what + " loop");
  const double u = each["loop_amplitude"], energy = each["energy"];
  const JointHistory cycles =
      history_of(joint + "[history]\ncycles = 2\nsteps = 40\namplitude = " + each["loop_amplitude"].dump());
  EXPECT_NEAR(cycles.work[1], energy, 1e-8 * energy) << what << " at " << u;
  EXPECT_NEAR(cycles.mean[1], 0.0, 1e-9 * each["curve"].back()[1].get<double>()) << what;
}

TEST(JointHistory, OfMenqsBarIsTheGoldenOne) {
  const json cases = expected_of("menq");
  if (cases.is_null()) JOINTID_SKIP("no reference file " << seeds_file());
  for (const json& each : cases) {
    const std::string joint = law("menq", each["parameters"]);
    expect_law(joint, each, "menq");
    const JointHistory found = history_of(joint + "[history]\namplitude = 1e-6\n");
    for (const auto& [place, key] : {std::pair{0u, "slip_start"}, {1u, "macroslip"}}) {
      EXPECT_NEAR(found.kinks[place].displacement, each[key][0].get<double>(), 1e-10 * each[key][0].get<double>());
      EXPECT_NEAR(found.kinks[place].force, each[key][1].get<double>(), 1e-10 * each[key][1].get<double>());
    }
    const json& p = each["parameters"];
    if (p["beta"] != 0.0) continue;
    const double tau = p["tau"], k = p["k"], length = p["L"], ea = p["EA"];
    const json shape = {{"f", tau * length}, {"u", tau / k}, {"lambda", length * std::sqrt(k / ea)}};
    expect_law(law("menq-shape", shape), each, "menq-shape");
  }
}

TEST(JointHistory, OfABendingRootIsTheGoldenOne) {
  const json expected = expected_of("bending_root");
  if (expected.is_null()) JOINTID_SKIP("no reference file " << seeds_file());
  const json& p = expected["parameters"];
  const double ei = p["EI"], l0 = p["L0"], tau = p["tau"];
  const json shape = {{"k", 3.0 * ei / (l0 * l0 * l0)}, {"f", tau * l0}};
  for (const std::string& joint : {law("bending-root", p), law("bending-root-shape", shape)}) {
    for (const json& each : expected["points"]) {
      json rows = json::array();  // [u, F], where the sheet has [F, u]
      for (const json& point : each["loop"]) rows.push_back({point[1], point[0]});
      const JointHistory found = history_of(joint + "[history]\npoints = 1\nforces = " + column(each["loop"], 0));
      expect_points(found, rows, 1e-10, joint);
      const double u = each["u_tip"], energy = each["energy"];
      const JointHistory cycle = history_of(joint + "[history]\ncycles = 2\nsteps = 8\namplitude = " + each["u_tip"].dump());
      EXPECT_NEAR(cycle.work[1], energy, 1e-9 * energy) << u;
    }
  }
}

TEST(JointHistory, OfOtherSlipDisplacementsIsTheGoldenOne) {
  const json cases = expected_of("general_uh");
  if (cases.is_null()) JOINTID_SKIP("no reference file " << seeds_file());
  const std::map<std::string, std::string> names = {
      {"power", "power"}, {"square", "square"}, {"expoffset", "exponential-offset"}, {"exp", "ren"}};
  for (const json& each : cases) {
    json parameters = each["parameters"];
    parameters.push_back(each["k"]);
    const std::string joint = law(names.at(each["form"]), parameters);
    expect_law(joint, each, each["form"]);
    EXPECT_NEAR(*history_of(joint + "[history]\namplitude = 1e-7\n").limit, each["limit"].get<double>(), 1e-12);
  }
}

/// Algorithm A under a changing normal load, all five loads.
TEST(JointHistory, UnderAChangingNormalLoadIsTheGoldenOne) {
  const json expected = expected_of("algorithm_a");
  if (expected.is_null()) JOINTID_SKIP("no reference file " << seeds_file());
  const std::map<std::string, std::string> loads = {{"constant", ""},
                                                    {"with_displacement", "normal = [[1, 0.5, 0.0]]\n"},
                                                    {"with_velocity", "normal = [[1, 0.5, 90.0]]\n"},
                                                    {"twice", "normal = [[2, 0.5, 0.0]]\n"},
                                                    {"lift_off", "normal = [[2, 1.5, 0.0]]\n"}};
  const json& p = expected["parameters"];
  const std::string joint = law("ren", {{"a", p["a"]}, {"b", p["b"]}, {"k", p["k"]}});
  for (const auto& [name, each] : expected["cases"].items()) {
    const JointHistory found =
        history_of(joint + "[history]\nalgorithm = \"A\"\nsliders = " + expected["sliders"].dump() +
                   "\nsteps = " + expected["steps_per_cycle"].dump() + "\ncycles = " + expected["cycles"].dump() +
                   "\namplitude = " + p["X"].dump() + "\n" + loads.at(name));
    const json& forces = each["F_every_30_degrees_of_cycle_3"];
    const std::size_t steps = expected["steps_per_cycle"], first = found.ends[1], stride = steps / forces.size();
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const double nearest = std::min(std::abs(found.points[first + (i + 1) * stride].force - forces[i].get<double>()),
                                      std::abs(found.points[first + i * stride].force - forces[i].get<double>()));
      EXPECT_LT(nearest, 1e-10) << name << " " << i;
    }
    EXPECT_NEAR(found.work[2], each["energy_cycle_3"].get<double>(), 1e-9 * each["energy_cycle_3"].get<double>()) << name;
    EXPECT_NEAR(found.mean[2], each["mean_cycle_3"].get<double>(), 1e-10) << name;
  }
}

std::string mesh(const std::string& name, const json& input, const json& each) {
  const json& c = input["case_three"];
  std::string text = "[mesh]\nyoungs_modulus = 2.06e11\nwidth = 0.01\n";
  if (name.starts_with("two")) {
    const json& two = input["case_two"];
    text += "lengths = " + two["L"].dump() + "\nheights = " + two["H"].dump() + "\nstiffness = [";
    for (const json& k : two["K_1e12"]) text += std::to_string(k.get<double>() * 1e12) + ", ";
    text += "]\nlaw = \"ren\"\nparameters = [" + two["a"].dump() + ", " + two["b"].dump() + ", 1e12]\n";
    return text + (name.ends_with("node_1") ? "loaded = \"first\"\n" : "");
  }
  text += "height = " + c["H"].dump() + "\nlength = " + each["length"].dump() + "\nmembers = " + each["elements"].dump() + "\n";
  const double a = c["a"], b = c["b"], k = c["k"], limit = k * a * std::expm1(b) / b, end = a * std::exp(b);
  const bool stiff = name.find("same_stiffness") != std::string::npos;
  json parameters = {a, b, k};
  if (!name.ends_with("ren_20")) parameters = stiff ? json{limit / k, k} : json{end, limit / end};
  return text + "law = \"" + (name.ends_with("ren_20") ? "ren" : "bilinear") + "\"\nparameters = " + parameters.dump() + "\n";
}

/// Cases Two and Three: displacements at shares of the limit, nodes, unloading.
TEST(JointHistory, OfMeshesIsTheGoldenOne) {
  std::ifstream in(seeds_file());
  if (!in) JOINTID_SKIP("no reference file " << seeds_file());
  json whole;
  const json all = json::parse(in);
  for (const json& one : all["cases"]) {
    if (one["name"] == "finite_element_joint") whole = one;
  }
  for (const auto& [name, each] : whole["expected"].items()) {
    if (!each.is_object()) continue;
    const std::string joint = mesh(name, whole["input"], each) + "[history]\npoints = 1\nforces = ";
    const double limit = each["limit"];
    json forces = json::array(), rows = json::array();
    for (std::size_t i = 0; i < each["shares"].size(); ++i) {
      const double force = each["shares"][i].get<double>() * limit;
      forces.push_back(force);
      rows.push_back({each["u"][i], force});
    }
    const JointHistory loaded = history_of(joint + forces.dump());
    expect_points(loaded, rows, 1e-9, name);
    EXPECT_NEAR(*loaded.limit, limit, 1e-9 * limit) << name;
    json back = {0.9 * limit};
    json unloading = {{each["u"][4], 0.9 * limit}};
    for (const json& point : each["unloading"]) {
      back.push_back(point[0]);
      unloading.push_back({point[1], point[0]});
    }
    const JointHistory found = history_of(joint + back.dump());
    expect_points(found, unloading, 1e-9, name + " unloading");
    const json& nodes = each["nodes_at_0.9"]["u"];
    const std::size_t stride = (found.nodes[0].displacement.size() - 1) / (nodes.size() - 1);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      EXPECT_NEAR(found.nodes[0].displacement[i * stride], nodes[i].get<double>(), 1e-9 * each["u"][4].get<double>())
          << name << i;
  }
}

TEST(JointHistory, RefusesWhatIsWrong) {
  const std::string joint = "[joint]\nlaw = \"bilinear\"\nparameters = [1e-6, 1e6]\n";
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {joint, "history"},
      {joint + "[history]\n", "one of displacements, forces and amplitude"},
      {joint + "[history]\nforces = [2.0]\n", "no displacement reaches"},
      {joint + "[history]\namplitude = 1e-6\nnormal = [[1, 0.5]]\n", "[harmonic, share, phase in degrees]"},
      {joint + "[history]\namplitude = 1e-6\nalgorithm = \"B\"\nnormal = [[1, 0.5, 0]]\n", "Masing"},
      {joint + "[history]\namplitude = 1e-6\nsliders = 5\n", "only algorithm A"},
      {"[joint]\nlaw = \"menq\"\nparameters = { EA = 1.0 }\n[history]\namplitude = 1e-6\n", "'L'"},
      {"[joint]\nlaw = \"menq\"\nparameters = [1.0, 1.0, 1.0, 1.0, -1.0]\n[history]\namplitude = 1e-6\n", "beta"},
      {"[joint]\nlaw = \"exponential-offset\"\nparameters = [1e-8, 1.0, -2e-8, 1e6]\n[history]\namplitude = 1e-6\n", "u(0)"},
      {"[joint]\nlaw = \"parallel:ren\"\nparameters = [1e-8, 1.0, 1e6]\n[history]\namplitude = 1e-6\n", "name two to four"},
      {"[mesh]\nyoungs_modulus = 1.0\nwidth = 1.0\nlength = 1.0\nmembers = 2\nheights = [1.0]\nlaw = \"ren\"\nparameters = "
       "[1e-8, 1.0, "
       "1e6]\n[history]\namplitude = 1e-6\n",
       "has 1 values"},
  };
  for (const auto& [text, words] : wrong) {
    try {
      (void)history_of(text);
      ADD_FAILURE() << "not refused: " << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what() << "\n" << words;
    }
  }
}

/// Arrangements are the same as parts, by either way of writing them.
TEST(JointHistory, OfArrangementsIsThatOfTheirParts) {
  const std::string history = "[history]\npoints = 7\ndisplacements = [3e-6, -2e-6, 1e-6]\n";
  for (const std::string kind : {"series", "parallel"}) {
    const JointHistory named =
        history_of("[joint]\nlaw = \"" + kind + ":ren:bilinear\"\nparameters = [2e-7, 1.5, 1e6, 4e-7, 3e6]\n" + history);
    const JointHistory parts = history_of("[joint]\nlaw = \"" + kind +
                                          "\"\nparts = [{ law = \"ren\", parameters = [2e-7, 1.5, 1e6] }, { law = \"bilinear\", "
                                          "parameters = [4e-7, 3e6] }]\n" +
                                          history);
    for (std::size_t i = 0; i < parts.points.size(); ++i) EXPECT_EQ(named.points[i].force, parts.points[i].force) << kind << i;
  }
}

}  // namespace
}  // namespace jointid::tasks
