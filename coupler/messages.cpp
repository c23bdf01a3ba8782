#include "coupler/messages.h"

#include <type_traits>
#include <utility>

#include "coupler/base/is_vector.h"
#include "coupler/byte_stream.h"
#include "coupler/message_fields.h"

namespace footfall {
namespace {

constexpr std::uint32_t kMagic = 0x4c465446;  // "FTFL"

template <class T>
inline constexpr bool kIsMatrix = std::is_base_of_v<Eigen::PlainObjectBase<T>, T>;

// Values: numbers, true or false as one byte, texts, matrices; items behind their count; fields in the order of their
// list.
template <class T>
void write(ByteWriter& out, const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    out.number<std::uint8_t>(value ? 1 : 0);
  } else if constexpr (std::is_arithmetic_v<T>) {
    out.number(value);
  } else if constexpr (std::is_same_v<T, std::string>) {
    out.text(value);
  } else if constexpr (std::is_same_v<T, ModalBoundary>) {
    write(out, taken_apart(value));
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

// No value takes fewer bytes.
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
// What the bytes are read into, where there is no default.
template <class T>
T blank() {
  return T();
}
template <>
CoupledBody blank() {
  return {ModalBoundary("", Eigen::Matrix3Xd::Zero(3, 1), {}), BodyMotion()};
}

// Fields that must fit each other.
template <class T>
void check_fit(const T&) {}
void check_fit(const BodyMotion& m) {
  if (m.da.size() != m.a.size() || m.dda.size() != m.a.size())
    throw ProtocolError("a body has " + std::to_string(m.a.size()) + " modal coordinates but " +
                        std::to_string(m.da.size()) + " rates");
}
void check_fit(const CoupledBody& body) {
  if (body.initial.mode_count() != body.boundary.mode_count())
    throw ProtocolError("body \"" + body.boundary.name() + "\" has " + std::to_string(body.boundary.mode_count()) +
                        " mode shapes but " + std::to_string(body.initial.mode_count()) + " modal coordinates");
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
    value = put_together(std::move(parts));
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

std::string foreign_protocol(const std::string& partner, std::int32_t protocol) {
  return partner + " speaks protocol version " + std::to_string(protocol) + ", this program version " +
         std::to_string(kProtocolVersion) + ": build both from the same footfall";
}

MessageHead read_head(ByteReader& in, MessageKind expected) {
  if (in.number<std::uint32_t>() != kMagic) throw ProtocolError("these are not bytes of footfall");
  const auto kind = in.number<std::int32_t>();
  const auto protocol = in.number<std::int32_t>();
  const auto status = in.number<std::int32_t>();
  const bool readable = expected == MessageKind::kHello || expected == MessageKind::kClose;
  if (protocol != kProtocolVersion && !readable) throw ProtocolError(foreign_protocol("the partner", protocol));
  if (kind != static_cast<std::int32_t>(expected))
    throw ProtocolError("got " + message_name(static_cast<MessageKind>(kind)) + " instead");
  if (status < static_cast<std::int32_t>(Status::kOk) || status > static_cast<std::int32_t>(Status::kInterrupted))
    throw ProtocolError("status word " + std::to_string(status) + " has no meaning");
  return {protocol, static_cast<Status>(status)};
}

}  // namespace

BoundaryParts taken_apart(const ModalBoundary& b) {
  return {b.name(), b.rho0(), b.triangles(), b.segments(), b.Phi(), b.Psi()};
}

ModalBoundary put_together(BoundaryParts parts) {
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
    case MessageKind::kKept: return "Kept";
  }
  return "message of unknown kind " + std::to_string(static_cast<std::int32_t>(kind));
}

void check_partner(const std::string& partner, std::int32_t protocol, const std::string& version) {
  if (protocol != kProtocolVersion) throw ProtocolError(foreign_protocol(partner, protocol));
  if (version != kFootfallVersion)
    throw ProtocolError(partner + " is footfall " + version + ", this program footfall " + kFootfallVersion +
                        ": build both from the same footfall");
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
template void pack(const Kept&, Bytes&);
template void pack(const Close&, Bytes&);

template void unpack(const Bytes&, Hello&);
template void unpack(const Bytes&, Geometry&);
template void unpack(const Bytes&, Start&);
template void unpack(const Bytes&, Accept&);
template void unpack(const Bytes&, Motion&);
template void unpack(const Bytes&, Load&);
template void unpack(const Bytes&, Kept&);
template void unpack(const Bytes&, Close&);

}  // namespace footfall
