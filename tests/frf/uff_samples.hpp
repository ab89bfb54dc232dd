#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <complex>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "tests/test_folder.hpp"

namespace jointid::frf::samples {

/// A file in the temporary folder with the given bytes; it goes with the object.
class TemporaryUff {
 public:
  explicit TemporaryUff(const std::string& bytes = {}) { std::ofstream(path_, std::ios::binary) << bytes; }

  const std::filesystem::path& path() const { return path_; }
  operator const std::filesystem::path&() const { return path_; }

 private:
  TestFolder folder_;
  std::filesystem::path path_ = folder_ / "sample.uff";
};

template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::string text(512, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), pattern, values...)));
  return text;
}

/// A dataset 58 or 58b by its fields; payload as given.
struct Record {
  int function_type = 4;
  std::int64_t response_node = 1;
  int response_direction = 3;
  std::int64_t reference_node = 1;
  int reference_direction = 3;
  std::string response_name = "NONE";
  int data_type = 6;
  long points = 3;
  int even = 1;
  double first = 10.0;
  double step = 1.0;
  int abscissa_type = 18;
  int numerator_type = 8;
  int denominator_type = 13;
  std::string abscissa_unit = "NONE";
  std::string numerator_unit = "NONE";
  std::string denominator_unit = "NONE";
  std::string id = "NONE";
  std::string data;  ///< text lines with their ends, or bytes
  bool binary = false;
  int byte_order = 1;
  int float_format = 2;
  long declared_bytes = 0;
  std::string before_close;  ///< line end between binary data and -1
  std::string close = "    -1\n";

  std::string str() const {
    std::string text = "    -1\n";
    text += binary ? format("    58b%6d%6d%12d%12ld     0     0           0           0\n", byte_order,
                            float_format, 11, declared_bytes)
                   : "    58\n";
    text += "NONE\n" + id + "\nNONE\nNONE\nNONE\n";
    text += format("%5d%10d%5d%10d %-10s%10ld%4d %-10s%10ld%4d\n", function_type, 0, 0, 0,
                   response_name.c_str(), static_cast<long>(response_node), response_direction, "NONE",
                   static_cast<long>(reference_node), reference_direction);
    text += format("%10d%10ld%10d%13.5E%13.5E%13.5E\n", data_type, points, even, first, step, 0.0);
    text += axis(abscissa_type, abscissa_unit) + axis(numerator_type, numerator_unit) +
            axis(denominator_type, denominator_unit) + axis(0, "NONE");
    return text + data + before_close + close;
  }

 private:
  static std::string axis(int type, const std::string& unit) {
    return format("%10d%5d%5d%5d %-20s %-20s\n", type, 0, 0, 0, "NONE", unit.c_str());
  }
};

/// A complex double text record with the values (k + i)·(1, 0.5) at its lines i.
inline Record simple_record(double k = 1.0) {
  Record record;
  for (int i = 0; i < 3; ++i) {
    record.data += format("%20.12E%20.12E", k + i, 0.5 * (k + i));
    if (i == 1) record.data += "\n";
  }
  record.data += "\n";
  return record;
}

template <class T>
std::string bytes_of(const std::vector<T>& numbers, bool big_endian = false) {
  std::string bytes;
  for (const T number : numbers) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(number);
    if (big_endian) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
  }
  return bytes;
}

template <class T>
Record binary_record(int data_type, const std::vector<T>& numbers, bool big_endian = false) {
  Record record;
  record.binary = true;
  record.data_type = data_type;
  record.byte_order = big_endian ? 2 : 1;
  record.data = bytes_of(numbers, big_endian);
  record.declared_bytes = static_cast<long>(record.data.size());
  return record;
}

inline std::string units_164(double length, double force) {
  std::string text = format("%25.17E%25.17E%25.17E\n", length, force, 1.0);
  for (char& c : text) c = c == 'E' ? 'D' : c;
  return "    -1\n   164\n         9user                         2\n" + text + "    -1\n";
}

/// The message of the InputError that `act` throws; checks that it is one about data.
template <class Act>
std::string error_of(Act act) {
  try {
    act();
  } catch (const InputError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::data);
    return error.what();
  }
  ADD_FAILURE() << "no InputError was thrown";
  return {};
}

}  // namespace jointid::frf::samples
