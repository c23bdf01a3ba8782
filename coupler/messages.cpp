// Bytes of messages: one recursive writer and reader walks the lists of message_fields.h. The same walk finds numbers
// that are not finite.

#include "coupler/messages.h"

#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

#include "coupler/base/field_list.h"
#include "coupler/base/text.h"
#include "coupler/message_fields.h"

namespace footfall {
namespace {

// Numbers, texts and matrices to bytes. Both programs run on the same kind of machine: native byte order.
class ByteWriter {
 public:
  // Appends to `out`, which is cleared first but keeps its memory.
  explicit ByteWriter(std::vector<std::uint8_t>& out) : out_(out) { out_.clear(); }

  template <class Number>
  void number(Number value) {
    static_assert(std::is_arithmetic_v<Number>);
    raw(&value, sizeof value);
  }
  void text(const std::string& value) {
    number<std::uint64_t>(value.size());
    raw(value.data(), value.size());
  }
  // Rows, columns, then the coefficients column by column.
  template <class Derived>
  void matrix(const Eigen::PlainObjectBase<Derived>& value) {
    number<std::int64_t>(value.rows());
    number<std::int64_t>(value.cols());
    raw(value.data(), static_cast<std::size_t>(value.size()) * sizeof(typename Derived::Scalar));
  }

 private:
  void raw(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    out_.insert(out_.end(), bytes, bytes + size);
  }
  std::vector<std::uint8_t>& out_;
};

// And back. Every read checks how many bytes are left; ProtocolError when the bytes are inconsistent.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size) : next_(data), left_(size) {}

  template <class Number>
  Number number() {
    static_assert(std::is_arithmetic_v<Number>);
    Number value{};
    raw(&value, sizeof value);
    return value;
  }
  // A number of items, each of at least `bytes_each` of the bytes that are left.
  std::size_t count(std::size_t bytes_each) {
    const auto value = number<std::uint64_t>();
    if (value > left_ / bytes_each) throw ProtocolError(code::kMessageDamaged, "a count is larger than the message");
    return static_cast<std::size_t>(value);
  }
  void text(std::string& value) {
    value.resize(count(1));
    raw(value.data(), value.size());
  }
  template <class Derived>
  void matrix(Eigen::PlainObjectBase<Derived>& value) {
    const auto rows = number<std::int64_t>();
    const auto cols = number<std::int64_t>();
    constexpr int kRows = Derived::RowsAtCompileTime, kCols = Derived::ColsAtCompileTime;
    const std::uint64_t most = left_ / sizeof(typename Derived::Scalar);
    const bool too_large = rows > 0 && static_cast<std::uint64_t>(cols) > most / static_cast<std::uint64_t>(rows);
    const bool too_long = static_cast<std::uint64_t>(rows) > kMostRows || static_cast<std::uint64_t>(cols) > kMostRows;
    if (rows < 0 || cols < 0 || too_large || too_long || (kRows != Eigen::Dynamic && rows != kRows) ||
        (kCols != Eigen::Dynamic && cols != kCols))
      throw ProtocolError(code::kMessageDamaged, "a matrix of " + std::to_string(rows) + " x " + std::to_string(cols) +
                                                     " is not possible here");
    value.resize(rows, cols);
    raw(value.data(), static_cast<std::size_t>(value.size()) * sizeof(typename Derived::Scalar));
  }
  // Throws when bytes are left.
  void finish() const {
    if (left_ != 0) throw ProtocolError(code::kMessageDamaged, std::to_string(left_) + " bytes are left after its end");
  }

