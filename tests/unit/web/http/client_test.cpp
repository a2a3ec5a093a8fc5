// SPDX-License-Identifier: MIT
//
// Catches a client that waits for ever, takes other bytes for an answer, follows a server to
// another place, or believes a server with a certificate of somebody else.
#include "web/http/client.hpp"

#include "tests/support/temporary_folder.hpp"
#include "web/http/server.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace mirocup::web {
namespace {

using namespace std::chrono_literals;

// A server that sends the same bytes to its client, whatever the client asks for, and then says
// this is all, or first waits until the client is gone. With `again` it repeats the bytes.
class Bytes {
 public:
  enum class Then { closes, waits, repeats };
  explicit Bytes(std::string bytes, Then then = Then::closes)
      : listener_(open_listener(address_, "--at").value()),
        thread_([this, bytes = std::move(bytes), then] {
          pollfd come{.fd = listener_, .events = POLLIN, .revents = 0};
          poll(&come, 1, 10'000);
          const int viewer = accept(listener_, nullptr, nullptr);
          while (::send(viewer, bytes.data(), bytes.size(), MSG_NOSIGNAL) > 0 &&
                 then == Then::repeats)
            std::this_thread::sleep_for(5ms);
          if (then == Then::closes) shutdown(viewer, SHUT_WR);
          char part[4096];
          while (recv(viewer, part, sizeof part, 0) > 0) {
          }
          close(viewer);
        }) {}
  ~Bytes() {
    thread_.join();
    close(listener_);
  }
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;

  Answer answer(ClientOptions options = {}, const std::string& method = "GET",
                const std::string& body = "") const {
    return HttpClient::open(url_of(address_, false), options).value().ask(method, "/", body);
  }

 private:
  Address address_;
  int listener_;
  std::thread thread_;
};

Answer answer_to(const std::string& bytes) {
  return Bytes(bytes).answer();
}

TEST(HttpClient, ReadsWholeAnswersOfEachKind) {
  for (const std::string one :
       {"Content-Length: 5\r\n\r\nhello", "\r\nhello",
        "Transfer-Encoding: chunked\r\n\r\n2\r\nhe\r\n3\r\nllo\r\n0\r\n\r\n"}) {
    const Answer answer = answer_to("HTTP/1.1 200 OK\r\n" + one);
    EXPECT_EQ(answer.status, 200) << one;
    EXPECT_EQ(answer.body, "hello") << one;
    EXPECT_EQ(answer.error, "") << one;
  }
  EXPECT_EQ(answer_to("HTTP/1.1 204 No Content\r\n\r\n").status, 204);
  EXPECT_EQ(Bytes("HTTP/1.1 200 OK\r\nContent-Length: 5\r\n\r\n").answer({}, "HEAD").status, 200);
}

TEST(HttpClient, TakesNothingElseForAnAnswer) {
  for (const std::string one :
       {"", "\r\n", "SSH-2.0\r\n", "HTTP/1.1", "HTTP/1.1 200 OK\r\n",
        "HTTP/1.1 200 OK\r\nContent-Length: 6\r\n\r\nhello",
        "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n5\r\nhello\r\n",
        "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\nx\r\n"}) {
    const Answer answer = answer_to(one);
    EXPECT_EQ(answer.status, 0) << one;
    EXPECT_EQ(answer.error,
              "the server does not answer: the connection broke, or the server "
              "expects https; try https://")
        << one;
  }
}

TEST(HttpClient, FollowsNoServerToAnotherPlace) {
  const Answer answer =
      answer_to("HTTP/1.1 302 Found\r\nLocation: http://127.0.0.1:1/\r\nContent-Length: 0\r\n\r\n");
  EXPECT_EQ(answer.status, 302);
}

TEST(HttpClient, EndsAnAnswerAtItsLimits) {
  const std::string head = "HTTP/1.1 200 OK\r\n";
  const std::string expected = "the server's answer is too long or takes too long";
  EXPECT_EQ(answer_to(head + "Content-Length: 99999999999999\r\n\r\n").error, expected);
  EXPECT_EQ(Bytes(head + "X: " + std::string(70'000, 'x')).answer().error, expected);
  EXPECT_EQ(Bytes(head + "\r\n" + std::string(2000, 'x')).answer({.max_answer = 1000}).error,
            expected);
  // An answer without an end, of a server that is silent and of one that never is.
  EXPECT_EQ(Bytes(head + "\r\n", Bytes::Then::waits).answer({.patience = 1s}).error, expected);
  EXPECT_EQ(Bytes(head + "\r\n", Bytes::Then::repeats).answer({.time = 1s}).error, expected);
}

// A server that answers before it has taken the file is heard.
TEST(HttpClient, HearsWhyAFileIsNotTaken) {
  const Bytes server("HTTP/1.1 413 Payload Too Large\r\nContent-Length: 3\r\n\r\nbig");
  const Answer answer = server.answer({}, "PUT", std::string(4u << 20, 'x'));
  EXPECT_EQ(answer.status, 413);
  EXPECT_EQ(answer.body, "big");
}

TEST(HttpClient, GivesPartsUntilTheyAreEnough) {
  HttpServer server(
      [](const Request&, const Body&) {
        return Reply{.events = [] { return EventBatch{"data: x\n\n", false}; }};
      },
      {});
  ASSERT_TRUE(server.listen({}, "--at"));
  std::string seen;
  const auto client = HttpClient::open(server.url());
  (void)client.value().ask("GET", "/", "", [&seen](std::string_view part) {
    seen += part;
    return seen.size() < 30;
  });
  EXPECT_EQ(seen.substr(0, 18), "data: x\n\ndata: x\n\n");
}

TEST(HttpClient, NamesAWrongAddress) {
  for (const std::string one : {"", "https://", "127.0.0.1:80", "ftp://x", "http://a b",
                                "http://a/b c", "http://me@host", "http://a?b", "http://a\r\nX: y"})
    EXPECT_NE(HttpClient::open(one).error().what.find("https://league.example:8443 is expected"),
              std::string::npos)
        << one;
  for (const std::string one : {"http://a:b", "http://a:70000", "http://:80"})
    EXPECT_EQ(HttpClient::open(one).error().what, one + " is no address of a server");
  for (const std::string one :
       {"http://a", "http://a/", "http://a/b/", "https://[::1]", "https://[::1]:80//"})
    EXPECT_TRUE(HttpClient::open(one)) << one;
  EXPECT_EQ(HttpClient::open("http://127.0.0.1:1").value().ask("GET", "/").error,
            "the server does not answer: the connection was refused, or there is no such computer");
}

TEST(HttpClient, TrustsOnlyTheCertificateOfThatServer) {
  const test_support::TemporaryFolder folder;
  const auto made = [&folder](const std::string& name, const std::string& alternative) {
    const std::string command =
        "/usr/bin/openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days "
        "2 "
        "-subj /CN=x -addext subjectAltName=" +
        alternative + " -keyout " + folder / (name + ".key") + " -out " + folder / (name + ".pem") +
        " 2>/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return folder / (name + ".pem");
  };
  const std::string own = made("own", "IP:127.0.0.1"), other = made("other", "IP:127.0.0.2"),
                    named = made("named", "DNS:localhost");
  const auto answer = [&](const std::string& shown, const std::string& trusted,
                          const std::string& host) {
    ServerOptions options;
    options.tls = system::TlsServer::load(shown, shown.substr(0, shown.size() - 3) + "key").value();
    HttpServer server([](const Request&, const Body&) { return Reply{.bytes = "page"}; },
                      std::move(options));
    EXPECT_TRUE(server.listen({}, "--at"));
    const std::string url = server.url();
    return HttpClient::open("https://" + host + url.substr(url.rfind(':')), {.authority = trusted})
        .value()
        .ask("GET", "/");
  };
  EXPECT_EQ(answer(own, own, "127.0.0.1").body, "page");
  EXPECT_EQ(answer(named, named, "localhost").body, "page");
  const std::string expected =
      "the server does not answer: this computer does not trust its certificate; --ca names a "
      "further authority";
  EXPECT_EQ(answer(own, other, "127.0.0.1").error, expected) << "another authority";
  EXPECT_EQ(answer(own, "", "127.0.0.1").error, expected) << "none of the system's";
  EXPECT_EQ(answer(other, other, "127.0.0.1").error, expected) << "of another address";
  EXPECT_EQ(answer(named, named, "127.0.0.1").error, expected) << "of a name";
  EXPECT_EQ(answer(own, own, "localhost").error, expected) << "of an address";
  EXPECT_EQ(HttpClient::open("https://x", {.authority = folder / "none.pem"}).error().code,
            Errc::input);
}

}  // namespace
}  // namespace mirocup::web
