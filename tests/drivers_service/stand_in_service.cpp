#include "tests/drivers_service/stand_in_service.h"

#include <gtest/gtest.h>
#include <libwebsockets.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace fulcrum::stand_in {
namespace {

using Json = nlohmann::json;

int on_event(lws* socket, lws_callback_reasons reason, void*, void* in, std::size_t length) {
  auto* const service = static_cast<Service*>(lws_context_user(lws_get_context(socket)));
  switch (reason) {
    case LWS_CALLBACK_ESTABLISHED:
      service->opened(socket);
      return 0;
    case LWS_CALLBACK_CLOSED:
      service->closed(socket);
      return 0;
    case LWS_CALLBACK_RECEIVE:
      service->heard(socket, static_cast<const char*>(in), length);
      return 0;
    case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
      service->woken();
      return 0;
    case LWS_CALLBACK_SERVER_WRITEABLE:
      return service->answer(socket) ? 0 : -1;
    default:
      return 0;
  }
}

constexpr lws_protocols kProtocols[] = {{"service", &on_event, 0, 4096, 0, nullptr, 0},
                                        {nullptr, nullptr, 0, 0, 0, nullptr, 0}};

Json xyz(const double (&v)[3]) {
  return {{"x", v[0]}, {"y", v[1]}, {"z", v[2]}};
}

}  // namespace

Service::Service(int port) {
  lws_context_creation_info made{};
  made.port = port;
  made.iface = "127.0.0.1";
  made.protocols = kProtocols;
  made.user = this;
  lws_set_log_level(0, nullptr);
  made.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS;
  context_ = lws_create_context(&made);
  lws_vhost* const host = context_ != nullptr ? lws_create_vhost(context_, &made) : nullptr;
  if (host == nullptr) {
    ADD_FAILURE() << "the stand-in cannot listen at port " << port;
    return;
  }
  port_ = lws_get_vhost_listen_port(host);
  thread_ = std::thread([this] {
    while (!ends_) lws_service(context_, 0);
  });
}

Service::~Service() {
  ends_ = true;
  if (context_ == nullptr) return;
  wake();
  if (thread_.joinable()) thread_.join();
  lws_context_destroy(context_);
}

void Service::opened(lws* socket) {
  const std::lock_guard lock(mutex_);
  client_ = socket;
  coming_.clear();
  owed_ = 0;
  greet_ = true;
  ++state_.sessions;
  ++state_.opened;
  lws_callback_on_writable(socket);
}

void Service::closed(lws* socket) {
  const std::lock_guard lock(mutex_);
  --state_.sessions;
  if (socket != client_) return;
  client_ = nullptr;
  for (double& newtons : state_.force) newtons = 0;
}

void Service::heard(lws* socket, const char* piece, std::size_t length) {
  const std::lock_guard lock(mutex_);
  coming_.append(piece, length);
  if (lws_remaining_packet_payload(socket) != 0 || lws_is_final_fragment(socket) == 0) return;
  take(coming_);
  coming_.clear();
  if (state_.swallowed > 0) {
    --state_.swallowed;
    return;
  }
  ++owed_;
  lws_callback_on_writable(socket);
}

void Service::wake() {
  if (context_ != nullptr) lws_cancel_service(context_);
}

void Service::woken() {
  const std::lock_guard lock(mutex_);
  if (client_ != nullptr) lws_callback_on_writable(client_);
}

bool Service::answer(lws* socket) {
  std::string text;
  {
    const std::lock_guard lock(mutex_);
    if (socket != client_ || (!greet_ && (owed_ == 0 || state_.answers == 0))) return true;
    text = greet_ && !state_.greets.empty()    ? state_.greets
           : !greet_ && !state_.babble.empty() ? state_.babble
                                               : says(greet_);
    if (!greet_) {
      --owed_;
      if (state_.answers > 0) --state_.answers;
    }
    greet_ = false;
    if (owed_ > 0) lws_callback_on_writable(socket);
  }
  std::vector<unsigned char> bytes(LWS_PRE + text.size());
  std::copy(text.begin(), text.end(), bytes.begin() + LWS_PRE);
  return lws_write(socket, bytes.data() + LWS_PRE, text.size(), LWS_WRITE_TEXT) >= 0;
}

std::string Service::says(bool whole) const {
  Json all{{"inverse3", Json::array()}, {"verse_grip", Json::array()}};
  if (whole && !state_.old) all["session_id"] = 7;
  for (const bool another : {true, false}) {
    if (another ? !state_.another_before : !state_.arm) continue;
    Json arm;
    arm["device_id"] = another ? "0BAD" : "049D";
    arm["state"]["cursor_position"] = another ? xyz({0.5, 0.5, 0.5}) : xyz(state_.p);
    arm["state"]["cursor_velocity"] = xyz({0, 0, 0});
    arm["status"] = {{"calibrated", state_.calibrated}, {"power_supply", state_.powered}, {"ready", true}};
    if (whole) {
      arm["config"]["type"] = state_.kind;
      arm["config"]["handedness"] = "right";
      arm["config"]["basis"]["permutation"] = state_.basis;
      arm["config"]["mount"]["scale"] = xyz({state_.scale, state_.scale, state_.scale});
    }
    all["inverse3"].push_back(arm);
  }
  if (state_.handle) {
    Json grip;
    grip["device_id"] = "61548";
    grip["state"] = {{"button", state_.button}, {"hall", 0}};
    grip["state"]["orientation"] = {
        {"w", state_.q[0]}, {"x", state_.q[1]}, {"y", state_.q[2]}, {"z", state_.q[3]}};
    all["verse_grip"].push_back(grip);
  }
  return all.dump();
}

void Service::take(const std::string& message) {
  const Json told = Json::parse(message, nullptr, false);
  const Json::json_pointer at(state_.old ? "/inverse3/0/commands/set_cursor_force/values"
                                         : "/inverse3/0/commands/set_cursor_force/vector");
  const bool known =
      told.is_object() && told.contains(at) && told["/inverse3/0/device_id"_json_pointer] == "049D";
  if (!known) {
    ++state_.misunderstood;
    return;
  }
  ++state_.forces;
  const char* const axes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) state_.force[i] = told[at][axes[i]].get<double>();
}

}  // namespace fulcrum::stand_in
