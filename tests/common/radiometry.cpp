/// @file radiometry.cpp
/// Quantities and their units, photons, lamps and skies.

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "math/degrees.hpp"
#include "math/gauss_legendre.hpp"
#include "math/square.hpp"
#include "near.hpp"
#include "radiometry/emitters.hpp"
#include "radiometry/photons.hpp"
#include "radiometry/quantity.hpp"
#include "radiometry/sky.hpp"
#include "radiometry/spectrum.hpp"

using namespace sr;
using test::near;

namespace {

using std::numbers::pi;

template <class A, class B>
concept Addable = requires(A a, B b) {
    a + b;
};
template <class A, class B>
concept Subtractable = requires(A a, B b) {
    a - b;
};
template <class A, class B>
concept Comparable = requires(A a, B b) {
    a == b;
};
template <class A, class B>
concept Ordered = requires(A a, B b) {
    a < b;
};
template <class A, class B>
concept Assignable = requires(A a, B b) {
    a = b;
};

template <class A, class B>
constexpr bool mix =
    Addable<A, B> || Addable<B, A> || Subtractable<A, B> || Comparable<A, B> || Ordered<A, B> ||
    Assignable<A, B> || std::is_convertible_v<A, B> || std::is_constructible_v<A, B>;

template <class A, class B>
concept Multiplied = requires(A a, B b) {
    a* b;
};
template <class A, class B>
concept Divided = requires(A a, B b) {
    a / b;
};

template <class Product, class A, class B>
constexpr bool product_is = std::is_same_v<decltype(A{} * B{}), Product>;
template <class Quotient, class A, class B>
constexpr bool quotient_is = std::is_same_v<decltype(A{} / B{}), Quotient>;

}  // namespace

TEST_CASE_TEMPLATE("quantities: products and quotients have the unit that physics gives them", V, float,
                   double) {
    CHECK(quotient_is<Flux<V>, Energy<V>, Time<V>>);
    CHECK(quotient_is<Irradiance<V>, Flux<V>, Area<V>>);
    CHECK(quotient_is<Intensity<V>, Flux<V>, SolidAngle<V>>);
    CHECK(quotient_is<Radiance<V>, Intensity<V>, Area<V>>);
    CHECK(quotient_is<Radiance<V>, Irradiance<V>, SolidAngle<V>>);
    CHECK(product_is<Irradiance<V>, Radiance<V>, SolidAngle<V>>);
    CHECK(product_is<Area<V>, Length<V>, Length<V>>);
    CHECK(quotient_is<Rate<V>, Flux<V>, Energy<V>>);
    CHECK(quotient_is<V, Flux<V>, Flux<V>>);  // a bare number
    CHECK(quotient_is<V, Area<V>, Area<V>>);
    CHECK(product_is<Irradiance<V>, Intensity<V>, SolidAnglePerArea<V>>);
    CHECK(product_is<Flux<V>, V, Flux<V>>);
    CHECK(product_is<Flux<V>, Flux<V>, V>);
    CHECK(quotient_is<Flux<V>, Flux<V>, V>);
    CHECK(quotient_is<Rate<V>, V, Time<V>>);
}

TEST_CASE("quantities: what physics forbids does not compile") {
    using E = Irradiance<double>;
    using L = Radiance<double>;
    CHECK_FALSE(mix<E, L>);
    CHECK_FALSE(mix<Flux<double>, Energy<double>>);
    CHECK_FALSE(mix<Intensity<double>, Flux<double>>);
    CHECK_FALSE(mix<Length<double>, Area<double>>);
    CHECK_FALSE(mix<SolidAngle<double>, Area<double>>);
    // a bare number has no unit; only explicitly does it get one
    CHECK_FALSE((Addable<E, double> || Comparable<E, double> || Assignable<E, double>));
    CHECK_FALSE((std::is_convertible_v<double, E> || std::is_convertible_v<E, double>));
    // nor does a float become a double unasked, nor a colour a number
    CHECK_FALSE(mix<E, Irradiance<float>>);
    CHECK_FALSE(mix<Irradiance<Spectrum>, Irradiance<float>>);
    CHECK_FALSE(Ordered<Irradiance<Spectrum>, Irradiance<Spectrum>>);
    CHECK_FALSE((Multiplied<double, Flux<float>> || Multiplied<Flux<float>, double>));
    CHECK_FALSE((Multiplied<Flux<float>, SolidAngle<double>> || Divided<Flux<float>, Area<double>>));
    CHECK_FALSE((Divided<Flux<float>, double> || Divided<double, Time<float>>));
    CHECK_FALSE((Multiplied<Irradiance<Spectrum>, double> || Divided<Spectrum, Irradiance<Spectrum>>));
    // nor is a text or a whole number a value
    CHECK_FALSE((Multiplied<E, const char*> || Multiplied<std::string, E> || Divided<E, std::string>));
    CHECK_FALSE((Multiplied<E, int> || Multiplied<int, E> || Divided<E, int> || Divided<int, E>));
    // the right ones do: the concepts above can be true
    CHECK((Multiplied<double, E> && Multiplied<E, Area<double>> && Divided<E, double> && Divided<double, E>));
    CHECK((Multiplied<Spectrum, Irradiance<float>> && Divided<Irradiance<Spectrum>, float>));
    CHECK((Addable<E, E> && Subtractable<E, E> && Comparable<E, E> && Ordered<E, E> && Assignable<E&, E>));
}

