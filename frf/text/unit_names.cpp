#include "frf/text/unit_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "base/error.hpp"

namespace jointid::frf {
namespace {

struct NamedUnit {
  std::string_view names;  ///< separated by blanks; the first is shown in messages where `shown` says so
  Unit unit;
  bool shown = false;
};

constexpr double standard_gravity = 9.80665;     // m/s², exact by definition, as are
constexpr double inch = 0.0254, foot = 0.3048;   // m
constexpr double pound = 0.45359237;             // kg
constexpr double pound_force = 4.4482216152605;  // N
constexpr double turn = 2.0 * std::numbers::pi;

constexpr Unit length(double si) { return {si, 1, 0, 0}; }
constexpr Unit time(double si) { return {si, 0, 1, 0}; }
constexpr Unit force(double si) { return {si, 0, 0, 1}; }
constexpr Unit moment(double si) { return {si, 1, 0, 1}; }
constexpr Unit mass(double si) { return {si, -1, 2, 1}; }
constexpr Unit acceleration(double si) { return {si, 1, -2, 0}; }
constexpr Unit angle(double si) { return {si, 0, 0, 0, 1}; }
constexpr Unit turns(double per_second) { return {turn * per_second, 0, -1, 0, 1}; }
constexpr Unit amplitude(Amplitude kind) { return {1.0, 0, 0, 0, 0, kind}; }

constexpr std::array known_units = std::to_array<NamedUnit>({
    {"m meter meters metre metres", length(1.0), true},
    {"cm centimeter centimeters centimetre centimetres", length(1e-2), true},
    {"dm decimeter decimeters decimetre decimetres", length(1e-1)},
    {"mm millimeter millimeters millimetre millimetres", length(1e-3), true},
    {"um micron microns micrometer micrometers micrometre micrometres", length(1e-6), true},
    {"nm nanometer nanometers nanometre nanometres", length(1e-9), true},
    {"pm picometer picometers picometre picometres", length(1e-12)},
    {"in inch inches", length(inch), true},
    {"mil mils thou", length(2.54e-5), true},
    {"ft foot feet", length(foot), true},
    {"s sec secs second seconds", time(1.0), true},
    {"ss", {1.0, 0, 2, 0}},
    {"ms msec msecs millisec millisecs millisecond milliseconds", time(1e-3), true},
    {"us usec usecs microsec microsecs microsecond microseconds", time(1e-6), true},
    {"ns nsec nsecs nanosecond nanoseconds", time(1e-9)},
    {"min mins minute minutes", time(60.0), true},
    {"h hr hrs hour hours", time(3600.0)},
    {"N newton newtons", force(1.0), true},
    {"mN millinewton millinewtons", force(1e-3), true},
    {"uN micronewton micronewtons", force(1e-6)},
    {"nN nanonewton nanonewtons", force(1e-9)},
    {"daN decanewton decanewtons", force(10.0), true},
    {"kN kilonewton kilonewtons", force(1e3), true},
    {"MN meganewton meganewtons", force(1e6), true},
    {"dyn dyne dynes", force(1e-5), true},
    {"lbf lb lbs lbsf lbfs pound pounds poundforce", force(pound_force), true},
    {"kip kips kipf klb klbs klbf kilopound kilopounds", force(1e3 * pound_force), true},
    {"ozf oz ounce ounces", force(pound_force / 16), true},
    {"pdl poundal poundals", force(pound* foot)},
    {"kgf kp kilopond kiloponds kilogramforce", force(standard_gravity), true},
    {"gf pond ponds gramforce", force(1e-3 * standard_gravity)},
    {"tf", force(1e3 * standard_gravity)},
    {"Nm", moment(1.0), true},
    {"Ns Nsec", {1.0, 0, 1, 1}},
    {"kNm", moment(1e3)},
    {"Nmm", moment(1e-3)},
    {"Ncm", moment(1e-2)},
    {"inlb inlbs inlbf lbin lbfin", moment(inch* pound_force)},
    {"ftlb ftlbs ftlbf lbft lbfft", moment(foot* pound_force)},
    {"g G gn g_n g's G's gs gee gees grav gravity gravities gforce", acceleration(standard_gravity), true},
    {"mg mgn millig milligee milligees", acceleration(1e-3 * standard_gravity), true},
    {"ug ugn microg", acceleration(1e-6 * standard_gravity)},
    {"Gal Gals", acceleration(1e-2)},
    {"mGal mGals", acceleration(1e-5)},
    {"ips", {inch, 1, -1, 0}, true},
    {"kg kilogram kilograms", mass(1.0), true},
    {"gram grams", mass(1e-3)},
    {"tonne tonnes", mass(1e3)},
    {"lbm", mass(pound)},
    {"slug slugs", mass(pound_force / foot)},
    {"rad rads radian radians rd", angle(1.0), true},
    {"mrad mrads milliradian milliradians", angle(1e-3), true},
    {"urad urads microradian microradians", angle(1e-6)},
    {"krad", angle(1e3)},
    {"deg degs degree degrees", angle(std::numbers::pi / 180.0), true},
    {"rev revs revolution revolutions turn turns cycle cycles cyc", angle(turn)},
    {"Hz hertz cps", turns(1.0)},
    {"mHz millihertz", turns(1e-3)},
    {"kHz kilohertz", turns(1e3)},
    {"MHz megahertz", turns(1e6)},
    {"GHz gigahertz", turns(1e9)},
    {"rps", turns(1.0)},
    {"rpm cpm", turns(1.0 / 60.0)},
    {"krpm kcpm", turns(1000.0 / 60.0)},
    {"rms eff", amplitude(Amplitude::rms)},
    {"pk peak", amplitude(Amplitude::peak)},
    {"pp pkpk ptp", amplitude(Amplitude::peak_to_peak)},
});

/// Words that stand where a unit should, and what they are.
constexpr std::array foreign_words = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"v mv uv kv volt volts millivolt millivolts vrms vpk vp vpp dbv", "a voltage"},
    {"c pc nc coulomb coulombs picocoulomb", "an electric charge"},
    {"a ma ua amp amps ampere amperes", "an electric current"},
    {"count counts cnt cnts digit digits bit bits lsb adc raw", "the reading of a converter"},
    {"eu engineeringunits user", "engineering units without a name"},
    {"db", "a level in decibels"},
    {"pct percent", "a share"},
    {"pa upa mpa hpa kpa gpa pascal pascals bar mbar psi atm", "a pressure"},
    {"ue ustrain strain microstrain strains microstrains", "a strain"},
    {"k degc degf celsius kelvin", "a temperature"},
    {"tonf tonsf ton tons", "2000 lbf, 2240 lbf or 1000 kgf"},
    {"fps", "feet per second or frames per second"},
    {"r u", "a radian or a revolution"},
});

