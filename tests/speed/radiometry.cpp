/// @file radiometry.cpp
/// What units cost: the same sums of irradiance with quantities and with bare numbers, one thread.
///
/// - `sum of`: what is added up.
/// - `ns`: nanoseconds for a small lamp, in the fastest repeat; `slowest`: in the slowest one.
/// - `ratio`: of the time to that of bare numbers.
/// - `code_bytes`: how long the machine code is; `same_code`: whether that of both is the same.
///
/// Expect a ratio of 1, and both sums to have the same bits, which is checked: units are gone when the compiler is
/// done.
///
/// It takes a second.

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/bench.hpp"
#include "course/timing.hpp"
#include "radiometry/quantity.hpp"
#include "radiometry/solid_angle.hpp"
#include "sampling/rng.hpp"

namespace sr {
namespace {

constexpr int repeats = 41;
constexpr int lamps   = 1 << 17;  // small areas

/// Small areas that shine: cosines at the receiver and at the lamp, distances, areas, radiances.
struct Lamps {
    std::vector<double> cosine_here, cosine_there, distance, area, radiance;
};

Lamps random_lamps() {
    Lamps all;
    Rng   rng{1, 0, 0, 0};
    for (int i = 0; i < lamps; ++i) {
        for (auto* column : {&all.cosine_here, &all.cosine_there, &all.distance, &all.area, &all.radiance})
            column->push_back(rng.uniform<double>() + 0.1);
    }
    return all;
}

/// sum of L cos A cos' / r^2
inline double sum_of_bare_numbers(const Lamps& l) {
    double sum = 0;
    for (std::size_t i = 0; i < l.area.size(); ++i) {
        const double seen = l.area[i] * (l.cosine_there[i] / (l.distance[i] * l.distance[i]));
        sum               = sum + l.radiance[i] * l.cosine_here[i] * seen;
    }
    return sum;
}

inline Irradiance<double> sum_of_quantities(const Lamps& l) {
    Irradiance<double> sum;
    for (std::size_t i = 0; i < l.area.size(); ++i) {
        const SolidAngle<double> seen =
            Area<double>{l.area[i]} * solid_angle_per_area(l.cosine_there[i], Length<double>{l.distance[i]});
        sum = sum + Radiance<double>{l.radiance[i]} * l.cosine_here[i] * seen;
    }
    return sum;
}

/// How long the machine code of both is, and whether it is the same.
struct Code {
    long        bare = 0, typed = 0;  ///< [bytes]; 0: not known
    std::string same = "not known";
};

#ifdef __ELF__
// Each alone in a section of the program, whose ends the linker knows.
extern "C" {
[[gnu::noinline, gnu::used, gnu::section("sr_bare")]] double sr_sum_of_bare_numbers(const Lamps& l) {
    return sum_of_bare_numbers(l);
}
[[gnu::noinline, gnu::used, gnu::section("sr_typed")]] double sr_sum_of_quantities(const Lamps& l) {
    return sum_of_quantities(l).value();
}
// NOLINTNEXTLINE(bugprone-reserved-identifier): the linker's names
extern const char __start_sr_bare[], __stop_sr_bare[], __start_sr_typed[], __stop_sr_typed[];
}

Code code() {
    const bool same = std::equal(__start_sr_bare, __stop_sr_bare, __start_sr_typed, __stop_sr_typed);
    return {__stop_sr_bare - __start_sr_bare, __stop_sr_typed - __start_sr_typed, same ? "yes" : "no"};
}
#else
Code code() {
    return {};
}
#endif

/// Both, in turn, again and again; and what machine code the compiler made of them.
course::Rows measure() {
    const auto all  = random_lamps();
    double     bare = 0, typed = 0;
    const auto timings = course::measure({{"bare numbers", [&] { bare = sum_of_bare_numbers(all); }},
                                          {"quantities", [&] { typed = sum_of_quantities(all).value(); }}},
                                         repeats);
    if (!(bare == typed)) throw std::logic_error("quantities: their sum is not that of bare numbers");
    course::Rows rows{{"sum of", "ns", "slowest", "ratio", "code_bytes", "same_code"}};
    for (std::size_t i = 0; i < 2; ++i)
        rows.add({timings[i].name, 1e9 * timings[i].seconds / lamps, 1e9 * timings[i].slowest / lamps,
                  timings[i].seconds / timings[0].seconds, i == 0 ? code().bare : code().typed, code().same});
    return rows;
}

}  // namespace
}  // namespace sr

int main(int argc, char** argv) {
    return sr::course::run_benchmark(
        argc, argv,
        "Nanoseconds for a small lamp's irradiance: with units, which are types, and with "
        "bare numbers, one thread. Both sums have the same bits; same_code says whether the machine code "
        "has, too.",
        sr::measure);
}
