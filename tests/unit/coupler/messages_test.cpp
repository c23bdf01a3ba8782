// Messages: what is packed is read back, and what is damaged is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/message_fields.h"
#include "coupler/messages.h"
#include "tests/support/refused.h"
#include "tests/unit/coupler/message_content.h"
#include "tests/unit/coupler/random_boundary.h"

namespace footfall {
namespace {

using test::RandomNumbers;

template <class Message>
class EveryMessage : public testing::Test {};
template <class List>
struct TypesOf;
template <class... Messages>
struct TypesOf<std::tuple<Messages...>> {
  using Type = testing::Types<Messages...>;
};
TYPED_TEST_SUITE(EveryMessage, TypesOf<AllMessages>::Type);

template <class Message>
Message random_message(int modes) {
  RandomNumbers random(45);
  Message message;
  test::randomize(message, random, modes);
  return message;
}

TEST(Messages, ReusedBuffersAreNotAllocatedAnew) {
  const Load load = random_message<Load>(2);
  Bytes bytes;
  pack(load, bytes);
  const std::uint8_t* const memory = bytes.data();
  Load received;
  unpack(bytes, received);
  const double* const modal = received.bodies[1].mean.Q_a.data();
  pack(load, bytes);
  unpack(bytes, received);
  EXPECT_EQ(bytes.data(), memory);
  EXPECT_EQ(received.bodies[1].mean.Q_a.data(), modal);
}

TYPED_TEST(EveryMessage, CutShortOrTooLongIsRefused) {
  Bytes whole;
  pack(random_message<TypeParam>(2), whole);
  TypeParam received;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW(unpack(part, received), ProtocolError) << size << " of " << whole.size();
  }
  whole.push_back(0);
  EXPECT_THROW(unpack(whole, received), ProtocolError);
}

TYPED_TEST(EveryMessage, GarbageIsRefusedOrReadButNeverCrashes) {
  Bytes whole;
  pack(random_message<TypeParam>(2), whole);
  std::mt19937 random(44);
  int refused = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    Bytes bytes = whole;
    for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    TypeParam received;
    try {
      unpack(bytes, received);
    } catch (const ProtocolError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);  // the head and the counts alone are more than a tenth of the bytes of any message
  Bytes noise(200);
  for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>(random());
  TypeParam received;
  EXPECT_THROW(unpack(noise, received), ProtocolError);
}

TYPED_TEST(EveryMessage, OfAnotherKindIsRefusedByName) {
  Bytes bytes;
  if constexpr (std::is_same_v<TypeParam, Start>)
    pack(Accept{}, bytes);
  else
    pack(Start{}, bytes);
  TypeParam received;
  EXPECT_TRUE(
      test::names(test::error_of<ProtocolError>([&] { unpack(bytes, received); }), {message_name(TypeParam::kKind)}));
}

TEST(Messages, AnotherProtocolVersionIsRefusedNamingBoth) {
  Bytes bytes;
  pack(Start{}, bytes);
  const std::int32_t foreign = 999;
  std::memcpy(bytes.data() + 8, &foreign, sizeof foreign);
  Start start;
  EXPECT_TRUE(test::names(test::error_of<ProtocolError>([&] { unpack(bytes, start); }),
                          {"999", std::to_string(kProtocolVersion)}));
  EXPECT_THROW(check_partner("mbd_solver", 999, kFootfallVersion), ProtocolError);
  EXPECT_THROW(check_partner("mbd_solver", kProtocolVersion, "0.0.0"), ProtocolError);
  EXPECT_NO_THROW(check_partner("mbd_solver", kProtocolVersion, kFootfallVersion));
}

using Names = std::vector<std::string>;

template <class Message>
Message round_trip(const Message& sent) {
  Bytes bytes;
  pack(sent, bytes);
  Message received;
  unpack(bytes, received);
  return received;
}

TYPED_TEST(EveryMessage, ComeBackAsTheyWere) {
  for (const int modes : {0, 3}) {
    const auto sent = random_message<TypeParam>(modes);
    EXPECT_EQ(test::differences(sent, round_trip(sent)), Names());
    EXPECT_NE(test::differences(sent, TypeParam()), Names());  // or the content would equal an empty message's
  }
}

TYPED_TEST(EveryMessage, OverwriteWhatTheReceiverHeld) {
  const auto sent = random_message<TypeParam>(3);
  Bytes bytes;
  pack(sent, bytes);
  auto received = sent;
  test::for_each_changed(received, [&](const std::string& path, TypeParam& other) {
    TypeParam copy = other;
    unpack(bytes, copy);
    EXPECT_EQ(test::differences(sent, copy), Names()) << path << " kept its old value";
  });
}

// Each alone: a field that took another's place in the bytes, or none, would come back under the wrong name.
TYPED_TEST(EveryMessage, ArriveUnderTheirOwnNames) {
  const auto sent = random_message<TypeParam>(3);
  auto changed = sent;
  int fields = 0;
  test::for_each_changed(changed, [&](const std::string& path, const TypeParam& message) {
    ++fields;
    EXPECT_EQ(test::differences(sent, round_trip(message)), Names{path});
  });
  EXPECT_GE(fields, 2);
}

TEST(MessageFields, OnlyHelloAndCloseSpeakInTheHead) {
  Hello hello;
  hello.protocol = 77;
  Bytes bytes;
  pack(hello, bytes);
  EXPECT_EQ(bytes[8], 77);
  pack(Close{Status::kInterrupted, "stopped by hand"}, bytes);
  EXPECT_EQ(bytes[12], 3);
  pack(Start{}, bytes);
  EXPECT_EQ(bytes[8], kProtocolVersion);
  EXPECT_EQ(bytes[12], 0);
}

template <class Message>
class NotANumber : public testing::Test {};
using Exchanged = testing::Types<Geometry, Start, Accept, Motion, Load>;
TYPED_TEST_SUITE(NotANumber, Exchanged);

// Every number of a message in turn is made infinite or no number: the check says where it is, and nothing before
// and after.
TYPED_TEST(NotANumber, IsFoundWhereverItStands) {
  RandomNumbers random(46);
  TypeParam message;
  test::randomize(message, random, 3);
  EXPECT_EQ(first_not_finite(message), "");
  int numbers = 0;
  const auto any_size = [](const auto&...) { return true; };
  test::walk(
      "", any_size,
      [&](const std::string& path, auto& value) {
        using Value = std::decay_t<decltype(value)>;
        const auto spoil = [&](double& number, double bad) {
          const double kept = number;
          number = bad;
          EXPECT_EQ("." + first_not_finite(message), path);
          number = kept;
          ++numbers;
        };
        if constexpr (std::is_same_v<Value, double>) {
          spoil(value, std::nan(""));
          spoil(value, std::numeric_limits<double>::infinity());
        } else if constexpr (std::is_base_of_v<Eigen::PlainObjectBase<Value>, Value>) {
          if constexpr (std::is_same_v<typename Value::Scalar, double>)
            for (Eigen::Index i = 0; i < value.size(); ++i) spoil(value.data()[i], -std::nan(""));
        }
      },
      message);
  EXPECT_GE(numbers, 2);
  EXPECT_EQ(first_not_finite(message), "");
}

}  // namespace
}  // namespace footfall
