// Ranks of a launcher are for clusters, which do not run Windows: there a study is started once, or in parts.
#include "os/line_socket.hpp"

#include "math/errors.hpp"

#include <utility>

namespace terp {

LineSocket::LineSocket(int descriptor) : descriptor_(descriptor) {}
LineSocket::~LineSocket() = default;
LineSocket::LineSocket(LineSocket&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
bool LineSocket::send(std::string_view) { return false; }
LineSocket::Got LineSocket::receive(std::string&, int) { return Got::gone; }
bool LineSocket::other_end_closed() const { return true; }
std::optional<std::string> LineSocket::cut_line() { return std::nullopt; }

std::optional<LineSocket> connect_to(const std::string&, int, int) { return std::nullopt; }
std::vector<std::string> own_addresses() { return {"127.0.0.1"}; }
std::string machine_name() { return ""; }

LineServer::LineServer()
{
  throw FileError(
      "ranks of a launcher cannot share a study on Windows\n  Start it once, with -j, or in parts: --part K/N");
}
LineServer::~LineServer() = default;
std::vector<LineServer::Event> LineServer::wait(int) { return {}; }
bool LineServer::send(int, std::string_view) { return false; }
void LineServer::close(int) {}
void LineServer::accept_all() {}
void LineServer::listen_to(int, int) {}

}  // namespace terp