/// Calls `use(name)` for every word of a list that blanks separate.
template <class Use>
void for_each_word(std::string_view list, Use use) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    use(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
}

struct Match {
  std::string_view name;
  const Unit* unit = nullptr;
};

using Matches = std::unordered_map<std::string, std::vector<Match>>;

/// The names of all units by their letters in lower case.
Matches by_letters() {
  Matches all;
  for (const NamedUnit& each : known_units) {
    for_each_word(each.names, [&](std::string_view name) { all[lower_case(name)].push_back({name, &each.unit}); });
  }
  return all;
}

const std::vector<Match>& matches(std::string_view word) {
  static const Matches all = by_letters();
  static const std::vector<Match> none;
  const auto found = all.find(lower_case(word));
  return found != all.end() ? found->second : none;
}

bool same(const Unit& a, const Unit& b) { return a.same_dimension(b) && a.si == b.si && a.amplitude == b.amplitude; }

bool is_in_capitals(std::string_view word) {
  return std::ranges::none_of(word, [](unsigned char c) { return std::islower(c) != 0; });
}

/// Milli by the table and mega as it is written, "Mm", "Mg", "Ms"; "GN" may be gn or giganewtons; nN is only written so. Capitals
/// alone are lost case.
bool has_other_prefix(std::string_view word, std::string_view name) {
  constexpr auto milli = std::to_array<std::string_view>({"mm", "mg", "mgn", "ms", "mrad", "mrads", "mGal", "mGals"});
  const bool mega = word.starts_with('M') && !is_in_capitals(word) && std::ranges::find(milli, name) != milli.end();
  const bool newton_first = name == "nN" || name == "pN";  // "Nn", "NN"
  return mega || newton_first || (word == "GN" && name == "gn");
}

/// "grms", "N_pk": the unit before a word of amplitudes.
UnitWord without_amplitude(std::string_view word) {
  for (const std::string_view ending : {"rms", "pkpk", "peak", "pk", "pp", "eff"}) {
    if (word.size() <= ending.size() || lower_case(word.substr(word.size() - ending.size())) != ending) continue;
    std::string_view stem = word.substr(0, word.size() - ending.size());
    if (stem.ends_with('_') && stem.size() > 1) stem.remove_suffix(1);
    UnitWord found = find_unit(stem);
    if (!found.unit || found.unit->amplitude != Amplitude::unstated) continue;
    found.unit->amplitude = matches(ending).front().unit->amplitude;
    return found;
  }
  return {};
}

}  // namespace

UnitWord find_unit(std::string_view word) {
  static const std::vector<Match> none;
  const bool function = word == "H";  // an FRF, "Re(H)", and no hour
  const std::vector<Match>& found = function ? none : matches(word);
  if (found.empty()) return without_amplitude(word);
  const auto exact = std::ranges::find(found, word, &Match::name);
  const Match& first = exact != found.end() ? *exact : found.front();
  UnitWord read{*first.unit, exact == found.end() && is_in_capitals(word), {}};
  for (const Match& each : found) {
    if (!same(*each.unit, *first.unit)) read.otherwise.emplace_back(each.name);
  }
  if (exact == found.end() && has_other_prefix(word, first.name)) read.otherwise = {std::string(word)};
  if (exact == found.end() && !read.otherwise.empty()) {
    read.unit.reset();
    read.otherwise.insert(read.otherwise.begin(), std::string(first.name));
  }
  return read;
}

std::string_view not_a_unit(std::string_view word) {
  const std::string lower = lower_case(word);
  std::string_view what;
  for (const auto& [words, meaning] : foreign_words) {
    for_each_word(words, [&, meaning = meaning](std::string_view each) {
      if (each == lower) what = meaning;
    });
  }
  return what;
}

std::string near_unit(std::string_view word) {
  const std::string lower = lower_case(word);
  std::string best;
  std::size_t nearest = word.size() / 3 + 1;
  if (word.size() < 3 || word.size() > 20) return best;
  for (const NamedUnit& each : known_units) {
    for_each_word(each.names, [&](std::string_view name) {
      const std::size_t distance = name.size() < 3 ? nearest : edit_distance(lower, lower_case(name));
      if (distance >= nearest) return;
      nearest = distance;
      best = name;
    });
  }
  return best;
}

std::string unit_names() {
  std::string all;
  for (const NamedUnit& each : known_units) {
    if (each.shown) all += (all.empty() ? "" : " ") + std::string(each.names.substr(0, each.names.find(' ')));
  }
  return all;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

}  // namespace jointid::frf
