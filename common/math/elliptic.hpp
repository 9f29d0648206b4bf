#pragma once
/// @file elliptic.hpp
/// Complete elliptic integrals, by Carlson's duplication: the arguments are replaced by nearer and nearer ones, until
/// a short series has all digits. (std::comp_ellint_1 and _3 are missing in libc++.)
/// @see Carlson, Numerical computation of real or complex elliptic integrals, Numerical Algorithms 10 (1995)

#include <algorithm>
#include <cmath>
#include <limits>

namespace sr {

/// R_F(x, y, z) = 1/2 int_0^inf dt / sqrt((t + x)(t + y)(t + z)).
/// @pre x, y, z >= 0, at most one of them 0
[[nodiscard]] inline double carlson_rf(double x, double y, double z) {
    const double mean  = (x + y + z) / 3;
    double       A     = mean;
    double       scale = 1;  // 4^-n
    const double far   = std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z)}) /
                       std::cbrt(std::sqrt(3 * std::numeric_limits<double>::epsilon()));
    const double X0 = mean - x, Y0 = mean - y;
    while (scale * far > std::abs(A)) {
        const double lambda =
            std::sqrt(x) * std::sqrt(y) + std::sqrt(x) * std::sqrt(z) + std::sqrt(y) * std::sqrt(z);
        A = (A + lambda) / 4;
        x = (x + lambda) / 4;
        y = (y + lambda) / 4;
        z = (z + lambda) / 4;
        scale /= 4;
    }
    const double X = X0 * scale / A, Y = Y0 * scale / A, Z = -X - Y;
    const double E2 = X * Y - Z * Z, E3 = X * Y * Z;
    return (1 - E2 / 10 + E3 / 14 + E2 * E2 / 24 - 3 * E2 * E3 / 44) / std::sqrt(A);
}

/// R_J(x, y, z, p) = 3/2 int_0^inf dt / ((t + p) sqrt((t + x)(t + y)(t + z))).
/// @pre x, y, z >= 0, at most one of them 0; p > 0
[[nodiscard]] inline double carlson_rj(double x, double y, double z, double p) {
    const double mean  = (x + y + z + 2 * p) / 5;
    const double delta = (p - x) * (p - y) * (p - z);
    double       A     = mean;
    double       scale = 1;  // 4^-n
    double       sum   = 0;
    const double far =
        std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z), std::abs(mean - p)}) /
        std::cbrt(std::sqrt(std::numeric_limits<double>::epsilon() / 4));
    const double X0 = mean - x, Y0 = mean - y, Z0 = mean - z;
    while (scale * far > std::abs(A)) {
        const double rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z), rp = std::sqrt(p);
        const double lambda = rx * ry + rx * rz + ry * rz;
        const double d      = (rp + rx) * (rp + ry) * (rp + rz);
        const double e      = scale * scale * scale * delta / (d * d);
        const double root   = std::sqrt(std::abs(e));  // below, R_C(1, 1 + e)
        sum += scale / d * (e > 0 ? std::atan(root) / root : e < 0 ? std::atanh(root) / root : 1);
        A = (A + lambda) / 4;
        x = (x + lambda) / 4;
        y = (y + lambda) / 4;
        z = (z + lambda) / 4;
        p = (p + lambda) / 4;
        scale /= 4;
    }
    const double X = X0 * scale / A, Y = Y0 * scale / A, Z = Z0 * scale / A, P = -(X + Y + Z) / 2;
    const double E2 = X * Y + X * Z + Y * Z - 3 * P * P;
    const double E3 = X * Y * Z + 2 * E2 * P + 4 * P * P * P;
    const double E4 = (2 * X * Y * Z + E2 * P + 3 * P * P * P) * P;
    const double E5 = X * Y * Z * P * P;
    const double series =
        1 - 3 * E2 / 14 + E3 / 6 + 9 * E2 * E2 / 88 - 3 * E4 / 22 - 9 * E2 * E3 / 52 + 3 * E5 / 26;
    return scale * series / (A * std::sqrt(A)) + 6 * sum;
}

/// K = int_0^(pi/2) da / sqrt(1 - k^2 sin^2 a), from 1 - k^2, which the caller often knows to more digits than k.
/// @pre complement > 0
[[nodiscard]] inline double elliptic_k(double complement) {
    return carlson_rf(0, complement, 1);
}

/// Pi = int_0^(pi/2) da / ((1 - n sin^2 a) sqrt(1 - k^2 sin^2 a)), from 1 - k^2 and 1 - n.
/// @pre complement > 0, n_complement > 0
[[nodiscard]] inline double elliptic_pi(double n_complement, double complement) {
    return carlson_rf(0, complement, 1) + (1 - n_complement) / 3 * carlson_rj(0, complement, 1, n_complement);
}

}  // namespace sr
