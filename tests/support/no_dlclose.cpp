// For programs under the address sanitizer that draw. The Vulkan driver is unloaded before leaks are looked
// for, and what it has left behind then has no module that a suppression could name. Unloading nothing keeps
// the names.

extern "C" int dlclose(void*) {
  return 0;
}
