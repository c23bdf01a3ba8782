#include "coupler/message_fields.h"

#include <gtest/gtest.h>

#include "tests/unit/coupler/message_content.h"

namespace footfall {
namespace {

using test::Random;
using Names = std::vector<std::string>;

template <class Message>
class EveryMessagesFields : public testing::Test {};
template <class List>
struct TypesOf;
template <class... Messages>
struct TypesOf<std::tuple<Messages...>> {
  using Type = testing::Types<Messages...>;
};
TYPED_TEST_SUITE(EveryMessagesFields, TypesOf<AllMessages>::Type);

template <class Message>
Message random_message(int modes) {
  Random random(45);
  Message message;
  test::randomize(message, random, modes);
  return message;
}

template <class Message>
Message round_trip(const Message& sent) {
  Bytes bytes;
  pack(sent, bytes);
  Message received;
  unpack(bytes, received);
  return received;
}

TYPED_TEST(EveryMessagesFields, ComeBackAsTheyWere) {
  for (const int modes : {0, 3}) {
    const auto sent = random_message<TypeParam>(modes);
    EXPECT_EQ(test::differences(sent, round_trip(sent)), Names());
    EXPECT_NE(test::differences(sent, TypeParam()), Names());  // or the content would be that of an empty message
  }
}

TYPED_TEST(EveryMessagesFields, OverwriteWhatTheReceiverHeld) {
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
TYPED_TEST(EveryMessagesFields, ArriveUnderTheirOwnNames) {
  const auto sent = random_message<TypeParam>(3);
  auto changed = sent;
  int fields = 0;
  test::for_each_changed(changed, [&](const std::string& path, const TypeParam& message) {
    ++fields;
    EXPECT_EQ(test::differences(sent, round_trip(message)), Names{path});
  });
  EXPECT_GE(fields, 2);
}

TEST(MessageFields, ComparisonNamesTheFieldThatIsMissing) {
  const Load sent = random_message<Load>(2);
  Load received = sent;
  received.bodies[1].mean.work = 0.0;
  EXPECT_EQ(test::differences(sent, received), Names{".bodies[1].mean.work"});
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

}  // namespace
}  // namespace footfall
