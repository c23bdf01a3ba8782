#pragma once
// Claims about errors: of which type they are, and which names, keys, places or codes their text holds. Never its wording.

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "coupler/base/errors.h"

namespace footfall::test {

// The text of the Error that the action throws; a failure and "" where it throws none.
template <class Error = InputError, class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

// The same; "" where it throws none.
template <class Error = InputError, class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// Does the text hold each of these?
inline ::testing::AssertionResult names(const std::string& text, std::initializer_list<std::string> words) {
  for (const std::string& word : words)
    if (text.find(word) == std::string::npos)
      return ::testing::AssertionFailure() << "\"" << word << "\" is not in \"" << text << "\"";
  return ::testing::AssertionSuccess();
}

}  // namespace footfall::test
