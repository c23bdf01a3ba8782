#pragma once
// No number that is not one gets from one program into the other: where it stands, by the lists of message_fields.h.

#include <string>

#include "coupler/messages.h"

namespace footfall {

// The first number in a message or in a part of it that is infinite or not a number, as its place: "bodies[0].mean.work",
// "bodies[1].boundary.rho0". Empty when all are finite; nothing is allocated then (Geometry and its parts excepted).
template <class Message>
std::string first_not_finite(const Message& message);

// For the messages before the first window. Throws NumericalError that names message, sender and place.
template <class Message>
void demand_finite(const Message& message, const std::string& sender) {
  if (const std::string place = first_not_finite(message); !place.empty())
    throw NumericalError("message " + message_name(Message::kKind) + " of " + sender + ": " + place + " is not finite");
}

}  // namespace footfall
