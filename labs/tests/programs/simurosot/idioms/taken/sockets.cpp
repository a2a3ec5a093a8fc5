#include <winsock2.h>
#include <ws2tcpip.h>
#pragma comment(lib, "ws2_32.lib")
void f()
{
  WSADATA data; WSAStartup(MAKEWORD(2, 2), &data);
  SOCKET s = socket(AF_INET, SOCK_DGRAM, 0);
  SOCKADDR_IN to; to.sin_family = AF_INET; to.sin_port = htons(3);
  HOSTENT *host = gethostbyname("localhost"); memcpy(&to.sin_addr, host->h_addr, host->h_length);
  to.sin_addr.S_un.S_addr = inet_addr("127.0.0.1"); to.sin_addr.s_addr = htonl(INADDR_ANY);
  bind(s, (SOCKADDR *)&to, sizeof to); sendto(s, "x", 1, 0, (sockaddr *)&to, sizeof to);
  char text[4]; int size = sizeof to; recvfrom(s, text, 4, 0, (SOCKADDR *)&to, &size);
  u_long one = 1; ioctlsocket(s, FIONBIO, &one);
  if (connect(s, (SOCKADDR *)&to, sizeof to) == SOCKET_ERROR) WSAGetLastError();
  shutdown(s, SD_SEND); closesocket(s); WSACleanup();
}
