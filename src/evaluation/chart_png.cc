// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/chart_png.h"

#include <dlfcn.h>

#include <cmath>
#include <cstddef>
#include <string_view>

#include "core/text.h"

namespace yorb {
namespace {

// librsvg and what it needs (two dozen libraries) would slow down every start of the program for the sake of a rare
// picture, so it is loaded when the first PNG is asked for. These are the functions used, as librsvg 2.46 and newer,
// cairo and GObject declare them; the first library brings the others.
constexpr const char* kLibrary = "librsvg-2.so.2";

struct Rectangle {
  double x, y, width, height;
};
using WriteFunction = int (*)(void* closure, const unsigned char* data, unsigned int length);

struct Functions {
  void* (*read_svg)(const unsigned char* data, size_t size, void** error) = nullptr;
  int (*render)(void* svg, void* context, const Rectangle* viewport, void** error) = nullptr;
  void (*unref)(void* object) = nullptr;
  void* (*make_surface)(int format, int width, int height) = nullptr;
  void (*destroy_surface)(void* surface) = nullptr;
  int (*write_png)(void* surface, WriteFunction write, void* closure) = nullptr;
  void* (*make_context)(void* surface) = nullptr;
  void (*destroy_context)(void* context) = nullptr;
};

constexpr int kRgb24 = 1;    // CAIRO_FORMAT_RGB24: the drawing has a ground of its own
constexpr int kSuccess = 0;  // CAIRO_STATUS_SUCCESS
constexpr double kLargest_px = 20000;

template <typename Function>
bool Find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  return function != nullptr;
}

Result<Functions> Load() {
  void* const library = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);  // never closed: its threads and types outlive us
  Functions f;
  const bool is_whole =
      library != nullptr && Find(library, "rsvg_handle_new_from_data", f.read_svg) &&
      Find(library, "rsvg_handle_render_document", f.render) && Find(library, "g_object_unref", f.unref) &&
      Find(library, "cairo_image_surface_create", f.make_surface) &&
      Find(library, "cairo_surface_destroy", f.destroy_surface) &&
      Find(library, "cairo_surface_write_to_png_stream", f.write_png) &&
      Find(library, "cairo_create", f.make_context) && Find(library, "cairo_destroy", f.destroy_context);
  if (!is_whole)
    return Failure(std::string("PNG pictures need ") + kLibrary +
                   " (Debian package librsvg2-2); install it, or write an .svg");
  return f;
}

int Append(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return kSuccess;
}

/// The number after `name="`.
double Attribute(const std::string& svg, const std::string& name) {
  const size_t start = svg.find(' ' + name + "=\"");
  if (start == std::string::npos) return 0;
  const size_t begin = start + name.size() + 3, end = svg.find('"', begin);
  if (end == std::string::npos) return 0;
  return ParseDouble(std::string_view(svg).substr(begin, end - begin)).value_or(0);
}

}  // namespace

SvgSize SizeOfSvg(const std::string& svg) { return {Attribute(svg, "width"), Attribute(svg, "height")}; }

Result<std::string> PngFromSvg(const std::string& svg, double zoom) {
  const SvgSize size = SizeOfSvg(svg);
  const Error failed = Failure("the chart could not be drawn as PNG; write an .svg");
  const double width = std::ceil(zoom * size.width), height = std::ceil(zoom * size.height);
  if (!(width >= 1 && height >= 1 && width <= kLargest_px && height <= kLargest_px)) return failed;
  const auto loaded = Load();
  if (!loaded) return loaded.error();
  const Functions& f = *loaded;
  void* const picture = f.read_svg(reinterpret_cast<const unsigned char*>(svg.data()), svg.size(), nullptr);
  if (picture == nullptr) return failed;
  void* const surface = f.make_surface(kRgb24, static_cast<int>(width), static_cast<int>(height));
  void* const context = f.make_context(surface);
  const Rectangle viewport{0, 0, width, height};
  std::string png;
  const bool is_drawn =
      f.render(picture, context, &viewport, nullptr) != 0 && f.write_png(surface, Append, &png) == kSuccess;
  f.destroy_context(context);
  f.destroy_surface(surface);
  f.unref(picture);
  if (!is_drawn) return failed;
  return png;
}

}  // namespace yorb
