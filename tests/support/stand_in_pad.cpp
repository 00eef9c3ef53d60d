// An Xbox pad that is not there, for a program that looks for one in /dev/input: umockdev stands in for the
// kernel.
//
//     stand_in_pad FIFO PROGRAM ARGUMENTS...
//
// becomes PROGRAM, which has the pad, and plays the pad for as long as PROGRAM runs. What the pad is to do
// comes as lines from FIFO: a name and a value, "a 1" or "left_x -0.5"; "unplug" and "plug".

#include <fcntl.h>
#include <linux/input.h>
#include <sys/prctl.h>
#include <umockdev.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fstream>
#include <iterator>
#include <mutex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr const char* kFolder = "/sys/devices/pci0000:00/usb1/1-1/1-1:1.0/input/input";
constexpr const char* kName = "Microsoft X-Box 360 pad";
constexpr input_id kId{.bustype = BUS_USB, .vendor = 0x045e, .product = 0x028e, .version = 0x0114};

// As Linux's driver xpad has them.
struct Control {
  const char* name;
  __u16 type, code;
  int low, high;
  std::atomic<int> value{0};
};
Control controls[] = {
    {"a", EV_KEY, BTN_A, 0, 1},
    {"b", EV_KEY, BTN_B, 0, 1},
    {"x", EV_KEY, BTN_X, 0, 1},
    {"y", EV_KEY, BTN_Y, 0, 1},
    {"left_bumper", EV_KEY, BTN_TL, 0, 1},
    {"right_bumper", EV_KEY, BTN_TR, 0, 1},
    {"back", EV_KEY, BTN_SELECT, 0, 1},
    {"start", EV_KEY, BTN_START, 0, 1},
    {"guide", EV_KEY, BTN_MODE, 0, 1},
    {"left_stick", EV_KEY, BTN_THUMBL, 0, 1},
    {"right_stick", EV_KEY, BTN_THUMBR, 0, 1},
    {"left_x", EV_ABS, ABS_X, -32768, 32767},
    {"left_y", EV_ABS, ABS_Y, -32768, 32767},
    {"left_trigger", EV_ABS, ABS_Z, 0, 255},
    {"right_x", EV_ABS, ABS_RX, -32768, 32767},
    {"right_y", EV_ABS, ABS_RY, -32768, 32767},
    {"right_trigger", EV_ABS, ABS_RZ, 0, 255},
    {"cross_x", EV_ABS, ABS_HAT0X, -1, 1},
    {"cross_y", EV_ABS, ABS_HAT0Y, -1, 1},
};

[[noreturn]] void refuse(const std::string& sentence) {
  std::fprintf(stderr, "stand_in_pad: %s\n", sentence.c_str());
  std::_Exit(1);
}

void succeeds(bool done, const GError* error) {
  if (!done) refuse(error != nullptr ? error->message : "umockdev does not say why");
}

// As EVIOCGBIT and sysfs have the codes of a type.
using Bits = std::array<std::uint8_t, KEY_CNT / 8>;
Bits bits_of(__u16 type) {
  Bits bits{};
  const auto set = [&](unsigned code) { bits[code / 8] |= static_cast<std::uint8_t>(1U << code % 8); };
  if (type == 0)
    for (const unsigned known : std::array<unsigned, 3>{EV_SYN, EV_KEY, EV_ABS}) set(known);
  else
    for (Control& control : controls)
      if (control.type == type) set(control.code);
  return bits;
}

// 64 bits a word, the highest first.
std::string sysfs_words(const Bits& bits) {
  std::string text;
  for (std::size_t word = bits.size() / 8; word-- > 0;) {
    unsigned long long value = 0;
    std::memcpy(&value, &bits[8 * word], 8);
    if (value == 0 && text.empty()) continue;
    char digits[20];
    std::snprintf(digits, sizeof digits, "%s%llx", text.empty() ? "" : " ", value);
    text += digits;
  }
  return text;
}

// What the ioctl's argument points to becomes these bytes, as far as there is room.
void answer_with(UMockdevIoctlClient* client, const void* bytes, std::size_t size, std::size_t room) {
  GError* error = nullptr;
  const std::size_t told = std::min(size, room);
  UMockdevIoctlData* const data =
      umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, told, &error);
  succeeds(data != nullptr, error);
  std::string copy(static_cast<const char*>(bytes), told);
  umockdev_ioctl_data_update(data, 0, reinterpret_cast<guint8*>(copy.data()), static_cast<gint>(told));
  umockdev_ioctl_data_unref(data);
  umockdev_ioctl_client_complete(client, static_cast<glong>(told), 0);
}