TEST_CASE("quantities: they compute as their values do, with colours as well, and are no larger") {
    const Irradiance<double> E = Radiance<double>{2} * SolidAngle<double>{0.25};
    CHECK(E.value() == 0.5);
    CHECK((E + E - Irradiance<double>{0.125}).value() == 0.875);
    CHECK((2.0 * E / 4.0).value() == 0.25);
    CHECK(E / Irradiance<double>{0.125} == 4);
    CHECK(Flux<double>{} == Flux<double>{0});
    CHECK((Flux<double>{1} < Flux<double>{2}));
    CHECK_FALSE((Flux<double>{std::nan("")} <= Flux<double>{2}));
    const Irradiance<Spectrum> coloured = Radiance<Spectrum>{{1, 2, 4}} * SolidAngle<float>{0.5F};
    CHECK(coloured.value() == Spectrum{0.5F, 1, 2});
    CHECK((Spectrum{0, 1, 0.5F} * coloured).value() == Spectrum{0, 1, 1});
    CHECK((coloured - coloured).value() == Spectrum{});
    CHECK((coloured / 2.0F).value() == Spectrum{0.25F, 0.5F, 1});
    CHECK(sizeof(Radiance<float>) == sizeof(float));
    CHECK(std::is_trivially_copyable_v<Radiance<Spectrum>>);
    static_assert((Length<double>{2} * Length<double>{3}).value() == 6);
}

TEST_CASE("photons: a watt of green light is 2.79e18 of them a second, one of red light more") {
    // h c = 1.986445857e-25 J m, from the SI's exact h and c
    CHECK(photon_energy(Length<double>{555e-9}).value() == near(1.986445857e-25 / 555e-9, 1e-9));
    const auto green = photons_per_time(Flux<double>{1}, Length<double>{555e-9});
    const auto red   = photons_per_time(Flux<double>{1}, Length<double>{650e-9});
    CHECK(green.value() == near(555e-9 / 1.986445857e-25, 1e-9));
    CHECK(red / green == near(650.0 / 555, 1e-14));
}

TEST_CASE("B1, B2: a point light's irradiance, and the flux that a disk below it and the whole plane catch") {
    const Intensity<double> I    = Flux<double>{100} / SolidAngle<double>{4 * pi};
    const auto              E_at = [&](double x) {
        const double d = std::hypot(2, x);
        return point_irradiance(I, 2 / d, Length<double>{d}).value();
    };
    CHECK(E_at(0) == near(1.9894367886486917, 1e-13));
    CHECK(E_at(2) == near(0.70337212199773912, 1e-13));
    CHECK(point_irradiance(I, -0.5, Length<double>{1}).value() == 0);
    CHECK_FALSE(point_irradiance(I, std::nan(""), Length<double>{1}).value() == 0);

    double disk = 0, plane = 0;  // the plane by x = 2 tan(a)
    for (const auto& [x, weight] : gauss_legendre(40, 0, 2)) disk += weight * 2 * pi * x * E_at(x);
    for (const auto& [a, weight] : gauss_legendre(40, 0, pi / 2))
        plane += weight * 2 * pi * 2 * std::tan(a) * E_at(2 * std::tan(a)) * 2 / square(std::cos(a));
    CHECK(disk == near(14.644660940672624, 1e-12));
    CHECK(plane == near(50, 1e-12));
}

