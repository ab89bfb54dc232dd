#pragma once

#include <complex>
#include <string>
#include <vector>

#include "ident/check/test/checked_file.hpp"

namespace jointid::ident {

/// One role of a channel: sensor (response) or hammer (reference).
enum class Role { response, reference };

struct MeasuredChannel {
  std::size_t file;
  Role role;
  frf::Dof dof;
};

const Dofs& dofs_of(const CheckedFile& file, Role role);
bool has_role(const CheckedFile& file, Role role, const frf::Dof& dof);

/// Nothing where the file, a group of references for example, does not have the channel.
void scale_channel(CheckedFile& file, Role role, const frf::Dof& dof, std::complex<double> factor);

/// "sensor", "hammer or shaker".
std::string channel_word(Role role);
/// The key of [data.files] for one of the two roles: "flip", "flip_reference".
std::string role_key(const char* key, Role role);

/// Channels that are looked at, each once.
struct MeasuredChannels {
  std::vector<MeasuredChannel> channels;

  /// Nothing where the file does not have it.
  void add(const std::vector<CheckedFile>& files, std::size_t file, Role role, const frf::Dof& dof);
};

}  // namespace jointid::ident
