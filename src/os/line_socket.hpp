// Lines of text between processes, on one machine or several, over TCP: one listens, the others connect. An end that
// dies, or whose machine does, is noticed.
// Not for: what the lines say, and who may say it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// One end of a connection.
class LineSocket {
 public:
  enum class Got { line, nothing, gone };

  explicit LineSocket(int descriptor);  ///< a connected socket, which it owns
  ~LineSocket();
  LineSocket(LineSocket&& other) noexcept;
  LineSocket(const LineSocket&) = delete;
  LineSocket& operator=(const LineSocket&) = delete;
  LineSocket& operator=(LineSocket&&) = delete;

  /// Without the end of the line. False: the other end is gone.
  bool send(std::string_view line);
  /// Waits up to wait_ms for a whole line. Gone: the other end closed, died, or sends what is no line.
  Got receive(std::string& line, int wait_ms);
  /// The other end has closed; lines that it sent before may still be received.
  bool other_end_closed() const;
  int descriptor() const { return descriptor_; }

 private:
  std::optional<std::string> cut_line();

  int descriptor_ = -1;
  std::string received_;
};

/// address: "192.0.2.7". None: nobody listens there, or no answer came within wait_ms.
std::optional<LineSocket> connect_to(const std::string& address, int port, int wait_ms);

/// IPv4 addresses of this machine that others may reach, and 127.0.0.1 last.
std::vector<std::string> own_addresses();

/// Name of this machine in its network.
std::string machine_name();

/// Listens at a port that the system chooses.
class LineServer {
 public:
  struct Event {
    int who = 0;               ///< number of the connection; no two have the same
    LineSocket::Got got = {};  ///< line or gone; after gone it has no connection
    std::string line = {};
  };

  /// Throws std::runtime_error where the system grants no socket.
  LineServer();
  ~LineServer();
  LineServer(const LineServer&) = delete;
  LineServer& operator=(const LineServer&) = delete;

  int port() const { return port_; }
  /// What came within wait_ms at most, in order; new connections are taken on the way. Throws std::runtime_error where
  /// the system grants no more connections.
  std::vector<Event> wait(int wait_ms);
  /// False: there is no such connection any more.
  bool send(int who, std::string_view line);
  void close(int who);

 private:
  void accept_all();
  void listen_to(int descriptor, int who);

  int listener_ = -1, events_ = -1, port_ = 0, last_ = 0;
  std::map<int, LineSocket> others_;
};

}  // namespace terp
