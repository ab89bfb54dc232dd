#include "cli/text/failure.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "base/error.hpp"
#include "ident/identify.hpp"

namespace jointid::cli {
namespace {

using testing::HasSubstr;

template <class Exception>
Failure of(Exception exception) {
  return explain(std::make_exception_ptr(exception));
}

TEST(Failure, InputErrorsKeepTheirMessageAndChooseTheCode) {
  const Failure usage = of(InputError({ErrorKind::usage, "a.toml", "line 3", "no DOF", "add one"}));
  EXPECT_EQ(usage.code, ExitCode::usage);
  EXPECT_EQ(usage.line, "a.toml: line 3: no DOF; add one");
  EXPECT_EQ(of(InputError({ErrorKind::data, "a.uff", "", "cut short", ""})).code, ExitCode::data);
}

TEST(Failure, TheLineIsOneLine) {
  EXPECT_EQ(of(InputError({ErrorKind::usage, "", "", "two\nlines", ""})).line, "two\\nlines");
}

TEST(Failure, LackOfMemoryNamesARemedy) {
  EXPECT_EQ(of(std::bad_alloc()).code, ExitCode::data);
  EXPECT_THAT(of(std::bad_alloc()).line, HasSubstr("fewer lines"));
}

TEST(Failure, FileSystemErrorsNameTheFile) {
  const std::filesystem::filesystem_error error("cannot make", "/no/dir", std::make_error_code(std::errc::permission_denied));
  EXPECT_EQ(of(error).code, ExitCode::data);
  EXPECT_THAT(of(error).line, HasSubstr("/no/dir: "));
}

TEST(Failure, AnInterruptionHasItsOwnCode) { EXPECT_EQ(of(Interrupted()).code, ExitCode::interrupted); }

TEST(Failure, AnythingElseIsABug) {
  EXPECT_EQ(of(std::logic_error("index")).code, ExitCode::bug);
  EXPECT_THAT(of(std::logic_error("index")).line, HasSubstr("report"));
  EXPECT_EQ(of(42).code, ExitCode::bug);
}

}  // namespace
}  // namespace jointid::cli