 private:
  static constexpr std::uint64_t kMostRows = std::uint64_t{1} << 26;  // of a matrix without coefficients
  void raw(void* data, std::size_t size) {
    if (size > left_) throw ProtocolError(code::kMessageDamaged, "the message is cut short");
    if (size > 0) std::memcpy(data, next_, size);
    next_ += size;
    left_ -= size;
  }
  const std::uint8_t* next_;
  std::size_t left_;
};

constexpr std::uint32_t kMagic = 0x4c465446;  // "FTFL"

template <class T>
inline constexpr bool kIsMatrix = std::is_base_of_v<Eigen::PlainObjectBase<T>, T>;

// Values are numbers, bools as one byte, texts and matrices. Items follow their count, fields the order of their list.
template <class T>
void write(ByteWriter& out, const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    out.number<std::uint8_t>(value ? 1 : 0);
  } else if constexpr (std::is_arithmetic_v<T>) {
    out.number(value);
  } else if constexpr (std::is_same_v<T, std::string>) {
    out.text(value);
  } else if constexpr (std::is_same_v<T, ModalBoundary>) {
    write(out, parts_of(value));
  } else if constexpr (kIsVector<T>) {
    out.number<std::uint64_t>(value.size());
    for (const auto& item : value) write(out, item);
  } else if constexpr (kIsMatrix<T>) {
    out.matrix(value);
  } else {
    for_each_field<T>([&](const auto& field) {
      if constexpr (!kInHead<std::decay_t<decltype(field)>>) write(out, value.*field.member);
    });
  }
}

// Lower bound of the bytes of a value.
template <class T>
constexpr std::size_t fewest_bytes() {
  if constexpr (std::is_same_v<T, bool>) {
    return sizeof(std::uint8_t);
  } else if constexpr (std::is_arithmetic_v<T>) {
    return sizeof(T);
  } else if constexpr (kHasFields<T>) {
    std::size_t sum = 0;
    for_each_field<T>([&](const auto& field) {
      if constexpr (!kInHead<std::decay_t<decltype(field)>>)
        sum += fewest_bytes<std::decay_t<decltype(std::declval<T&>().*field.member)>>();
    });
    return sum;
  } else if constexpr (std::is_same_v<T, ModalBoundary>) {
    return fewest_bytes<BoundaryParts>();
  } else if constexpr (kIsMatrix<T>) {
    constexpr bool kFixed = T::SizeAtCompileTime != Eigen::Dynamic;
    return 2 * sizeof(std::int64_t) +
           (kFixed ? static_cast<std::size_t>(T::SizeAtCompileTime) * sizeof(typename T::Scalar) : 0);
  } else {
    return sizeof(std::uint64_t);  // the count of a text or a list
  }
}
// The value into which bytes are read, also for types without default constructor.
template <class T>
T blank() {
  return T();
}
template <>
CoupledBody blank() {
  return {ModalBoundary("", Eigen::Matrix3Xd::Zero(3, 1), {}), BodyMotion()};
}

// Checks fields that depend on each other.
template <class T>
void check_fit(const T&) {}
void check_fit(const BodyMotion& m) {
  if (m.da.size() != m.a.size() || m.dda.size() != m.a.size())
    throw ProtocolError(code::kMessageDamaged, "a body has " + std::to_string(m.a.size()) + " modal coordinates but " +
                                                   std::to_string(m.da.size()) + " rates");
}
void check_fit(const CoupledBody& body) {
  if (body.initial.mode_count() != body.boundary.mode_count())
    throw ProtocolError(code::kMessageDamaged, "body \"" + body.boundary.name() + "\" has " +
                                                   std::to_string(body.boundary.mode_count()) + " mode shapes but " +
                                                   std::to_string(body.initial.mode_count()) + " modal coordinates");
}

template <class T>
void read(ByteReader& in, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    value = in.number<std::uint8_t>() != 0;
  } else if constexpr (std::is_arithmetic_v<T>) {
    value = in.number<T>();
  } else if constexpr (std::is_same_v<T, std::string>) {
    in.text(value);
  } else if constexpr (std::is_same_v<T, ModalBoundary>) {
    BoundaryParts parts;
    read(in, parts);
    value = boundary_of(std::move(parts));
  } else if constexpr (kIsVector<T>) {
    using Item = typename T::value_type;
    value.resize(in.count(fewest_bytes<Item>()), blank<Item>());
    for (Item& item : value) read(in, item);
  } else if constexpr (kIsMatrix<T>) {
    in.matrix(value);
  } else {
    for_each_field<T>([&](const auto& field) {
      if constexpr (!kInHead<std::decay_t<decltype(field)>>) read(in, value.*field.member);
    });
    check_fit(value);
  }
}

