#include "frf/npy/npz_archive.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "base/error.hpp"
#include "frf/mat/mat_module.hpp"

namespace jointid::frf {
namespace {

constexpr std::string_view end_mark = "PK\x05\x06", end64_mark = "PK\x06\x06", locator_mark = "PK\x06\x07",
                           entry_mark = "PK\x01\x02", local_mark = "PK\x03\x04";
constexpr std::uint64_t end_size = 22, locator_size = 20, entry_size = 46, local_size = 30, longest_comment = 65535;
constexpr std::uint64_t no_size = 0xFFFFFFFF, no_count = 0xFFFF, most_entries = 10'000;
/// Deflate packs at best 1032 bytes into one.
constexpr std::uint64_t best_compression = 1100;

[[noreturn]] void fail(const std::string& file, const std::string& place, std::string problem,
                       std::string remedy = "copy or save the file again") {
  throw InputError(
      {.kind = ErrorKind::data, .file = file, .place = place, .problem = std::move(problem), .remedy = std::move(remedy)});
}

/// Bytes of the archive by their place.
class Archive {
 public:
  Archive(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  std::string_view part(std::uint64_t at, std::uint64_t size) const {
    if (at > bytes_.size() || size > bytes_.size() - at)
      fail(file_, {}, "is damaged or cut off: the archive goes beyond its end");
    return bytes_.substr(at, size);
  }
  std::uint64_t number(std::uint64_t at, std::size_t width) const {
    const std::string_view text = part(at, width);
    std::uint64_t value = 0;
    for (std::size_t i = width; i-- > 0;) value = 256 * value + static_cast<unsigned char>(text[i]);
    return value;
  }
  bool has(std::uint64_t at, std::string_view mark) const { return at <= bytes_.size() && bytes_.substr(at).starts_with(mark); }
  std::uint64_t size() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
  const std::string& file_;
};

struct Directory {
  std::uint64_t entries = 0, begin = 0;
};

Directory directory_of(const Archive& archive, const std::string& file) {
  std::uint64_t at = archive.size() < end_size ? 0 : archive.size() - end_size;
  const std::uint64_t last = at < longest_comment ? 0 : at - longest_comment;
  while (at > last && !archive.has(at, end_mark)) --at;
  if (!archive.has(at, end_mark)) fail(file, {}, "is a zip archive without its end: cut off, or still being written");
  Directory directory{archive.number(at + 10, 2), archive.number(at + 16, 4)};
  const bool wide = directory.entries == no_count || directory.begin == no_size;
  if (wide && at >= locator_size && archive.has(at - locator_size, locator_mark)) {
    const std::uint64_t end64 = archive.number(at - locator_size + 8, 8);
    if (!archive.has(end64, end64_mark)) fail(file, {}, "is damaged: the archive's end is not where its directory states");
    directory = {archive.number(end64 + 32, 8), archive.number(end64 + 48, 8)};
  }
  if (directory.entries > most_entries) fail(file, {}, "declares " + std::to_string(directory.entries) + " arrays");
  return directory;
}

/// Sizes and place of an entry, where they do not fit into 32 bits in the field of type 1 behind its name.
void read_wide(const Archive& archive, std::uint64_t at, std::uint64_t size, const std::array<std::uint64_t*, 3>& values) {
  const std::uint64_t end = at + size;
  while (at + 4 <= end) {
    const std::uint64_t type = archive.number(at, 2), length = archive.number(at + 2, 2);
    std::uint64_t field = at + 4;
    at = field + length;
    if (type != 1) continue;
    for (std::uint64_t* value : values) {
      if (*value != no_size || field + 8 > at) continue;
      *value = archive.number(field, 8);
      field += 8;
    }
  }
}

NpzEntry read_entry(const Archive& archive, std::uint64_t at, const std::string& file) {
  NpzEntry entry;
  const std::uint64_t flags = archive.number(at + 8, 2), method = archive.number(at + 10, 2),
                      name_size = archive.number(at + 28, 2);
  entry.checksum = static_cast<std::uint32_t>(archive.number(at + 16, 4));
  std::uint64_t packed = archive.number(at + 20, 4), local = archive.number(at + 42, 4);
  entry.size = archive.number(at + 24, 4);
  entry.name = archive.part(at + entry_size, name_size);
  read_wide(archive, at + entry_size + name_size, archive.number(at + 30, 2), {&entry.size, &packed, &local});
  if ((flags & 1U) != 0) fail(file, entry.name, "is encrypted", "save it with numpy.savez()");
  if (method != 0 && method != 8)
    fail(file, entry.name, "is packed by method " + std::to_string(method), "save it with numpy.savez()");
  if (!archive.has(local, local_mark)) fail(file, entry.name, "is damaged: it is not where the archive states");
  entry.deflated = method == 8;
  entry.stored = archive.part(local + local_size + archive.number(local + 26, 2) + archive.number(local + 28, 2), packed);
  const bool right = entry.deflated ? entry.size / best_compression <= packed : entry.size == packed;
  if (!right)
    fail(file, entry.name, "is damaged: declares " + std::to_string(entry.size) + " bytes and stores " + std::to_string(packed));
  return entry;
}

std::uint32_t checksum_of(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> all{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t value = i;
      for (int bit = 0; bit < 8; ++bit) value = (value >> 1U) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
      all[i] = value;
    }
    return all;
  }();
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char byte : bytes) sum = table[(sum ^ static_cast<unsigned char>(byte)) & 0xFFU] ^ (sum >> 8U);
  return ~sum;
}

}  // namespace

std::vector<NpzEntry> npz_entries(std::string_view bytes, const std::string& file) {
  const Archive archive(bytes, file);
  const Directory directory = directory_of(archive, file);
  std::vector<NpzEntry> entries;
  std::uint64_t at = directory.begin;
  for (std::uint64_t i = 0; i < directory.entries; ++i) {
    if (!archive.has(at, entry_mark)) fail(file, {}, "is damaged: the archive lists fewer arrays than it declares");
    entries.push_back(read_entry(archive, at, file));
    at += entry_size + archive.number(at + 28, 2) + archive.number(at + 30, 2) + archive.number(at + 32, 2);
  }
  return entries;
}

std::string npz_bytes(const NpzEntry& entry, std::uint64_t most, const std::string& file) {
  most = std::min(most, entry.size);
  if (!entry.deflated) return std::string(entry.stored.substr(0, most));
  std::string out(most, '\0');
  std::size_t count = 0;
  try {
    count = matio_module(file).inflate(entry.stored, std::span(out));
  } catch (const InputError& error) {
    if (!error.parts().file.empty()) throw;
    fail(file, entry.name, "is damaged: " + error.parts().problem);
  }
  out.resize(count);
  return out;
}

std::string npz_bytes(const NpzEntry& entry, const std::string& file) {
  std::string out = npz_bytes(entry, entry.size, file);
  if (out.size() != entry.size)
    fail(file, entry.name,
         "is damaged: declares " + std::to_string(entry.size) + " bytes and holds " + std::to_string(out.size()));
  if (checksum_of(out) != entry.checksum) fail(file, entry.name, "is damaged: its checksum is another");
  return out;
}

}  // namespace jointid::frf
