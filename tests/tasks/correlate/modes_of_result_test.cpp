#include "tasks/correlate/modes_of_result.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "tasks/correlate/compared_files.hpp"
#include "tests/models/model_sample.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Complex = std::complex<double>;

constexpr const char* fitted = R"({"status": "ok", "model": {"damping": "hysteretic", "real_modes": false}, "dofs": ["1:+Y", "2:-RZ"],
 "modes": [{"frequency_hz": 51.25, "damping": 0.03, "shape": [[1.0, 0.0], [0.5, -0.25]]},
           {"frequency_hz": 141.5, "damping": 0.02, "shape": [[1.0, 0.125], [-2.0, 0.0]]}]})";

class ModesOfResult : public testing::Test {
 protected:
  std::vector<frf::Uff55Mode> read(const std::string& text) const {
    models::write_text(folder_ / "fit.json", text);
    return read_modes(folder_ / "fit.json").modes;
  }
  std::string error(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
  static std::string with(const std::string& old, const std::string& instead) {
    std::string text = fitted;
    return text.replace(text.find(old), old.size(), instead);
  }

  TestFolder folder_;
};

TEST_F(ModesOfResult, AreThoseThatModalfitWrote) {
  const std::vector<frf::Uff55Mode> modes = read(fitted);
  ASSERT_EQ(modes.size(), 2U);
  EXPECT_EQ(modes[1].number, 2);
  EXPECT_TRUE(modes[0].is_complex);
  EXPECT_EQ(modes[0].frequency_hz, 51.25);
  EXPECT_EQ(modes[0].hysteretic_damping, 0.03);
  EXPECT_THAT(frf::names(modes[0].dofs), ElementsAre("1:+Y", "2:-RZ"));
  EXPECT_THAT(modes[0].shape, ElementsAre(Complex(1.0), Complex(0.5, -0.25)));
}

TEST_F(ModesOfResult, NameTheKeyThatIsWrong) {
  EXPECT_THAT(error("{"), HasSubstr("no JSON"));
  EXPECT_THAT(error("{\"status\": \"ok\"}"), HasSubstr("key model"));
  EXPECT_THAT(error(with("\"1:+Y\", ", "")), HasSubstr("2 values for 1 DOFs"));
  EXPECT_THAT(error(with("[0.5, -0.25]", "0.5")), HasSubstr("key shape"));
  EXPECT_THAT(error(with("51.25", "null")), HasSubstr("key frequency_hz"));
  EXPECT_THAT(error(with("\"modes\"", "\"others\"")), HasSubstr("key modes"));
}

}  // namespace
}  // namespace jointid::tasks
