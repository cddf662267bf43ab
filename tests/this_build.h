#pragma once
// What a test may ask of the build under test. A sanitized build links the plain build's tests to its own program code,
// so a test must ask at run time.

namespace airlight::test {

// Whether the code under test is compiled with sanitizers, which take several times as long.
bool sanitized();

}  // namespace airlight::test
