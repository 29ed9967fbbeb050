// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/cli/view_server.hpp"

#include "repose/core/errors.hpp"
#include "repose/view/answers.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <random>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace repose {

namespace {

using namespace std::chrono_literals;

constexpr auto host = "127.0.0.1";
constexpr auto glance = 400ms;   // between two looks at the folder
constexpr auto heartbeat = 15s;  // a comment to each listener, which finds out those that have left
constexpr std::size_t most_clients = 256;
constexpr int most_listeners = 200;  // each keeps a client's thread

/// 128 random bits as hexadecimal digits.
std::string random_token() {
  std::random_device random;
  std::string text;
  for (int k = 0; k < 4; ++k) text += fmt::format("{:08x}", random());
  return text;
}

/// Compares in a time that does not tell how much of it agrees.
bool same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t k = 0; k < a.size(); ++k) difference |= static_cast<unsigned>(a[k] ^ b[k]);
  return difference == 0;
}

/// What listeners get: the latest state of the folder, with a number that grows when it changes.
class News {
 public:
  /// Waits for a state newer than `seen`, at most a heartbeat. Returns whether there is one.
  bool wait(std::uint64_t& seen, std::string& state) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, heartbeat, [&] { return over_ || number_ != seen; });
    if (number_ == seen) return false;
    seen = number_;
    state = state_;
    return true;
  }
  void tell(const std::string& state) {
    const std::lock_guard lock(mutex_);
    if (number_ > 0 && state == state_) return;
    state_ = state;
    ++number_;
    changed_.notify_all();
  }
  void end() {
    const std::lock_guard lock(mutex_);
    over_ = true;
    changed_.notify_all();
  }
  bool over() {
    const std::lock_guard lock(mutex_);
    return over_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string state_;
  std::uint64_t number_ = 0;
  bool over_ = false;
};

std::string event_text(const std::string& state) {
  return state.empty() ? "event: gone\ndata: {}\n\n" : "event: change\ndata: " + state + "\n\n";
}

/// Those who listen to a folder, or to a member of a sweep.
struct Channel {
  News news;
  std::atomic<int> listeners{0};
};

}  // namespace

struct ViewServer::Parts {
  std::shared_ptr<Answers> answers;
  httplib::Server server;
  std::mutex mutex;
  std::map<std::string, Channel> channels;  // by what they are of; none is removed
  std::atomic<int> listeners{0};
  std::string token = random_token();
  int port = 0;

  bool meant_for_us(const httplib::Request& request) const {
    const auto named = request.get_header_value("Host");
    return named == fmt::format("{}:{}", host, port) || named == fmt::format("localhost:{}", port);
  }

  static void refuse(httplib::Response& response, int status, const char* why) {
    response.status = status;
    response.set_content(why, "text/plain; charset=utf-8");
  }

  void listen(const std::string& of, httplib::Response& response) {
    if (!answers->has_events(of)) return refuse(response, 404, "no such events\n");
    if (listeners >= most_listeners) return refuse(response, 503, "too many pages are open\n");
    Channel* channel = nullptr;
    {
      const std::lock_guard lock(mutex);
      channel = &channels[of];
    }
    ++listeners;
    ++channel->listeners;
    auto seen = std::make_shared<std::uint64_t>(0);
    response.set_chunked_content_provider(
        "text/event-stream",
        [channel, seen](std::size_t, httplib::DataSink& sink) {
          std::string state;
          const bool fresh = channel->news.wait(*seen, state);
          if (channel->news.over()) {
            sink.done();
            return true;
          }
          const std::string text = fresh ? event_text(state) : ": still here\n\n";
          return sink.write(text.data(), text.size());
        },
        [this, channel](bool) {
          --listeners;
          --channel->listeners;
        });
  }

  void reply(const httplib::Request& request, httplib::Response& response) {
    const std::string_view path = request.path;
    const auto end = path.find('/', 1);
    if (path.size() < 2 || !same(path.substr(1, end == path.npos ? path.npos : end - 1), token)) {
      return refuse(response, 403, "this address needs the token that `repose view` prints\n");
    }
    if (end == path.npos) return response.set_redirect("/" + token + "/");
    const std::string address(path.substr(end + 1));
    constexpr std::string_view api = "api/", events = "events";
    if (address.starts_with(api) && address.ends_with("/events")) {
      return listen(address.substr(api.size(), address.size() - api.size() - events.size()), response);
    }
    const auto answer = answers->answer(address);
    response.status = answer.status;
    response.set_content(answer.body, answer.type.c_str());
  }

  httplib::Server::HandlerResponse admit(const httplib::Request& request, httplib::Response& response) const {
    const bool ours = meant_for_us(request);
    if (ours && (request.method == "GET" || request.method == "HEAD")) {
      return httplib::Server::HandlerResponse::Unhandled;
    }
    if (ours) {
      refuse(response, 405, "only GET is answered\n");
    } else {
      refuse(response, 403, "this host is not served\n");
    }
    return httplib::Server::HandlerResponse::Handled;
  }

  /// The channels at this time, by what they are of.
  std::vector<std::pair<std::string, Channel*>> all_channels() {
    const std::lock_guard lock(mutex);
    std::vector<std::pair<std::string, Channel*>> all;
    for (auto& [of, channel] : channels) all.emplace_back(of, &channel);
    return all;
  }

  void watch(const std::atomic<bool>& stop) {
    while (!stop) {
      for (const auto& [of, channel] : all_channels()) {
        if (channel->listeners > 0) channel->news.tell(answers->state(of));
      }
      std::this_thread::sleep_for(glance);
    }
    for (const auto& [of, channel] : all_channels()) channel->news.end();
    server.stop();
  }
};

ViewServer::ViewServer(std::shared_ptr<Answers> answers, int port) : parts_(std::make_unique<Parts>()) {
  parts_->answers = std::move(answers);
  auto& server = parts_->server;
  server.new_task_queue = [] { return new httplib::ThreadPool(most_clients); };
  server.set_keep_alive_timeout(2);
  server.set_payload_max_length(0);
  // Nothing from elsewhere is loaded, and the address with its token is not told to anybody.
  server.set_default_headers(
      {{"Cache-Control", "no-store"},
       {"X-Content-Type-Options", "nosniff"},
       {"Referrer-Policy", "no-referrer"},
       {"X-Frame-Options", "DENY"},
       {"Content-Security-Policy",
        "default-src 'none'; script-src 'unsafe-inline' blob:; worker-src blob:; style-src 'unsafe-inline'; "
        "img-src data: blob:; connect-src 'self'"}});
  server.set_pre_routing_handler(
      [this](const auto& request, auto& response) { return parts_->admit(request, response); });
  server.Get(".*", [this](const auto& request, auto& response) { parts_->reply(request, response); });
  // Two programs must not hold one port, as the usual option of the library would let them.
  server.set_socket_options([](int socket) {
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  if (port == 0) {
    parts_->port = server.bind_to_any_port(host);
  } else if (server.bind_to_port(host, port)) {
    parts_->port = port;
  }
  if (parts_->port <= 0) throw InputError(fmt::format("--port {}: is in use, or not allowed", port));
}

ViewServer::~ViewServer() = default;

std::string ViewServer::address() const { return fmt::format("http://{}:{}/{}/", host, parts_->port, parts_->token); }

void ViewServer::serve(const std::atomic<bool>& stop) {
  std::thread watcher([&] { parts_->watch(stop); });
  parts_->server.listen_after_bind();
  watcher.join();
}

}  // namespace repose
