#include "cli/text/failure.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <new>
#include <system_error>

#include "base/error.hpp"
#include "ident/result/control.hpp"

namespace jointid::cli {
namespace {

const std::string bug = "this is a bug, please report it with the command and the files";

Failure classify(const std::exception_ptr& exception) {
  try {
    std::rethrow_exception(exception);
  } catch (const InputError& error) {
    return {error.kind() == ErrorKind::usage ? ExitCode::usage : ExitCode::data, error.what()};
  } catch (const Interrupted& interrupted) {
    return {ExitCode::interrupted, interrupted.what()};
  } catch (const std::bad_alloc&) {
    return {ExitCode::data,
            "not enough memory; use fewer lines ([frequency] range, step) or fewer DOFs, or convert large files to HDF5, "
            "which is read line by line"};
  } catch (const std::filesystem::filesystem_error& error) {
    return {ExitCode::data, error.path1().string() + ": " + error.code().message()};
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again)
      return {ExitCode::data,
              "not enough memory for a further thread; give --threads 1, or raise the limits of memory and processes (ulimit)"};
    return {ExitCode::bug, bug + ": " + error.what()};
  } catch (const std::exception& error) {
    return {ExitCode::bug, bug + ": " + error.what()};
  } catch (...) {
    return {ExitCode::bug, bug};
  }
}

}  // namespace

Failure explain(const std::exception_ptr& exception) {
  Failure failure = classify(exception);
  std::ranges::replace(failure.line, '\n', ' ');
  return failure;
}

void print_error(const std::string& line) { std::cerr << "jointid: error: " << line << '\n'; }

void print_warning(const std::string& line) { std::cerr << "jointid: warning: " << line << '\n'; }

}  // namespace jointid::cli