class Pad {
public:
  Pad() : testbed_(umockdev_testbed_new()), handler_(umockdev_ioctl_base_new()) {
    const auto connect = [this](const char* signal,
                                gboolean (*answers)(UMockdevIoctlBase*, UMockdevIoctlClient*, gpointer)) {
      g_signal_connect_data(handler_, signal, reinterpret_cast<GCallback>(answers), this, nullptr,
                            static_cast<GConnectFlags>(0));
    };
    connect("handle-ioctl", &Pad::on_ioctl);
    connect("handle-read", &Pad::on_read);
    // Something else that stays: umockdev removes a folder that has become empty, and who watches it sees no
    // more.
    GError* error = nullptr;
    const char* const other =
        "P: /devices/virtual/input/input6\nE: SUBSYSTEM=input\nA: name=Power Button\n\n"
        "P: /devices/virtual/input/input6/event6\nN: input/event6\nE: DEVNAME=/dev/input/event6\n"
        "E: SUBSYSTEM=input\nE: MAJOR=13\nE: MINOR=70\nA: dev=13:70\n";
    succeeds(umockdev_testbed_add_from_string(testbed_, other, &error) != FALSE, error);
    plug();
  }

  std::string root() const {
    gchar* const folder = umockdev_testbed_get_root_dir(testbed_);
    std::string text = folder;
    g_free(folder);
    return text;
  }

  // At another node than before, since umockdev gives each once.
  void plug() {
    const std::string number = std::to_string(++number_), event = "event" + number;
    path_ = kFolder + number;
    const std::string node = "/dev/input/" + event, path = path_.substr(4);
    const std::string tree =
        "P: " + path + "\nE: SUBSYSTEM=input\nA: name=" + kName +
        "\nA: id/bustype=0003\nA: id/vendor=045e\nA: id/product=028e\nA: id/version=0114\n"
        "A: capabilities/key=" +
        sysfs_words(bits_of(EV_KEY)) + "\nA: capabilities/abs=" + sysfs_words(bits_of(EV_ABS)) +
        "\n\nP: " + path + "/" + event + "\nN: input/" + event + "\nE: DEVNAME=" + node +
        "\nE: SUBSYSTEM=input\nE: ID_INPUT_JOYSTICK=1\nL: device=../../input" + number +
        "\nE: MAJOR=13\nE: MINOR=" + std::to_string(64 + number_) +
        "\nA: dev=13:" + std::to_string(64 + number_) + "\n";
    GError* error = nullptr;
    succeeds(umockdev_testbed_attach_ioctl(testbed_, node.c_str(), handler_, &error) != FALSE, error);
    succeeds(umockdev_testbed_add_from_string(testbed_, tree.c_str(), &error) != FALSE, error);
    const std::lock_guard lock(mutex_);
    plugged_ = true;
    for (Control& control : controls) control.value = 0;
  }

  void unplug() {
    {
      const std::lock_guard lock(mutex_);
      plugged_ = false;
      to_tell_.clear();
    }
    umockdev_testbed_remove_device(testbed_, (path_ + "/event" + std::to_string(number_)).c_str());
    umockdev_testbed_remove_device(testbed_, path_.c_str());
  }

  // One report: names and values.
  void report(std::istringstream& words) {
    Report report;
    std::string name;
    double value = 0;
    while (words >> name >> value) {
      const auto control =
          std::ranges::find_if(controls, [&](const Control& one) { return name == one.name; });
      if (control == std::end(controls)) refuse("there is no '" + name + "' on the pad");
      const double whole =
          value < 0 ? -static_cast<double>(control->low) : static_cast<double>(control->high);
      report.push_back({control, static_cast<int>(std::lround(whole * value))});
    }
    const std::lock_guard lock(mutex_);
    // A hand that steers says where the sticks are now; where they were before nobody needs to see.
    const auto steers = [](const Report& one) { return one.size() > 1; };
    if (steers(report) && !to_tell_.empty() && steers(to_tell_.back())) to_tell_.pop_back();
    to_tell_.push_back(std::move(report));
  }

private:
  static constexpr int kLooks = 4;  // GLFW reads a pad twice a frame, and until nothing is left

  struct Change {
    Control* control;
    int value;
  };
  using Report = std::vector<Change>;

