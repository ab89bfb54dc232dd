#include "input_folder.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "frf/csv/csv_file.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "frf/set/frf_source.hpp"
#include "frf/uff/uff_file.hpp"
#include "problems/problem.hpp"

namespace jointid::cli {

InputFolder::InputFolder() {
  problems::write(problems::make("A1"), folder_, {});
  frf::write_hdf5(small_set(), path("a.h5"));
  frf::write_uff(small_set(), path("a.uff"), {.binary = false});
  frf::write_uff(small_set(), path("b.uff"), {.binary = true});
  frf::write_csv(small_set(), path("a.csv"));
  write("old.json", old_output);
}

std::string InputFolder::text(const std::string& name) const {
  std::ifstream in(path(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void InputFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name), std::ios::binary) << text;
}

void InputFolder::replace(const std::string& name, const std::string& from, const std::string& to) const {
  std::string all = text(name);
  const std::size_t at = all.find(from);
  if (at == std::string::npos) throw std::runtime_error(name + " has no '" + from + "' to spoil");
  write(name, all.replace(at, from.size(), to));
}

std::map<std::string, std::string> InputFolder::content() const {
  std::map<std::string, std::string> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    const std::string name = entry.path().lexically_relative(path()).string();
    if (entry.is_symlink()) all[name] = "link to " + std::filesystem::read_symlink(entry.path()).string();
    else if (entry.is_directory()) all[name] = "/";
    else all[name] = entry.is_regular_file() ? text(name) : "no file";
  }
  return all;
}

frf::FrfSet small_set() {
  frf::FrfSet set;
  set.header.frequency_hz = {10.0, 20.0, 30.0};
  set.header.response = {frf::Dof::parse("1:+Y"), frf::Dof::parse("2:+Y")};
  set.header.reference = {frf::Dof::parse("1:+Y")};
  for (int i = 0; i < 6; ++i) set.values.emplace_back(1.0 + i, -i);
  return set;
}

Spoil edit(std::string file, std::string from, std::string to) {
  return [=](const InputFolder& folder) { folder.replace(file, from, to); };
}

Spoil scene(std::string from, std::string to) { return edit("A1.toml", std::move(from), std::move(to)); }

Spoil with_set(std::string file, std::function<void(frf::FrfSet&)> change) {
  return [=](const InputFolder& folder) {
    frf::FrfSet set = frf::load(*frf::open(folder.path(file)));
    change(set);
    frf::write_hdf5(set, folder.path(file));
  };
}

Spoil cut(std::string file, std::size_t bytes) {
  return [=](const InputFolder& folder) { std::filesystem::resize_file(folder.path(file), bytes); };
}

Spoil both(Spoil first, Spoil second) {
  return [=](const InputFolder& folder) {
    first(folder);
    second(folder);
  };
}

}  // namespace jointid::cli
