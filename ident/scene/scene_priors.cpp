#include "ident/scene/scene_sections.hpp"

namespace jointid::ident {

std::vector<Prior> read_priors(const scene::Item& item) {
  std::vector<Prior> priors;
  const scene::Table table = item.open_table();
  for (const auto& [unknown, numbers] : table.members()) {
    const std::vector<scene::Item> pair = numbers.list();
    if (pair.size() != 2) {
      numbers.fail("a prior is a value and its standard deviation, found " + std::to_string(pair.size()) + " numbers",
                   "write \"K(1,1)\" = [6.6e5, 1e4]");
    }
    priors.push_back({unknown, pair[0].number(), pair[1].positive()});
  }
  return priors;
}

namespace {

std::uint64_t whole(const scene::Item& item) {
  const double value = item.not_negative();
  if (value > 9007199254740992.0) item.fail(scene::number_text(value) + " is above 2^53");
  if (value != static_cast<double>(static_cast<std::uint64_t>(value))) item.fail(scene::number_text(value) + " is no whole number");
  return static_cast<std::uint64_t>(value);
}

}  // namespace

std::size_t read_starts(const scene::Item& item) {
  constexpr std::size_t most = 10000;
  const std::uint64_t starts = whole(item);
  if (starts > most) item.fail("more than 10000 starts", "20 to 200 are usual");
  return starts;
}

void read_bootstrap(const scene::Table& table, IdentifySection& identify) {
  constexpr std::size_t fewest = 100, most = 100000;
  if (const auto count = table.find("bootstrap")) {
    if (count->not_negative() > static_cast<double>(most)) count->fail("more than 100000 replicates", "200 to 1000 are usual");
    identify.bootstrap = whole(*count);
    if (identify.bootstrap > 0 && identify.bootstrap < fewest) {
      count->fail(std::to_string(identify.bootstrap) + " replicates give no 95 % interval", "use 100 or more, or 0 for none");
    }
  }
  const auto seed = table.find("bootstrap_seed");
  if (!seed) return;
  if (identify.bootstrap == 0) seed->fail("bootstrap_seed is given without bootstrap", "give bootstrap = 200, too");
  identify.bootstrap_seed = whole(*seed);
}

}  // namespace jointid::ident
