// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/other_formats.h"

#include <dlfcn.h>

#include "core/installed.h"

namespace yorb {
namespace {

constexpr const char* kModule = "yorb_codecs.so";

Result<const OtherFormats*> Load() {
  const std::string needed = std::string("needs yorb's module for formats other than PNG and JPEG, ") + kModule;
  const auto file = InstalledModule(kModule);
  if (!file) return Failure(needed + ", which is not beside the program; install yorb anew, or convert to PNG");
  void* const module = ::dlopen(file->c_str(), RTLD_NOW | RTLD_LOCAL);  // never closed: its threads outlive us
  using Door = const OtherFormats* (*)();
  const auto door = module ? reinterpret_cast<Door>(::dlsym(module, "YorbOtherFormats")) : nullptr;
  if (door == nullptr) {
    const char* const reason = ::dlerror();
    return Failure(needed + ", which cannot be loaded: " + (reason ? reason : "it is of another version"));
  }
  return door();
}

}  // namespace

Result<const OtherFormats*> LoadOtherFormats() {
  static const Result<const OtherFormats*> loaded = Load();
  return loaded;
}

}  // namespace yorb