void write_head(ByteWriter& out, MessageKind kind, const MessageHead& head) {
  out.number(kMagic);
  out.number(static_cast<std::int32_t>(kind));
  out.number(head.protocol);
  out.number(static_cast<std::int32_t>(head.status));
}

std::string other_protocol(const std::string& partner, std::int32_t protocol) {
  return partner + " speaks protocol version " + std::to_string(protocol) + ", this program version " +
         std::to_string(kProtocolVersion) + ": build both from the same footfall";
}

MessageHead read_head(ByteReader& in, MessageKind expected) {
  if (in.number<std::uint32_t>() != kMagic)
    throw ProtocolError(code::kMessageDamaged, "it does not begin as a message of footfall");
  const auto kind = in.number<std::int32_t>();
  const auto protocol = in.number<std::int32_t>();
  const auto status = in.number<std::int32_t>();
  const bool readable = expected == MessageKind::kHello || expected == MessageKind::kClose;
  if (protocol != kProtocolVersion && !readable)
    throw ProtocolError(code::kProtocolsDiffer, other_protocol("the partner", protocol));
  if (kind != static_cast<std::int32_t>(expected))
    throw ProtocolError(code::kMessageUnexpected, message_name(static_cast<MessageKind>(kind)) + " arrived instead");
  if (status < static_cast<std::int32_t>(Status::kOk) || status > static_cast<std::int32_t>(Status::kInterrupted))
    throw ProtocolError(code::kMessageDamaged, "status word " + std::to_string(status) + " is unknown");
  return {protocol, static_cast<Status>(status)};
}

// place: "" for the number itself, ".x" or "[3].x" for one within a part.
struct Found {
  bool bad = false;
  std::string place;
};

template <class T>
Found search(const T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    return {!std::isfinite(value), ""};
  } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
    return {};
  } else if constexpr (std::is_base_of_v<Eigen::PlainObjectBase<T>, T>) {
    if constexpr (std::is_floating_point_v<typename T::Scalar>) return {!value.allFinite(), ""};
    return {};
  } else if constexpr (std::is_same_v<T, ModalBoundary>) {
    return search(parts_of(value));
  } else if constexpr (kIsVector<T>) {
    for (std::size_t i = 0; i < value.size(); ++i)
      if (Found found = search(value[i]); found.bad) return {true, "[" + std::to_string(i) + "]" + found.place};
    return {};
  } else {
    Found first;
    for_each_field<T>([&](const auto& field) {
      if (first.bad) return;
      if constexpr (!kInHead<std::decay_t<decltype(field)>>)
        if (Found found = search(value.*field.member); found.bad)
          first = {true, "." + std::string(field.name) + found.place};
    });
    return first;
  }
}

constexpr double kSameGravity = 1e-6;  // relative to the gravity of the scene

std::string gravity_text(const Eigen::Vector3d& v) {
  return "(" + number_text(v[0]) + ", " + number_text(v[1]) + ", " + number_text(v[2]) + ") m/s2";
}

}  // namespace

BoundaryParts parts_of(const ModalBoundary& b) {
  return {b.name(), b.rho0(), b.triangles(), b.segments(), b.Phi(), b.Psi()};
}

ModalBoundary boundary_of(BoundaryParts parts) {
  try {
    return ModalBoundary(std::move(parts.name), std::move(parts.rho0), std::move(parts.triangles),
                         std::move(parts.segments), std::move(parts.Phi), std::move(parts.Psi));
  } catch (const InputError& error) {
    throw ProtocolError(error.what());
  }
}

