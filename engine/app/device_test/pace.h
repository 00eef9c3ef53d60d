#pragma once
// When the ticks of a device test come.

#include <functional>

namespace fulcrum::app::device_test {

// Waits until the next tick is due and answers when it then is: s since the beginning.
using Pace = std::function<double()>;

// As fast as they can: for a simulated device, whose time is the ticks'.
Pace without_clock(double tick_s);

// When they are due. After a delay it goes on with the tick that is due then: those between are left out.
Pace by_clock(double tick_s);

}  // namespace fulcrum::app::device_test
