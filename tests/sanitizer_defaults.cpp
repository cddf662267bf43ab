// Options of a sanitized build, compiled into its programs so that they hold however a program is started.

extern "C" {

const char* __asan_default_options();
const char* __ubsan_default_options();
const char* __lsan_default_options();
const char* __lsan_default_suppressions();

// The software device's compiler allocates by the million: short stacks and a small quarantine take an eighth off its
// time and half its memory.
const char* __asan_default_options() {
  return "malloc_context_size=4:quarantine_size_mb=16";
}

const char* __ubsan_default_options() {
  return "print_stacktrace=1";
}

const char* __lsan_default_options() {
  return "print_suppressions=0";
}

// The software device's compiler, the Vulkan loader and its validation layer keep memory until the process ends; none
// of it is ours to free.
const char* __lsan_default_suppressions() {
  return "leak:libLLVM\n"
         "leak:libvulkan_lvp\n"
         "leak:libvulkan.so\n"
         "leak:libVkLayer_khronos_validation\n";
}

}  // extern "C"