std::string message_name(MessageKind kind) {
  switch (kind) {
    case MessageKind::kHello: return "Hello";
    case MessageKind::kGeometry: return "Geometry";
    case MessageKind::kStart: return "Start";
    case MessageKind::kAccept: return "Accept";
    case MessageKind::kMotion: return "Motion";
    case MessageKind::kLoad: return "Load";
    case MessageKind::kClose: return "Close";
    case MessageKind::kCheckpointDone: return "CheckpointDone";
  }
  return "message of unknown kind " + std::to_string(static_cast<std::int32_t>(kind));
}

void check_partner(const std::string& partner, std::int32_t protocol, const std::string& version) {
  if (protocol != kProtocolVersion) throw ProtocolError(code::kProtocolsDiffer, other_protocol(partner, protocol));
  if (version != kFootfallVersion)
    throw ProtocolError(code::kVersionsDiffer, partner + " is footfall " + version + ", this program footfall " +
                                                   kFootfallVersion + ": build both from the same footfall");
}

template <class Message>
void pack(const Message& message, Bytes& bytes) {
  MessageHead head;
  for_each_field<Message>([&](const auto& field) {
    if constexpr (kInHead<std::decay_t<decltype(field)>>) head.*field.in_head = message.*field.member;
  });
  ByteWriter out(bytes);
  write_head(out, Message::kKind, head);
  write(out, message);
}

template <class Message>
void unpack(const Bytes& bytes, Message& message) {
  try {
    ByteReader in(bytes.data(), bytes.size());
    const MessageHead head = read_head(in, Message::kKind);
    for_each_field<Message>([&](const auto& field) {
      if constexpr (kInHead<std::decay_t<decltype(field)>>) message.*field.member = head.*field.in_head;
    });
    read(in, message);
    in.finish();
  } catch (const ProtocolError& error) {
    throw ProtocolError("message " + message_name(Message::kKind) + ": " + error.what());
  }
}

template void pack(const Hello&, Bytes&);
template void pack(const Geometry&, Bytes&);
template void pack(const Start&, Bytes&);
template void pack(const Accept&, Bytes&);
template void pack(const Motion&, Bytes&);
template void pack(const Load&, Bytes&);
template void pack(const CheckpointDone&, Bytes&);
template void pack(const Close&, Bytes&);

template void unpack(const Bytes&, Hello&);
template void unpack(const Bytes&, Geometry&);
template void unpack(const Bytes&, Start&);
template void unpack(const Bytes&, Accept&);
template void unpack(const Bytes&, Motion&);
template void unpack(const Bytes&, Load&);
template void unpack(const Bytes&, CheckpointDone&);
template void unpack(const Bytes&, Close&);

template <class Message>
std::string first_not_finite(const Message& message) {
  const Found found = search(message);
  return found.bad ? found.place.substr(1) : "";
}

template std::string first_not_finite(const Geometry&);
template std::string first_not_finite(const Start&);
template std::string first_not_finite(const Accept&);
template std::string first_not_finite(const Motion&);
template std::string first_not_finite(const Load&);
template std::string first_not_finite(const BodyMotion&);
template std::string first_not_finite(const BodyLoad&);

bool is_same_gravity(const Eigen::Vector3d& script, const Eigen::Vector3d& scene) {
  return (script - scene).norm() <= kSameGravity * scene.norm();
}

std::string gravity_differs(const Eigen::Vector3d& script, const Eigen::Vector3d& scene, const std::string& when) {
  if (script.isZero(0.0) && when.empty())
    return "the LIGGGHTS script has no fix gravity, the scene has gravity = " + gravity_text(scene) +
           ": the grains would have no weight";
  return "the LIGGGHTS script has the gravity " + gravity_text(script) + when + " (fix gravity), the scene " +
         gravity_text(scene) +
         " (gravity). Make them equal, or allow the grains their own gravity: fix ID all couple/mbd every N gravity "
         "script ...";
}

}  // namespace footfall
