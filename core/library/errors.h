#pragma once
// Turns the program's errors into the library's, so that no other exception leaves it.

#include <exception>
#include <new>
#include <utility>

#include "core/base/error.h"
#include "core/library/api.h"

namespace airlight {

template <class Work>
auto translated(Work&& work) -> decltype(work()) {
  try {
    return std::forward<Work>(work)();
  } catch (const v0::InputError&) {
    throw;
  } catch (const v0::RunError&) {
    throw;
  } catch (const InputError& error) {
    throw v0::InputError(error.what());
  } catch (const RunError& error) {
    throw v0::RunError(error.what());
  } catch (const std::bad_alloc&) {
    throw v0::RunError("out of memory; ask for a smaller picture");
  } catch (const std::exception& error) {
    throw v0::RunError(std::string("a mistake in airlight, please report it: ") + error.what());
  }
}

}  // namespace airlight
