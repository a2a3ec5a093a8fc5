// SPDX-License-Identifier: MIT
//
// Catches a viewer that takes the server's memory or one of its threads for ever, and a request
// that a proxy before the server could understand in another way.
#include "web/http/server.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>

namespace mirocup::web {
namespace {

struct Answer {
  std::string text;
  std::size_t taken = 0;  // bytes of the request

  std::string status() const { return text.substr(0, 12); }
};

class Server : public testing::Test {
 protected:
  Server() { open({.bodies = {.max_body = 1024, .max_upload = 100'000}}); }

  void open(ServerOptions options) {
    server_.reset();
    server_ = std::make_unique<HttpServer>(
        [this](const Request& request, const Body& body) { return answer(request, body); },
        std::move(options));
    EXPECT_TRUE(server_->listen({.path = path_}, "--at"));
  }

  Reply answer(const Request& request, const Body& body) {
    seen_ = request;
    if (request.path == "/events")
      return {.events = [n = 0]() mutable { return EventBatch{"data: x\n\n", ++n == 3}; }};
    if (request.path == "/throws") throw std::runtime_error("no");
    Reply reply{.bytes = std::string(1000, 'p')};
    if (request.method != "PUT" && request.method != "POST") return reply;
    body_.clear();
    is_whole_ = body([this](std::string_view part) {
      body_ += part;
      return true;
    });
    return reply;
  }

  int connected() {
    const int end = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un name{};
    name.sun_family = AF_UNIX;
    path_.copy(name.sun_path, sizeof name.sun_path - 1);
    EXPECT_EQ(connect(end, reinterpret_cast<const sockaddr*>(&name), sizeof name), 0);
    return end;
  }

  // Sends a request, of which the server takes as much as it likes, and its end.
  Answer answer_to(const std::string& request) {
    const int end = connected();
    Answer answer;
    while (answer.taken < request.size()) {
      const ssize_t count =
          send(end, request.data() + answer.taken,
               std::min<std::size_t>(request.size() - answer.taken, 65536), MSG_NOSIGNAL);
      if (count <= 0) break;
      answer.taken += static_cast<std::size_t>(count);
    }
    shutdown(end, SHUT_WR);
    char bytes[4096];
    for (ssize_t count = 1; count > 0;) {
      count = recv(end, bytes, sizeof bytes, 0);
      if (count > 0) answer.text.append(bytes, static_cast<std::size_t>(count));
    }
    close(end);
    return answer;
  }

  std::string status_of(const std::string& lines) { return answer_to(lines + "\r\n").status(); }

  test_support::TemporaryFolder folder_;
  const std::string path_ = folder_ / "socket";
  Request seen_;
  std::string body_;
  bool is_whole_ = false;
  std::unique_ptr<HttpServer> server_;
};

const std::string get = "GET / HTTP/1.1\r\nHost: x\r\n";
const std::string put = "PUT / HTTP/1.1\r\nHost: x\r\n";
const std::string ok = "HTTP/1.1 200", bad = "HTTP/1.1 400";

TEST_F(Server, AnswersARequest) {
  const Answer answer =
      answer_to("GET /a%20b+c?k=%41+x&k2=&k=y HTTP/1.1\r\nHost: x\r\nX-A: 1\r\n\r\n");
  EXPECT_EQ(answer.status(), ok) << answer.text;
  EXPECT_NE(answer.text.find("\r\n\r\n" + std::string(1000, 'p')), std::string::npos);
  EXPECT_EQ(seen_.path, "/a b+c");
  EXPECT_EQ(seen_.query,
            (std::multimap<std::string, std::string>{{"k", "A x"}, {"k", "y"}, {"k2", ""}}));
  EXPECT_EQ(seen_.header("x-a"), "1");
  EXPECT_LT(answer_to("HEAD / HTTP/1.1\r\nHost: x\r\n\r\n").text.size(), 300u);
  EXPECT_EQ(answer_to("GET /throws HTTP/1.1\r\nHost: x\r\n\r\n").status(), "HTTP/1.1 500");
  EXPECT_EQ(answer_to("PATCH / HTTP/1.1\r\nHost: x\r\nContent-Length: 2\r\n\r\nab").status(), ok)
      << "the handler decides on methods";
}

TEST_F(Server, SendsEventsUntilTheLast) {
  const Answer answer = answer_to("GET /events HTTP/1.1\r\nHost: x\r\n\r\n");
  EXPECT_NE(answer.text.find("\r\n9\r\ndata: x\n\n\r\n"), std::string::npos) << answer.text;
  EXPECT_TRUE(answer.text.ends_with("\r\n0\r\n\r\n")) << answer.text;
  const Answer old = answer_to("GET /events HTTP/1.0\r\n\r\n");
  EXPECT_TRUE(old.text.ends_with("\r\n\r\ndata: x\n\ndata: x\n\ndata: x\n\n")) << old.text;
}

TEST_F(Server, TakesUploadsAndTellsTheirEnd) {
  const std::string body(100'000, 'u');
  answer_to(put + "Content-Length: 100000\r\n\r\n" + body);
  EXPECT_TRUE(is_whole_);
  EXPECT_EQ(body_, body);
  answer_to(put + "Transfer-Encoding: chunked\r\n\r\n3\r\nELF\r\n4;x=y\r\nmore\r\n0\r\n\r\n");
  EXPECT_TRUE(is_whole_);
  EXPECT_EQ(body_, "ELFmore");
  for (const char* cut :
       {"Content-Length: 9\r\n\r\nshort", "Transfer-Encoding: chunked\r\n\r\n9\r\nshort",
        "Transfer-Encoding: chunked\r\n\r\n3\r\nELF\r\n",
        "Transfer-Encoding: chunked\r\n\r\nzz\r\nELF\r\n0\r\n\r\n",
        "Transfer-Encoding: chunked\r\n\r\n-1\r\nELF\r\n0\r\n\r\n",
        "Transfer-Encoding: chunked\r\n\r\nfffffffffffffffff\r\nELF",
        "Transfer-Encoding: chunked\r\n\r\n3\r\nELFx\r\n0\r\n\r\n",
        "Transfer-Encoding: chunked\r\n\r\n3\r\nELF\r\n0\r\nT: t\r\n\r\n",
        "Transfer-Encoding: chunked\r\n\r\n3\r\nELF\r\n0\r\nT: t\r\n u\r\n\r\n"}) {
    answer_to(put + cut);
    EXPECT_FALSE(is_whole_) << cut;
  }
}

TEST_F(Server, AsksForABodyOnlyWhenItIsRead) {
  const std::string expects = "Content-Length: 3\r\nExpect: 100-continue\r\n\r\n";
  EXPECT_EQ(answer_to(get + expects).status(), ok);
  const int end = connected();
  const std::string head = put + expects;
  ASSERT_EQ(send(end, head.data(), head.size(), 0), static_cast<ssize_t>(head.size()));
  char bytes[100];
  const ssize_t count = recv(end, bytes, sizeof bytes, 0);
  EXPECT_EQ(std::string(bytes, static_cast<std::size_t>(std::max<ssize_t>(count, 0))),
            "HTTP/1.1 100 Continue\r\n\r\n");
  close(end);
}

// A thousand ranges of a page would be a thousand pages.
TEST_F(Server, SendsAPageOnceWhateverIsAskedForAndHoweverOften) {
  std::string request = get + "Range: bytes=0-";
  for (int i = 0; i < 1000; ++i) request += ",0-";
  const Answer answer = answer_to(request + "\r\n\r\n" + get + "\r\n");
  EXPECT_EQ(answer.status(), ok);
  EXPECT_LT(answer.text.size(), 2000u);
}

TEST_F(Server, RefusesConnectionsThatHaveNoRoom) {
  open({.entrance = {.capacity = 2, .request_time = std::chrono::milliseconds(60'000)}});
  const int first = connected();
  const int second = connected();
  EXPECT_EQ(status_of(get), ok) << "the oldest half request gives way";
  char byte = 0;
  EXPECT_EQ(recv(first, &byte, 1, 0), 0);
  close(first);
  close(second);
}

TEST_F(Server, IsForTheGroupOfItsSocket) {
  struct stat there {};
  ASSERT_EQ(stat(path_.c_str(), &there), 0);
  EXPECT_EQ(there.st_mode & 0777u, 0660u);
  HttpServer second([](const Request&, const Body&) { return Reply(); }, {});
  const auto listening = second.listen({.path = path_}, "--at");
  ASSERT_FALSE(listening);
  EXPECT_NE(listening.error().what.find("another server listens there"), std::string::npos);
  server_.reset();
  EXPECT_NE(stat(path_.c_str(), &there), 0) << "the file goes with the server";
}

// Catches two servers that both listen on one port and get a part of its viewers each.
TEST(HttpServer, HasItsPortForItself) {
  const auto nothing = [](const Request&, const Body&) { return Reply(); };
  HttpServer first(nothing, {});
  ASSERT_TRUE(first.listen({}, "--at"));
  const std::string url = first.url();
  const int port = std::stoi(url.substr(url.rfind(':') + 1));
  HttpServer second(nothing, {});
  const auto listening = second.listen({.port = port}, "--at");
  ASSERT_FALSE(listening);
  EXPECT_EQ(listening.error().what,
            "--at: 127.0.0.1 port " + std::to_string(port) + " is in use: take another port");
}

}  // namespace
}  // namespace mirocup::web
