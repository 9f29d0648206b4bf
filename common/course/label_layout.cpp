/// @file label_layout.cpp

#include "course/label_layout.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace sr::course {

namespace {

bool overlap(const Box& a, const Box& b) {
    return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

/// Whether the line from p to q meets the box: the stretch of it inside both slabs is not empty.
bool meets(const Box& box, Point p, Point q) {
    double enter = 0;
    double leave = 1;
    for (const int axis : {0, 1}) {
        const double d = q[axis] - p[axis];
        const double a = box.min[axis] - p[axis];
        const double b = box.max[axis] - p[axis];
        if (d == 0) {
            if (a > 0 || b < 0) return false;
            continue;
        }
        enter = std::max(enter, std::min(a / d, b / d));
        leave = std::min(leave, std::max(a / d, b / d));
    }
    return enter <= leave;
}

/// Neighbours that would stand too close, and the mean of where they want to stand.
struct Pool {
    double mean;
    int    size;
};

}  // namespace

int Obstacles::covered_by(const Box& box) const {
    auto covered = std::count_if(boxes.begin(), boxes.end(), [&](const Box& b) { return overlap(box, b); });
    for (const std::vector<Point>& curve : curves)
        for (std::size_t i = 1; i < curve.size(); ++i) covered += meets(box, curve[i - 1], curve[i]) ? 1 : 0;
    return int(covered);
}

std::vector<double> spread(const std::vector<double>& wanted, const std::vector<double>& sizes, double low,
                           double high) {
    std::vector<std::size_t> order(wanted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](auto a, auto b) {
        return std::pair{wanted[a], a} < std::pair{wanted[b], b};
    });

    // measured from where each would stand in a pile without gaps, "clear of the one below" is "not less than it"
    std::vector<double> pile;
    double              top = 0;
    for (const std::size_t i : order) {
        pile.push_back(top + sizes[i] / 2);
        top += sizes[i];
    }
    std::vector<Pool> pools;
    for (std::size_t i = 0; i < order.size(); ++i) {
        pools.push_back({wanted[order[i]] - pile[i], 1});
        while (pools.size() > 1 && pools.back().mean < pools[pools.size() - 2].mean) {
            const Pool last = pools.back();
            pools.pop_back();
            Pool& pool = pools.back();
            pool.mean  = (pool.mean * pool.size + last.mean * last.size) / (pool.size + last.size);
            pool.size += last.size;
        }
    }

    std::vector<double> middles(wanted.size());
    std::size_t         i = 0;
    for (const Pool& pool : pools)
        for (int n = 0; n < pool.size; ++n, ++i)
            middles[order[i]] = std::clamp(pool.mean, low, std::max(low, high - top)) + pile[i];
    return middles;
}

}  // namespace sr::course
