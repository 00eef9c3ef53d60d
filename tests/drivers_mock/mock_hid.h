#pragma once
// HID devices that are not there, for the real hidapi and libudev: umockdev shows them the files of /sys and
// the node of /dev, and asks here what they ask of the node. The program must begin by umockdev-wrapper.

#include <umockdev.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "drivers/hid/hid_id.h"

namespace fulcrum::test {

using Bytes = std::vector<std::uint8_t>;

// A machine without any device but those that are plugged into it here.
class MockMachine {
public:
  MockMachine();
  ~MockMachine();
  MockMachine(const MockMachine&) = delete;
  MockMachine& operator=(const MockMachine&) = delete;

  // False: the program did not begin by umockdev-wrapper, and what it sees is the machine that it runs on.
  bool stands_in() const { return stands_in_; }
  // What else /sys and /dev show, in umockdev's words.
  void add(const std::string& tree);

private:
  friend class MockHid;
  friend class MockUsb;
  UMockdevTestbed* testbed_;
  bool stands_in_;
  // No number is given twice, since umockdev keeps each node's end until it ends itself. High ones, so that
  // no real device has them.
  int next_number_ = 70;
};

struct MockHidFacts {
  hid::HidId id;
  bool bluetooth = false;
  std::string name;
  Bytes descriptor;               // of its reports
  std::vector<Bytes> features{};  // each begins with its number; the device stalls at any other
  std::string serial{};           // empty: it has none
  bool wanders = false;           // it is plugged in at another port of USB each time
  bool named = true;              // false: its node in /dev is gone, what is in /sys not yet
};

// Outlives every port to it that is open.
class MockHid {
public:
  // Plugged in.
  MockHid(MockMachine& machine, MockHidFacts facts);
  ~MockHid();
  MockHid(const MockHid&) = delete;
  MockHid& operator=(const MockHid&) = delete;

  void plug();
  void unplug();
  const std::string& node() const { return node_; }  // where it was plugged in last

  // A report, which whoever has it open can read next.
  void say(Bytes report);
  // Nothing was said that has not been read.
  bool all_read() const;
  // False: what is written is refused.
  void take(bool takes);
  // It is going: its node can be opened, and whatever is asked of it then fails.
  void go();

  std::vector<Bytes> written() const;
  Bytes last_written() const;  // once anything was
  using Clock = std::chrono::steady_clock;
  Clock::time_point written_at(std::size_t n) const;  // when the n-th came, from 0
  std::size_t times_written() const;
  std::vector<std::uint8_t> asked() const;  // numbers of feature reports

private:
  static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  static gboolean on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  static gboolean on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  void answer(UMockdevIoctlClient* client);
  void answer_feature(UMockdevIoctlClient* client, std::size_t room);
  void ring() const;

  MockMachine& machine_;
  const MockHidFacts facts_;
  UMockdevIoctlBase* const handler_;
  std::vector<std::string> paths_;  // in /sys, from the outermost on
  std::string node_;
  std::vector<std::string> nodes_;  // those that it has had
  int bell_ = -1;                   // the node's other end
  int port_ = 0;                    // of USB; 0: it was never plugged in

  mutable std::mutex mutex_;  // umockdev asks from a thread of its own
  bool plugged_ = false, takes_ = true, goes_ = false;
  std::deque<Bytes> said_;  // while there are any, the bell has rung
  std::vector<Bytes> written_;
  std::vector<Clock::time_point> written_at_;
  std::vector<std::uint8_t> asked_;
};

}  // namespace fulcrum::test
