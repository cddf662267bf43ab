#pragma once

namespace airlight {

// The OCIO config used when the user names none: built-in transforms only, no files.
extern const char* const kEmbeddedConfig;

}  // namespace airlight
