#include "coupler/messages.h"

#include <utility>

#include "coupler/byte_stream.h"

namespace footfall {
namespace {

constexpr std::uint32_t kMagic = 0x4c465446;  // "FTFL"

// Head of every message: magic, kind, protocol, status. Its layout never changes between protocol versions.
void write_head(ByteWriter& out, MessageKind kind, std::int32_t protocol, Status status) {
  out.number(kMagic);
  out.number(static_cast<std::int32_t>(kind));
  out.number(protocol);
  out.number(static_cast<std::int32_t>(status));
}

struct Head {
  std::int32_t protocol;
  Status status;
};

Head read_head(ByteReader& in, MessageKind expected) {
  if (in.number<std::uint32_t>() != kMagic) throw ProtocolError("these are not bytes of footfall");
  const auto kind = in.number<std::int32_t>();
  const auto protocol = in.number<std::int32_t>();
  const auto status = in.number<std::int32_t>();
  const bool readable = expected == MessageKind::kHello || expected == MessageKind::kClose;
  if (protocol != kProtocolVersion && !readable)
    throw ProtocolError("the partner speaks protocol version " + std::to_string(protocol) + ", this program version " +
                        std::to_string(kProtocolVersion) + ": build both from the same footfall");
  if (kind != static_cast<std::int32_t>(expected))
    throw ProtocolError("got " + message_name(static_cast<MessageKind>(kind)) + " instead");
  if (status < static_cast<std::int32_t>(Status::kOk) || status > static_cast<std::int32_t>(Status::kInterrupted))
    throw ProtocolError("status word " + std::to_string(status) + " has no meaning");
  return {protocol, static_cast<Status>(status)};
}

// Reads a whole message with `body(reader)`; every ProtocolError names the message.
template <class Body>
void read(const Bytes& bytes, MessageKind kind, Body body) {
  try {
    ByteReader in(bytes.data(), bytes.size());
    body(in, read_head(in, kind));
    in.finish();
  } catch (const ProtocolError& error) {
    throw ProtocolError("message " + message_name(kind) + ": " + error.what());
  }
}

void write(ByteWriter& out, const BodyMotion& m) {
  out.matrix(m.r);
  out.matrix(m.L);
  out.matrix(m.a);
  out.matrix(m.dr);
  out.matrix(m.w);
  out.matrix(m.da);
  out.matrix(m.ddr);
  out.matrix(m.dw);
  out.matrix(m.dda);
}

void read(ByteReader& in, BodyMotion& m) {
  in.matrix(m.r);
  in.matrix(m.L);
  in.matrix(m.a);
  in.matrix(m.dr);
  in.matrix(m.w);
  in.matrix(m.da);
  in.matrix(m.ddr);
  in.matrix(m.dw);
  in.matrix(m.dda);
  if (m.da.size() != m.a.size() || m.dda.size() != m.a.size())
    throw ProtocolError("a body has " + std::to_string(m.a.size()) + " modal coordinates but " +
                        std::to_string(m.da.size()) + " rates");
}

void write(ByteWriter& out, const MeanLoad& load) {
  out.matrix(load.F_W);
  out.matrix(load.T_B);
  out.matrix(load.Q_a);
  out.number(load.work);
  out.number(load.jump_work);
  out.matrix(load.impulse_W);
}

void read(ByteReader& in, MeanLoad& load) {
  in.matrix(load.F_W);
  in.matrix(load.T_B);
  in.matrix(load.Q_a);
  load.work = in.number<double>();
  load.jump_work = in.number<double>();
  in.matrix(load.impulse_W);
}

void write(ByteWriter& out, const ModalBoundary& b) {
  out.text(b.name());
  out.matrix(b.rho0());
  out.number<std::uint64_t>(b.triangles().size());
  for (const Eigen::Vector3i& t : b.triangles()) out.matrix(t);
  out.number<std::uint64_t>(b.segments().size());
  for (const BeamSegment& s : b.segments()) {
    out.number(s.start);
    out.number(s.end);
    out.number(s.radius);
    out.number(s.chain);
  }
  out.matrix(b.Phi());
  out.matrix(b.Psi());
}

ModalBoundary read_boundary(ByteReader& in) {
  std::string name;
  in.text(name);
  Eigen::Matrix3Xd rho0;
  in.matrix(rho0);
  std::vector<Eigen::Vector3i> triangles(in.count(sizeof(int) * 3));
  for (Eigen::Vector3i& t : triangles) in.matrix(t);
  std::vector<BeamSegment> segments(in.count(sizeof(double)));
  for (BeamSegment& s : segments) {
    s.start = in.number<int>();
    s.end = in.number<int>();
    s.radius = in.number<double>();
    s.chain = in.number<int>();
  }
  Eigen::MatrixXd Phi, Psi;
  in.matrix(Phi);
  in.matrix(Psi);
  try {
    return ModalBoundary(std::move(name), std::move(rho0), std::move(triangles), std::move(segments), std::move(Phi),
                         std::move(Psi));
  } catch (const InputError& error) {
    throw ProtocolError(error.what());
  }
}

}  // namespace

std::string message_name(MessageKind kind) {
  switch (kind) {
    case MessageKind::kHello: return "Hello";
    case MessageKind::kGeometry: return "Geometry";
    case MessageKind::kStart: return "Start";
    case MessageKind::kAccept: return "Accept";
    case MessageKind::kMotion: return "Motion";
    case MessageKind::kLoad: return "Load";
    case MessageKind::kClose: return "Close";
  }
  return "message of unknown kind " + std::to_string(static_cast<std::int32_t>(kind));
}

void check_partner(const std::string& partner, std::int32_t protocol, const std::string& version) {
  if (protocol != kProtocolVersion)
    throw ProtocolError(partner + " speaks protocol version " + std::to_string(protocol) + ", this program version " +
                        std::to_string(kProtocolVersion) + ": build both from the same footfall");
  if (version != kFootfallVersion)
    throw ProtocolError(partner + " is footfall " + version + ", this program footfall " + kFootfallVersion +
                        ": build both from the same footfall");
}

void pack(const Hello& message, Bytes& bytes) {
  ByteWriter out(bytes);
  write_head(out, MessageKind::kHello, message.protocol, Status::kOk);
  out.text(message.footfall_version);
  out.text(message.unit_style);
}

void unpack(const Bytes& bytes, Hello& message) {
  read(bytes, MessageKind::kHello, [&](ByteReader& in, const Head& head) {
    message.protocol = head.protocol;
    in.text(message.footfall_version);
    in.text(message.unit_style);
  });
}

void pack(const Geometry& message, Bytes& bytes) {
  ByteWriter out(bytes);
  write_head(out, MessageKind::kGeometry, kProtocolVersion, Status::kOk);
  out.text(message.footfall_version);
  out.number<std::uint64_t>(message.bodies.size());
  for (const CoupledBody& body : message.bodies) {
    write(out, body.boundary);
    write(out, body.initial);
  }
}

void unpack(const Bytes& bytes, Geometry& message) {
  read(bytes, MessageKind::kGeometry, [&](ByteReader& in, const Head&) {
    in.text(message.footfall_version);
    message.bodies.clear();
    const std::size_t bodies = in.count(sizeof(double));
    for (std::size_t i = 0; i < bodies; ++i) {
      ModalBoundary boundary = read_boundary(in);
      BodyMotion initial(boundary.mode_count());
      read(in, initial);
      if (initial.mode_count() != boundary.mode_count())
        throw ProtocolError("body \"" + boundary.name() + "\" has " + std::to_string(boundary.mode_count()) +
                            " mode shapes but " + std::to_string(initial.mode_count()) + " modal coordinates");
      message.bodies.push_back({std::move(boundary), std::move(initial)});
    }
  });
}

void pack(const Start& message, Bytes& bytes) {
  ByteWriter out(bytes);
  write_head(out, MessageKind::kStart, kProtocolVersion, Status::kOk);
  out.number(message.dt);
  out.number(message.n);
  out.number(message.step);
  out.number<std::uint64_t>(message.bodies.size());
  for (const std::string& name : message.bodies) out.text(name);
}

void unpack(const Bytes& bytes, Start& message) {
  read(bytes, MessageKind::kStart, [&](ByteReader& in, const Head&) {
    message.dt = in.number<double>();
    message.n = in.number<std::int32_t>();
    message.step = in.number<std::int64_t>();
    message.bodies.resize(in.count(sizeof(std::uint64_t)));
    for (std::string& name : message.bodies) in.text(name);
  });
}

void pack(const Accept& message, Bytes& bytes) {
  ByteWriter out(bytes);
  write_head(out, MessageKind::kAccept, kProtocolVersion, Status::kOk);
  out.text(message.scheme);
  out.number(message.t_end);
  out.number(message.t_start);
  out.number(message.n_max);
}

void unpack(const Bytes& bytes, Accept& message) {
  read(bytes, MessageKind::kAccept, [&](ByteReader& in, const Head&) {
    in.text(message.scheme);
    message.t_end = in.number<double>();
    message.t_start = in.number<double>();
    message.n_max = in.number<std::int32_t>();
  });
}

void pack(const Motion& message, Bytes& bytes) {
  ByteWriter out(bytes);
  write_head(out, MessageKind::kMotion, kProtocolVersion, Status::kOk);
  out.number(message.window);
  out.number(message.time);
  out.number(message.n);
  out.number<std::uint8_t>(message.last_window ? 1 : 0);
  out.number<std::uint64_t>(message.bodies.size());
  for (const BodyMotion& body : message.bodies) write(out, body);
}

void unpack(const Bytes& bytes, Motion& message) {
  read(bytes, MessageKind::kMotion, [&](ByteReader& in, const Head&) {
    message.window = in.number<std::int64_t>();
    message.time = in.number<double>();
    message.n = in.number<std::int32_t>();
    message.last_window = in.number<std::uint8_t>() != 0;
    message.bodies.resize(in.count(sizeof(double)));
    for (BodyMotion& body : message.bodies) read(in, body);
  });
}

void pack(const Load& message, Bytes& bytes) {
  ByteWriter out(bytes);
  write_head(out, MessageKind::kLoad, kProtocolVersion, Status::kOk);
  out.number(message.window);
  out.number(message.particles);
  out.number(message.wall_seconds);
  out.number<std::uint64_t>(message.bodies.size());
  for (const BodyLoad& body : message.bodies) {
    write(out, body.mean);
    out.number(body.contacts);
    out.number(body.contact_stiffness);
    out.number(body.max_overlap_over_radius);
    out.number<std::uint64_t>(body.tangent.size());
    for (const ContactTangent& tangent : body.tangent) {
      out.matrix(tangent.K);
      out.matrix(tangent.C);
    }
  }
}

void unpack(const Bytes& bytes, Load& message) {
  read(bytes, MessageKind::kLoad, [&](ByteReader& in, const Head&) {
    message.window = in.number<std::int64_t>();
    message.particles = in.number<std::int64_t>();
    message.wall_seconds = in.number<double>();
    message.bodies.resize(in.count(sizeof(double)));
    for (BodyLoad& body : message.bodies) {
      read(in, body.mean);
      body.contacts = in.number<std::int64_t>();
      body.contact_stiffness = in.number<double>();
      body.max_overlap_over_radius = in.number<double>();
      body.tangent.resize(in.count(sizeof(ContactTangent)));
      for (ContactTangent& tangent : body.tangent) {
        in.matrix(tangent.K);
        in.matrix(tangent.C);
      }
    }
  });
}

void pack(const Close& message, Bytes& bytes) {
  ByteWriter out(bytes);
  write_head(out, MessageKind::kClose, kProtocolVersion, message.status);
  out.text(message.reason);
}

void unpack(const Bytes& bytes, Close& message) {
  read(bytes, MessageKind::kClose, [&](ByteReader& in, const Head& head) {
    message.status = head.status;
    in.text(message.reason);
  });
}

}  // namespace footfall
