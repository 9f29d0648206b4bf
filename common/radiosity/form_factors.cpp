/// @file form_factors.cpp

#include "radiosity/form_factors.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "radiosity/exchange_area.hpp"
#include "radiosity/visible_share.hpp"

namespace sr {

FormFactorMatrix form_factors(const Patches& patches, const Visibility& visibility,
                              const FormFactorSettings& settings, const RowLoop& loop) {
    if (!(settings.tolerance > 0))
        throw std::invalid_argument(
            fmt::format("the form factors' tolerance is {}; must be above 0", settings.tolerance));
    if (settings.strata < 1)
        throw std::invalid_argument(
            fmt::format("the form factors' strata are {}; must be at least 1", settings.strata));
    FormFactorMatrix F(patches.size());
    for_each_row(patches.size(), loop, [&](std::size_t i) {
        const Patch& p = patches.shapes[i];
        for (std::size_t j = i + 1; j < patches.size(); ++j) {
            const Patch& q        = patches.shapes[j];
            double       exchange = exchange_area(p, q, settings.tolerance);
            if (exchange == 0) continue;
            Rng rng{settings.seed, std::int64_t(i), std::int64_t(j), 0};
            exchange *= visible_share(p, q, visibility, settings.strata, rng);
            F(i, j) = exchange / p.area();
            F(j, i) = exchange / q.area();
        }
    });
    return F;
}

}  // namespace sr
