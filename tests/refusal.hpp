#pragma once
/// @file refusal.hpp

#include <stdexcept>
#include <string>

namespace sr::test {

/// What std::invalid_argument says that is thrown in `attempt`, or "accepted".
template <class Attempt>
[[nodiscard]] std::string refusal_of(Attempt attempt) {
    try {
        attempt();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace sr::test
