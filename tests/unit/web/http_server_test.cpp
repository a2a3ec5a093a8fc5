// SPDX-License-Identifier: MIT
//
// Catches a viewer that takes the server's memory or one of its threads for ever.
#include "web/http_server.hpp"

#include <gtest/gtest.h>

#include <string>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace mirocup::web {
namespace {

struct Answer {
  std::string text;
  std::size_t taken = 0;  // bytes of the request
};

// Lets a server of one page answer the request, of which it takes as much as it likes.
Answer answer_to(const std::string& request) {
  BoundedServer server;
  server.set_payload_max_length(1024);
  server.Get("/", [](const httplib::Request&, httplib::Response& response) {
    response.set_content(std::string(1000, 'p'), "text/plain");
  });
  int ends[2];
  EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  Answer answer;
  std::thread viewer([&answer, &request, end = ends[1]] {
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
  });
  (void)server.answer(ends[0]);
  close(ends[0]);
  viewer.join();
  close(ends[1]);
  return answer;
}

TEST(BoundedServer, AnswersARequest) {
  const Answer answer = answer_to("GET / HTTP/1.1\r\nHost: x\r\n\r\n");
  EXPECT_EQ(answer.text.find("HTTP/1.1 200"), 0u) << answer.text;
  EXPECT_NE(answer.text.find(std::string(1000, 'p')), std::string::npos);
}

TEST(BoundedServer, TakesNoMoreThanARequestNeeds) {
  constexpr std::size_t size = 16u << 20;
  // What the connection itself holds beside the server.
  constexpr std::size_t most = 1u << 20;
  std::string headers = "GET / HTTP/1.1\r\n";
  while (headers.size() < size) headers += "X: " + std::string(1000, 'y') + "\r\n";
  EXPECT_LT(answer_to(headers).taken, most);
  EXPECT_LT(answer_to(std::string(size, 'a')).taken, most);
  EXPECT_LT(answer_to("GET / HTTP/1.1\r\nX: " + std::string(size, 'a')).taken, most);
  const std::string body(size, 'a');
  EXPECT_LT(answer_to("POST / HTTP/1.1\r\nContent-Length: 16777216\r\n\r\n" + body).taken, most);
  EXPECT_LT(
      answer_to("POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n1000000\r\n" + body).taken,
      most);
  EXPECT_LT(
      answer_to("POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n" + std::string(size, '1'))
          .taken,
      most);
}

// A thousand ranges of a page are a thousand pages.
TEST(BoundedServer, SendsAPageOnceWhateverRangesAreAskedFor) {
  std::string request = "GET / HTTP/1.1\r\nRange: bytes=0-";
  for (int i = 0; i < 1000; ++i) request += ",0-";
  const Answer answer = answer_to(request + "\r\n\r\n");
  EXPECT_EQ(answer.text.find("HTTP/1.1 200"), 0u) << answer.text.substr(0, 100);
  EXPECT_LT(answer.text.size(), 2000u);
}

// Catches two servers that both listen on one port and get a part of its viewers each.
TEST(HttpServer, HasItsPortForItself) {
  HttpServer first;
  ASSERT_TRUE(first.listen({}, "--at"));
  const std::string url = first.url();
  const int port = std::stoi(url.substr(url.rfind(':') + 1));
  HttpServer second;
  const auto listening = second.listen({.port = port}, "--at");
  ASSERT_FALSE(listening);
  EXPECT_EQ(listening.error().what,
            "--at: 127.0.0.1 port " + std::to_string(port) + " is in use: take another port");
}

}  // namespace
}  // namespace mirocup::web
