#include "tests/person/window_link.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <stdexcept>

namespace fulcrum::person {
namespace {

// A window may go between two questions about it: what follows says so.
int ignore_error(Display*, XErrorEvent*) {
  return 0;
}

}  // namespace

class WindowLink::Implementation {
public:
  explicit Implementation(unsigned long window) : display_(XOpenDisplay(nullptr)), window_(window) {
    if (display_ == nullptr) throw std::runtime_error("there is no display");
    XSetErrorHandler(ignore_error);
    int event = 0, error = 0, major = 0, minor = 0;
    if (XTestQueryExtension(display_, &event, &error, &major, &minor) == False)
      throw std::runtime_error("the display has no XTest");
  }
  ~Implementation() { XCloseDisplay(display_); }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  Picture picture() {
    XWindowAttributes now;
    if (XGetWindowAttributes(display_, window_, &now) == 0) throw std::runtime_error("the window is gone");
    XImage* image = XGetImage(display_, window_, 0, 0, static_cast<unsigned>(now.width),
                              static_cast<unsigned>(now.height), AllPlanes, ZPixmap);
    if (image == nullptr) throw std::runtime_error("the window is gone, or not on the screen");
    Picture taken{now.width, now.height, {}};
    taken.rgb.resize(static_cast<std::size_t>(now.width) * static_cast<std::size_t>(now.height));
    const bool is_known = image->bits_per_pixel == 32 && image->red_mask == 0xFF0000;
    for (int y = 0; is_known && y < now.height; ++y)
      std::memcpy(&taken.rgb[static_cast<std::size_t>(y) * static_cast<std::size_t>(now.width)],
                  image->data + static_cast<std::ptrdiff_t>(y) * image->bytes_per_line,
                  4 * static_cast<std::size_t>(now.width));
    XDestroyImage(image);
    if (!is_known) throw std::runtime_error("the display has pixels other than of 32 bits");
    return taken;
  }

  void point_at(const Place& place) {
    int x = 0, y = 0;
    Window child = 0;
    XTranslateCoordinates(display_, window_, DefaultRootWindow(display_),
                          static_cast<int>(std::lround(place.x)), static_cast<int>(std::lround(place.y)), &x,
                          &y, &child);
    XTestFakeMotionEvent(display_, -1, x, y, CurrentTime);
    XFlush(display_);
  }

  void button(unsigned number, bool down) {
    XTestFakeButtonEvent(display_, number, down ? True : False, CurrentTime);
    XFlush(display_);
  }

  void key(unsigned long symbol, bool down) {
    XTestFakeKeyEvent(display_, XKeysymToKeycode(display_, symbol), down ? True : False, CurrentTime);
    XFlush(display_);
  }

private:
  Display* display_;
  Window window_;
};

WindowLink::WindowLink(unsigned long window) : implementation_(std::make_unique<Implementation>(window)) {}
WindowLink::~WindowLink() = default;

Picture WindowLink::picture() {
  return implementation_->picture();
}

void WindowLink::point_at(const Place& place) {
  implementation_->point_at(place);
}

void WindowLink::press(Button button) {
  implementation_->button(static_cast<unsigned>(button), true);
}

void WindowLink::release(Button button) {
  implementation_->button(static_cast<unsigned>(button), false);
}

void WindowLink::press_key(unsigned long symbol) {
  implementation_->key(symbol, true);
}

void WindowLink::release_key(unsigned long symbol) {
  implementation_->key(symbol, false);
}

}  // namespace fulcrum::person
