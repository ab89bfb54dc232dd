#include <algorithm>

#include "friction/law/laws.hpp"
#include "laws/scene/sections.hpp"

namespace jointid::laws {
namespace {

/// Tried where the scene names none: a law for each of stick and slip at once, rounded, with a tail, spread over many sliders.
const std::vector<std::string> usual_laws = {"bilinear", "shoukry", "ren", "iwan"};
const std::vector<std::string> beside_words = {"stiffness", "damping", "cubic"};

std::vector<std::string> read_laws(const scene::Item& item) {
  std::vector<std::string> laws;
  for (const scene::Item& each : item.is_list() ? item.list_not_empty() : std::vector<scene::Item>{item}) {
    const std::string word = each.text_not_empty();
    each.here([&] { (void)friction::law_to_fit(word); });
    if (std::ranges::find(laws, word) != laws.end()) each.fail("law " + word + " is named twice", "name it once");
    laws.push_back(word);
  }
  return laws;
}

/// Reads one joint and what constrains it.
class JointReader {
 public:
  JointReader(const scene::Item& item, LawScene& scene)
      : item_(item),
        table_(item.table({"name", "dofs", "law", "same_as", "stiffness", "damping", "cubic", "unknown", "bounds", "priors", "assumed"})),
        scene_(scene) {}

  void read() {
    read_ends();
    read_law();
    read_beside();
    read_assumed();
    const std::size_t place = scene_.joints.size();
    scene_.joints.push_back(joint_);
    scene_.constraints.tied_to.push_back(leader_);
    scene_.constraints.beside.push_back(unknown_);
    read_rules(place);
  }

 private:
  void read_ends() {
    const scene::Item ends = table_.require("dofs");
    const std::vector<frf::Dof> dofs = ends.dofs();
    if (dofs.size() > 2) ends.fail("a joint has one end or two", "give each relative coordinate a joint of its own");
    joint_.positive = dofs[0];
    if (dofs.size() == 2) joint_.negative = dofs[1];
    joint_.beside.name = joint_.positive.name() + "–" + (joint_.negative ? joint_.negative->name() : "ground");
    const auto name = table_.find("name");
    if (name) joint_.beside.name = name->text_not_empty();
    for (const FrictionJoint& other : scene_.joints) {
      if (other.beside.name != joint_.beside.name) continue;
      (name ? *name : ends).fail("there are two joints " + joint_.beside.name, "give each a name of its own");
    }
  }

  void read_law() {
    const auto law = table_.find("law"), same = table_.find("same_as");
    if (law && same) item_.fail("there are both law and same_as", "remove one");
    if (!same) {
      joint_.laws = law ? read_laws(*law) : usual_laws;
      return;
    }
    std::vector<std::string> names;
    for (const FrictionJoint& other : scene_.joints) names.push_back(other.beside.name);
    const std::string name = same->text_not_empty();
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) {
      const std::string near = nearest_word(name, names);
      same->fail("there is no joint '" + name + "' before this one",
                 near.empty() ? "name it, and put it first" : "did you mean " + near + "?");
    }
    leader_ = static_cast<std::size_t>(found - names.begin());
    if (const auto further = scene_.constraints.tied_to[*leader_]) leader_ = further;
    joint_.laws = scene_.joints[*leader_].laws;
  }

  void read_beside() {
    if (const auto stiffness = table_.find("stiffness")) joint_.beside.stiffness = stiffness->number();
    if (const auto damping = table_.find("damping")) joint_.beside.damping = damping->not_negative();
    if (const auto cubic = table_.find("cubic")) joint_.beside.cubic = cubic->number();
    const auto unknown = table_.find("unknown");
    if (!unknown) return;
    for (const scene::Item& word : unknown->list_not_empty()) {
      unknown_.push_back(word.word(beside_words));
      if (std::ranges::count(unknown_, unknown_.back()) > 1) word.fail("it is named twice", "name it once");
      const auto start = table_.find(unknown_.back());
      if (start && !(start->number() > 0.0))
        start->fail("an unknown " + unknown_.back() + " begins above 0", "remove it, or give a guess");
      if (!start && unknown_.back() == "cubic") word.fail("where does the cubic spring begin?", "give cubic, a guess in N/m³");
    }
  }

  void read_assumed() {
    const auto assumed = table_.find("assumed");
    if (!assumed) return;
    if (leader_) assumed->fail("the joint has the law of " + scene_.joints[*leader_].beside.name, "give it there");
    const auto law = assumed->open_table().find("law");
    if (!law && joint_.laws.size() != 1)
      assumed->fail("parameters of which of several laws?",
                    "name one law, or the one that is assumed: { law = \"" + joint_.laws.front() + "\", … }");
    joint_.assumed_law = law ? law->word(joint_.laws) : joint_.laws.front();
    std::vector<std::string> names;
    for (const friction::LawParameter& parameter : friction::law(joint_.assumed_law).parameters)
      names.emplace_back(parameter.name);
    std::vector<std::string> keys = names;
    keys.emplace_back("law");
    const scene::Table values = assumed->table(keys);
    for (const std::string& name : names) joint_.assumed.push_back(values.require(name).number());
    assumed->here([&] { return friction::make_element(joint_.assumed_law, joint_.assumed); });
  }

  /// Names that some law of the joint, or what is unknown beside it, has.
  std::vector<std::string> parameter_names() const {
    std::vector<std::string> names = unknown_;
    for (const std::string& law : joint_.laws) {
      for (const friction::LawParameter& parameter : friction::law(law).parameters) {
        const std::string name(parameter.name);
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
      }
    }
    return names;
  }

  void read_rules(std::size_t place) {
    const auto bounds = table_.find("bounds"), priors = table_.find("priors");
    for (const auto& rules : {bounds, priors}) {
      if (!rules) continue;
      if (leader_) rules->fail("the joint has the law of " + scene_.joints[*leader_].beside.name, "give it there");
      (void)rules->table(parameter_names());
    }
    if (bounds) {
      for (const ident::Bound& each : ident::read_bounds(*bounds))
        scene_.constraints.rules.push_back({place, each.unknown, {{each.lower, each.upper}}, {}});
    }
    if (priors) {
      for (const ident::Prior& each : ident::read_priors(*priors))
        scene_.constraints.rules.push_back({place, each.unknown, {}, {{each.value, each.deviation}}});
    }
  }

  const scene::Item& item_;
  scene::Table table_;
  LawScene& scene_;
  FrictionJoint joint_;
  std::optional<std::size_t> leader_;
  std::vector<std::string> unknown_;
};

}  // namespace

void read_friction_joints(const scene::Item& item, LawScene& scene) {
  for (const scene::Item& each : item.list_not_empty()) JointReader(each, scene).read();
  std::size_t choices = 1;
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    if (!scene.constraints.tied_to[j]) choices *= scene.joints[j].laws.size();
  }
  constexpr std::size_t most = 64;
  if (choices > most) {
    item.fail(std::to_string(choices) + " combinations of laws, at most " + std::to_string(most) + " are tried",
              "name fewer laws, or tie joints by same_as");
  }
}

}  // namespace jointid::laws
