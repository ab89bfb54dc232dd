#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "base/statistics.hpp"
#include "frf/set/frf_source.hpp"
#include "input_folder.hpp"
#include "run_command.hpp"

namespace jointid::cli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using Json = nlohmann::json;

/// Input from which no usable numbers come: the results are written all the same, and marked.
struct Unusable {
  std::string name;
  Spoil spoil;
  std::string status;
  std::vector<std::string> says;
  std::vector<std::string> undetermined;  ///< some of the unknowns that are named
};

void PrintTo(const Unusable& unusable, std::ostream* out) { *out << unusable.name; }

std::vector<std::string> undetermined_in(const Json& solution) {
  std::vector<std::string> names;
  for (const Json& unknown : solution["unknowns"]) {
    if (!unknown["determined"].get<bool>()) names.push_back(unknown["name"]);
  }
  return names;
}

class UnusableNumbers : public testing::TestWithParam<Unusable> {};

TEST_P(UnusableNumbers, AreWrittenAndMarked) {
  const Unusable& unusable = GetParam();
  const InputFolder folder;
  unusable.spoil(folder);
  const Outcome outcome = run_command(folder.path(), {"solve", "A1.toml", "--json", "old.json", "--csv", "new.csv"});
  RecordProperty("message", outcome.err);
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, StartsWith("jointid: error: A1.toml: "));
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
  for (const std::string& part : unusable.says) EXPECT_THAT(outcome.err, HasSubstr(part));
  std::string words = unusable.status;
  std::ranges::replace(words, '_', ' ');
  EXPECT_THAT(outcome.out, HasSubstr("\n  status   " + words + "\n"));
  const Json solution = Json::parse(folder.text("old.json"));
  EXPECT_EQ(solution["status"], unusable.status);
  EXPECT_EQ("jointid: error: A1.toml: " + solution["message"].get<std::string>() + "\n", outcome.err);
  for (const std::string& name : unusable.undetermined) {
    EXPECT_THAT(undetermined_in(solution), testing::Contains(name));
    EXPECT_THAT(outcome.err, HasSubstr(name));
    EXPECT_THAT(folder.text("new.csv"),
                testing::ContainsRegex("\n\"" + std::regex_replace(name, std::regex("[()]"), "\\$&") + "\",.*false"));
  }
  EXPECT_THAT(folder.text("new.csv"), StartsWith("name,value,"));
}

Spoil every_value(const std::string& file, Complex value) {
  return with_set(file, [value](frf::FrfSet& set) { std::ranges::fill(set.values, value); });
}

/// Files that hold the 0 Hz line of accelerances only: no receptance follows from that.
const Spoil only_zero_hz = [](const InputFolder& folder) {
  for (const char* file : {"A1_assembly.h5", "A1_substructure_1.h5", "A1_substructure_2.h5"}) {
    with_set(file, [](frf::FrfSet& set) {
      set.header.frequency_hz = {0.0};
      set.header.quantity = frf::Quantity::accelerance;
      set.values.resize(set.header.entries());
    })(folder);
  }
  folder.replace("A1.toml", "range = [400.0, 1000.0]", "range = [0.0, 1000.0]");
};

/// The assembly as the parts are without a joint, so that Δ finds no difference.
const Spoil no_joint_at_all = [](const InputFolder& folder) {
  const frf::FrfSet parts[] = {frf::load(*frf::open(folder.path("A1_substructure_1.h5"))),
                               frf::load(*frf::open(folder.path("A1_substructure_2.h5")))};
  with_set("A1_assembly.h5", [&](frf::FrfSet& set) {
    std::ranges::fill(set.values, Complex(0.0));
    for (const frf::FrfSet& part : parts) {
      for (std::size_t i = 0; i < part.values.size(); ++i) {
        const std::size_t columns = part.header.reference.size(), rows = part.header.response.size();
        const std::size_t r = frf::find_coordinate(set.header.response, part.header.response[i / columns % rows]);
        const std::size_t c = frf::find_coordinate(set.header.reference, part.header.reference[i % columns]);
        set.values[set.index(i / columns / rows, r, c)] = part.values[i];
      }
    }
  })(folder);
  folder.replace("A1.toml", "equations = [\"nn\", \"nj\"]\nweighting = \"WA\"", "equations = [\"nn\"]\ndelta = 0.05");
};

const Spoil one_line = scene("range = [400.0, 1000.0]", "range = [400.0, 401.0]");
const Spoil with_mass = scene("[identify]", "[joint.mass]\npattern = \"symmetric\"\n[identify]");
/// All FRFs of a part are zero: their matrix has no inverse.
const Spoil singular = both(scene("method = \"one\"\nequations = [\"nn\", \"nj\"]", "method = \"two\""),
                            every_value("A1_substructure_1.h5", 0.0));

const Unusable unusables[] = {
    {"AllNan", every_value("A1_assembly.h5", nan), "no_equations", {"No equation is left", "missing or zero", "`jointid info`"}, {}},
    {"AllZero",
     both(both(every_value("A1_assembly.h5", 0.0), every_value("A1_substructure_1.h5", 0.0)),
          every_value("A1_substructure_2.h5", 0.0)),
     "no_equations", {"No equation is left", "zero", "jointid info"}, {}},
    {"DeltaDropsEverything", no_joint_at_all, "no_equations", {"delta dropped them", "Lower delta"}, {}},
    {"OnlyZeroHzOfAnAccelerance", only_zero_hz, "no_equations", {"No equation is left", "Choose other lines"}, {}},
    {"SingularMatrixInMethodTwo", singular, "no_equations", {"No equation is left", "missing or zero", "`jointid info`"}, {}},
    {"OneLineForStiffnessAndMass", both(one_line, with_mass), "rank_deficient",
     {"do not fix 10 of 30 combinations", "move together", "Measure more coordinates or lines"}, {"K(1,1)", "M(1,1)"}},
    {"OneLineByNormalEquations",
     both(both(one_line, with_mass), scene("method = \"one\"", "method = \"one\"\nsolver = \"normal\"")), "rank_deficient",
     {"not positive definite", "use solver \"qr\""}, {}},
    {"OneLineBySparseQr",
     both(both(one_line, with_mass), scene("method = \"one\"", "method = \"one\"\nsolver = \"spqr\"")), "rank_deficient",
     {"do not fix 10 of 30 combinations", "move together"}, {"K(1,1)", "M(1,1)"}},
};
INSTANTIATE_TEST_SUITE_P(Numbers, UnusableNumbers, testing::ValuesIn(unusables),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace jointid::cli
