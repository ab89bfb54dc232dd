#include "cli/resume/kept_state.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "base/error.hpp"
#include "base/temporary_file.hpp"
#include "cli/provenance/digest.hpp"
#include "frf/hdf5/record_journal.hpp"
#include "scene/kind.hpp"

namespace jointid::cli {
namespace {

using Json = nlohmann::json;

constexpr std::string_view magic = "jointid-state 1\n";

std::string fnv(std::string_view bytes) { return fmt::format("{:016x}", frf::checksum(std::as_bytes(std::span(bytes)))); }

std::string text_of(const std::filesystem::path& file) {
  require_regular_file(file);
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string sum_of(const std::filesystem::path& file) {
  if (auto sum = sha256_of(file)) return *sum;
  return fnv(text_of(file));
}

[[noreturn]] void fail(ErrorKind kind, const std::filesystem::path& file, const std::string& problem) {
  throw InputError({kind, file.string(), "--resume", problem, "repeat the run as it was, or remove the file to start anew"});
}

}  // namespace

KeptState::KeptState(std::filesystem::path file, std::string command, std::string scene_text, std::vector<ident::NamedFile> inputs)
    : file_(std::move(file)), command_(std::move(command)), scene_text_(std::move(scene_text)), inputs_(std::move(inputs)) {}

const std::string& KeptState::scene_sum() {
  if (scene_sum_.empty()) {
    const std::string contents = scene::contents_of(scene_text_, inputs_.empty() ? "the scene" : inputs_.front().path);
    scene_sum_ = sha256_of_text(contents).value_or(fnv(contents));
  }
  return scene_sum_;
}

const std::vector<KeptState::Sum>& KeptState::sums() {
  for (std::size_t i = sums_.size() + 1; i < inputs_.size(); ++i) sums_.push_back({inputs_[i].path.string(), sum_of(inputs_[i].path)});
  return sums_;
}

std::vector<std::string> KeptState::others(const std::string& header) try {
  const Json told = Json::parse(header);
  std::vector<std::string> out;
  if (told.at("command") != command_) out.emplace_back("command");
  if (told.at("version") != JOINTID_VERSION) out.emplace_back("version of jointid");
  if (told.at("scene") != scene_sum()) out.emplace_back("scene");
  const Json& inputs = told.at("inputs");
  for (std::size_t i = 0; i < sums().size(); ++i) {
    if (i >= inputs.size() || inputs[i].at("sha256") != sums()[i].sum) out.push_back("content of " + sums()[i].file);
  }
  return out;
} catch (const Json::exception&) {
  fail(ErrorKind::data, file_, "is damaged");
}

std::optional<std::string> KeptState::read() {
  std::error_code unknown;
  if (!std::filesystem::exists(file_, unknown)) return std::nullopt;
  const std::string text = text_of(file_);
  if (!text.starts_with(magic)) fail(ErrorKind::data, file_, "is no state of an interrupted run");
  const std::size_t end = text.find('\n', magic.size());
  if (end == std::string::npos) fail(ErrorKind::data, file_, "is cut short");
  const std::string header = text.substr(magic.size(), end - magic.size());
  if (const auto differ = others(header); !differ.empty()) fail(ErrorKind::usage, file_, "it belongs to " + frf::named_others(differ));
  std::string state = text.substr(end + 1);
  const Json told = Json::parse(header);
  if (told.value("bytes", std::size_t{0}) != state.size()) fail(ErrorKind::data, file_, "is cut short");
  if (told.value("checksum", std::string()) != fnv(state)) fail(ErrorKind::data, file_, "is damaged");
  is_own_ = true;
  return state;
}

void KeptState::put(const std::string& state) {
  Json inputs = Json::array();
  for (const Sum& each : sums()) inputs.push_back({{"file", each.file}, {"sha256", each.sum}});
  const Json header = {{"command", command_},  {"version", JOINTID_VERSION}, {"scene", scene_sum()}, {"inputs", inputs},
                       {"bytes", state.size()}, {"checksum", fnv(state)}};
  write_text(file_, std::string(magic) + header.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n" + state);
  is_own_ = true;
}

std::string KeptState::why_not_put(const std::string& state) try {
  put(state);
  return "";
} catch (const InputError& error) {
  return error.what();
}

void KeptState::remove() {
  std::error_code ignored;
  if (is_own_) std::filesystem::remove(file_, ignored);
}

}  // namespace jointid::cli
