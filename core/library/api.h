#pragma once
// The installed header as the library's own sources see it: its names only as v0::NAME, since the program has some of
// the same names.

#define AIRLIGHT_INLINE_NAMESPACE
#include <airlight/airlight.h>