  // What the program reads next; false: nothing now.
  bool next(input_event& event) {
    if (looks_ > 0) --looks_;
    if (looks_ > 0 || to_tell_.empty()) return false;
    Report& report = to_tell_.front();
    if (report.empty()) {
      to_tell_.pop_front();
      looks_ = kLooks;
      event.type = EV_SYN;
      event.code = SYN_REPORT;
      return true;
    }
    const Change change = report.front();
    report.erase(report.begin());
    change.control->value = change.value;
    event.type = change.control->type;
    event.code = change.control->code;
    event.value = change.value;
    return true;
  }

  static gboolean on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    Pad& pad = *static_cast<Pad*>(self);
    const std::lock_guard lock(pad.mutex_);
    input_event event{};
    UMockdevIoctlData* const room = umockdev_ioctl_client_get_arg(client);
    if (!pad.plugged_ || static_cast<std::size_t>(room->data_len) < sizeof event || !pad.next(event)) {
      umockdev_ioctl_client_complete(client, -1, pad.plugged_ ? EAGAIN : ENODEV);
      return TRUE;
    }
    umockdev_ioctl_data_update(room, 0, reinterpret_cast<guint8*>(&event), sizeof event);
    umockdev_ioctl_client_complete(client, sizeof event, 0);
    return TRUE;
  }

  static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer) {
    const auto request = static_cast<unsigned>(umockdev_ioctl_client_get_request(client));
    const unsigned number = _IOC_NR(request), room = _IOC_SIZE(request);
    if (_IOC_TYPE(request) != 'E') {
      umockdev_ioctl_client_complete(client, -1, ENOTTY);
    } else if (number == _IOC_NR(EVIOCGID)) {
      answer_with(client, &kId, sizeof kId, room);
    } else if (number == _IOC_NR(EVIOCGNAME(0))) {
      answer_with(client, kName, std::strlen(kName) + 1, room);
    } else if (number >= _IOC_NR(EVIOCGABS(0)) && number < _IOC_NR(EVIOCGABS(ABS_CNT))) {
      input_absinfo info{};
      for (Control& control : controls) {
        if (control.type != EV_ABS || number != _IOC_NR(EVIOCGABS(control.code))) continue;
        info.value = control.value;
        info.minimum = control.low;
        info.maximum = control.high;
      }
      answer_with(client, &info, sizeof info, room);
    } else if (number >= _IOC_NR(EVIOCGBIT(0, 0)) && number < _IOC_NR(EVIOCGBIT(EV_CNT, 0))) {
      const Bits bits = bits_of(static_cast<__u16>(number - _IOC_NR(EVIOCGBIT(0, 0))));
      answer_with(client, bits.data(), bits.size(), room);
    } else {
      umockdev_ioctl_client_complete(client, -1, EINVAL);
    }
    return TRUE;
  }

  UMockdevTestbed* testbed_;
  UMockdevIoctlBase* handler_;
  std::string path_;
  int number_ = 6;
  std::mutex mutex_;
  bool plugged_ = false;
  std::deque<Report> to_tell_;
  int looks_ = 0;  // still to find nothing
};

[[noreturn]] void play(const char* fifo, int tell) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  Pad pad;
  const std::string root = pad.root() + '\n';
  if (write(tell, root.data(), root.size()) < 0) refuse("its program is gone");
  close(tell);
  const int held = open(fifo, O_RDWR | O_CLOEXEC);  // so that it does not end with its first writer
  std::ifstream lines(fifo);
  if (held < 0 || !lines) refuse(std::string("cannot read ") + fifo);
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    if (line == "plug")
      pad.plug();
    else if (line == "unplug")
      pad.unplug();
    else
      pad.report(words);
  }
  std::_Exit(0);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) refuse("asks for a FIFO and a program");
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) refuse("no pipe");
  const pid_t player = fork();
  if (player < 0) refuse("no second process");
  if (player == 0) play(arguments[1], ends[1]);
  close(ends[1]);
  std::string root(4096, '\0');
  const ssize_t got = read(ends[0], root.data(), root.size());
  if (got <= 1) refuse("the pad is not there");
  root.resize(static_cast<std::size_t>(got) - 1);
  // Here is no sound: ALSA would look for 32 cards, and umockdev has places for 50 nodes.
  setenv("ALSA_CONFIG_PATH", "/dev/null", 1);
  setenv("UMOCKDEV_DIR", root.c_str(), 1);
  setenv("LD_PRELOAD", "libumockdev-preload.so.0", 1);
  execvp(arguments[2], arguments + 2);
  refuse(std::string("cannot start ") + arguments[2]);
}