TEST_CASE("B14: a tilted facet under a uniform sky") {
    for (const auto& [tilt, expected] : {std::pair{0.0, 3.1415926535897932},
                                         {30.0, 2.93114584997056},
                                         {60.0, 2.3561944901923449},
                                         {90.0, 1.5707963267948966},
                                         {135.0, 0.46007559225530506}})
        CHECK(uniform_sky_irradiance(Radiance<double>{1}, radians(tilt)).value() == near(expected, 1e-12));
}

TEST_CASE("B15: a level and an upright facet under the overcast sky, and any other by quadrature") {
    const auto E = [](double tilt) { return overcast_sky_irradiance(Radiance<double>{1}, tilt).value(); };
    CHECK(E(0) == near(2.4434609527920614, 1e-13));
    CHECK(E(pi / 2) == near(0.96804322004274332, 1e-13));
    CHECK(E(pi / 2) / E(0) == near(0.39617707781930896, 1e-13));
    // In the facet's frame with the zenith at (sin t, 0, cos t): directions at the angle p in the x-z plane and the
    // elevation q out of it, of which the sky's are those with |p - t| < pi/2.
    for (const double tilt : {0.3, 1.2, 2.5}) {
        double sum = 0;
        for (const auto& [p, of_p] : gauss_legendre(40, tilt - pi / 2, pi / 2)) {
            for (const auto& [q, of_q] : gauss_legendre(40, -pi / 2, pi / 2)) {
                const double cosine = std::cos(q) * std::cos(p), height = std::cos(q) * std::cos(p - tilt);
                sum += of_p * of_q * std::cos(q) * cosine * (1 + 2 * height) / 3;
            }
        }
        CHECK(E(tilt) == near(sum, 1e-12));
    }
}

TEST_CASE("B16, B20: the flux of a Lambert square and sphere, of a cosine spot and a cone; pi L") {
    const Radiance<double>  L{1};
    const Intensity<double> I{1};
    CHECK(lambert_flux(L, Area<double>{4}).value() == near(12.566370614359173, 1e-14));
    CHECK(lambert_flux(L, Area<double>{4 * pi}).value() == near(39.478417604357434, 1e-14));
    CHECK(cosine_spot_flux(I, 20.0).value() == near(0.29919930034188507, 1e-14));
    CHECK(cone_flux(I, radians(30)).value() == near(0.84178721447693293, 1e-14));
    CHECK(cone_flux(I, pi).value() == near(4 * pi, 1e-14));
    CHECK(lambert_radiosity(L).value() == near(3.1415926535897932, 1e-15));
}

TEST_CASE("lamps that cannot be are refused, by name and value") {
    const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS((void)lambert_radiosity(Radiance<double>{-1e-9}),
                         "radiance is -1e-09; must be 0 or more, and finite", std::invalid_argument);
    for (const double bad : {-1.0, nan, infinite}) {
        CHECK_THROWS_AS((void)lambert_radiosity(Radiance<double>{bad}), std::invalid_argument);
        CHECK_THROWS_AS((void)lambert_flux(Radiance<double>{1}, Area<double>{bad}), std::invalid_argument);
        CHECK_THROWS_AS((void)cone_flux(Intensity<double>{bad}, 1.0), std::invalid_argument);
        CHECK_THROWS_AS((void)cone_flux(Intensity<double>{1}, bad), std::invalid_argument);
        CHECK_THROWS_AS((void)cosine_spot_flux(Intensity<double>{bad}, 1.0), std::invalid_argument);
        CHECK_THROWS_AS((void)cosine_spot_flux(Intensity<double>{1}, bad), std::invalid_argument);
        CHECK_THROWS_AS((void)point_irradiance(Intensity<double>{bad}, 1.0, Length<double>{1}),
                        std::invalid_argument);
        CHECK_THROWS_AS((void)uniform_sky_irradiance(Radiance<double>{bad}, 1.0), std::invalid_argument);
        CHECK_THROWS_AS((void)overcast_sky_irradiance(Radiance<double>{bad}, 1.0), std::invalid_argument);
    }
}

TEST_CASE("the largest of three primaries, and NaN wherever there is one") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const auto& s : {DoubleSpectrum{3, 1, -4}, {1, 3, 2}, {-4, 2, 3}}) CHECK(largest(s) == 3);
    CHECK(largest(DoubleSpectrum{-3, -1, -2}) == -1);
    for (const auto& s : {DoubleSpectrum{nan, 1, 2}, {1, nan, 2}, {1, 2, nan}}) CHECK(std::isnan(largest(s)));
}
