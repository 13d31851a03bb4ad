// Receiving never waits longer than it was told; sending waits for as long as the other end lives and does not read. A
// connection is known by its number, not by its descriptor, which the system gives to a later one again. wait() takes
// new connections on the way, and reports the end of one after its last line.

#include "os/line_socket.hpp"

#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <arpa/inet.h>
#include <fcntl.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

namespace terp {
namespace {

constexpr std::size_t longest_line = 1 << 20;
constexpr int listener_id = 0;

[[noreturn]] void throw_socket_error(const char* what)
{
  throw std::runtime_error(std::string(what) + ": " + std::generic_category().message(errno));
}

/// Lines leave at once. A machine that has lost its power answers no more: that is noticed after two minutes.
void set_options(int descriptor)
{
  const auto set = [&](int level, int option, int value) {
    ::setsockopt(descriptor, level, option, &value, sizeof value);
  };
  set(IPPROTO_TCP, TCP_NODELAY, 1);
  set(SOL_SOCKET, SO_KEEPALIVE, 1);
  set(IPPROTO_TCP, TCP_KEEPIDLE, 60);
  set(IPPROTO_TCP, TCP_KEEPINTVL, 10);
  set(IPPROTO_TCP, TCP_KEEPCNT, 6);
}

short poll_for(int descriptor, short events, int wait_ms)
{
  pollfd request{.fd = descriptor, .events = events, .revents = 0};
  return ::poll(&request, 1, wait_ms) > 0 ? request.revents : short{0};
}

/// One connection per worker: as many as the system lets this user have.
void raise_limit_of_descriptors()
{
  rlimit limit = {};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace

LineSocket::LineSocket(int descriptor) : descriptor_(descriptor) { set_options(descriptor); }

LineSocket::~LineSocket()
{
  if (descriptor_ >= 0) ::close(descriptor_);
}

LineSocket::LineSocket(LineSocket&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), received_(std::move(other.received_))
{
}

bool LineSocket::send(std::string_view line)
{
  std::string text(line);
  text += '\n';
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t n = ::send(descriptor_, rest.data(), rest.size(), MSG_NOSIGNAL);
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) rest.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

std::optional<std::string> LineSocket::cut_line()
{
  const std::size_t end = received_.find('\n');
  if (end == std::string::npos) return std::nullopt;
  std::string line = received_.substr(0, end);
  received_.erase(0, end + 1);
  return line;
}

LineSocket::Got LineSocket::receive(std::string& line, int wait_ms)
{
  for (;;) {
    if (auto whole = cut_line()) return line = std::move(*whole), Got::line;
    if (received_.size() > longest_line) return Got::gone;
    if (poll_for(descriptor_, POLLIN, wait_ms) == 0) return Got::nothing;
    std::array<char, 4096> block;
    const ssize_t n = ::recv(descriptor_, block.data(), block.size(), MSG_DONTWAIT);
    if (n < 0 && (errno == EINTR || errno == EAGAIN)) return Got::nothing;
    if (n <= 0) return Got::gone;
    received_.append(block.data(), static_cast<std::size_t>(n));
    wait_ms = 0;
  }
}

bool LineSocket::other_end_closed() const
{
  return (poll_for(descriptor_, POLLRDHUP, 0) & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
}

std::optional<LineSocket> connect_to(const std::string& address, int port, int wait_ms)
{
  sockaddr_in place = {};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  if (::inet_pton(AF_INET, address.c_str(), &place.sin_addr) != 1) return std::nullopt;
  const int descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) return std::nullopt;
  LineSocket socket(descriptor);
  if (::connect(descriptor, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0 && errno != EINPROGRESS)
    return std::nullopt;
  int error = 0;
  socklen_t size = sizeof error;
  if (poll_for(descriptor, POLLOUT, wait_ms) == 0 ||
      ::getsockopt(descriptor, SOL_SOCKET, SO_ERROR, &error, &size) != 0 || error != 0)
    return std::nullopt;
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  return socket;
}

std::vector<std::string> own_addresses()
{
  std::vector<std::string> addresses;
  ifaddrs* all = nullptr;
  if (::getifaddrs(&all) == 0) {
    for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
      if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET) continue;
      if ((one->ifa_flags & IFF_LOOPBACK) != 0 || (one->ifa_flags & IFF_UP) == 0) continue;
      std::array<char, INET_ADDRSTRLEN> text = {};
      const auto* place = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
      if (::inet_ntop(AF_INET, &place->sin_addr, text.data(), text.size()) != nullptr)
        addresses.emplace_back(text.data());
    }
    ::freeifaddrs(all);
  }
  addresses.emplace_back("127.0.0.1");
  return addresses;
}

std::string machine_name()
{
  std::array<char, 256> name = {};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

LineServer::LineServer()
{
  raise_limit_of_descriptors();
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  events_ = ::epoll_create1(EPOLL_CLOEXEC);
  sockaddr_in place = {};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_ANY);
  socklen_t size = sizeof place;
  auto* const address = reinterpret_cast<sockaddr*>(&place);
  if (listener_ < 0 || events_ < 0 || ::bind(listener_, address, size) != 0 || ::listen(listener_, SOMAXCONN) != 0 ||
      ::getsockname(listener_, address, &size) != 0)
    throw_socket_error("cannot listen to other processes");
  port_ = ntohs(place.sin_port);
  listen_to(listener_, listener_id);
}

LineServer::~LineServer()
{
  if (listener_ >= 0) ::close(listener_);
  if (events_ >= 0) ::close(events_);
}

void LineServer::listen_to(int descriptor, int who)
{
  epoll_event event = {};
  event.events = EPOLLIN;
  event.data.fd = who;
  if (::epoll_ctl(events_, EPOLL_CTL_ADD, descriptor, &event) != 0) throw_socket_error("cannot listen to a process");
}

void LineServer::accept_all()
{
  for (;;) {
    const int descriptor = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (descriptor < 0 && (errno == EMFILE || errno == ENFILE))
      throw_socket_error("the system grants no more connections (ulimit -n)");
    if (descriptor < 0) return;
    const auto place = others_.emplace(++last_, LineSocket(descriptor)).first;
    listen_to(descriptor, place->first);
  }
}

std::vector<LineServer::Event> LineServer::wait(int wait_ms)
{
  std::array<epoll_event, 256> ready = {};
  const int n = ::epoll_wait(events_, ready.data(), static_cast<int>(ready.size()), wait_ms);
  std::vector<Event> found;
  for (int k = 0; k < n; ++k) {
    const int who = ready[static_cast<std::size_t>(k)].data.fd;
    if (who == listener_id) {
      accept_all();
      continue;
    }
    LineSocket& socket = others_.at(who);
    for (;;) {
      Event event{.who = who};
      event.got = socket.receive(event.line, 0);
      if (event.got == LineSocket::Got::nothing) break;
      found.push_back(std::move(event));
      if (found.back().got == LineSocket::Got::gone) break;
    }
    if (!found.empty() && found.back().who == who && found.back().got == LineSocket::Got::gone) close(who);
  }
  return found;
}

bool LineServer::send(int who, std::string_view line)
{
  const auto place = others_.find(who);
  return place != others_.end() && place->second.send(line);
}

void LineServer::close(int who) { others_.erase(who); }

}  // namespace terp
