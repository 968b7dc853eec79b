#include "analysis/results/text.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;

TEST_CASE("numbers read with prefix and unit", "[text]")
{
    const Units p, r(Motion::revolute);
    CHECK(with_unit(55000, Quantity::stiffness, p) == "55 kN/m");
    CHECK(with_unit(55000, Quantity::stiffness, r) == "55 kN·m/rad");
    CHECK(with_unit(1e-5, Quantity::position, p) == "10 µm");
    CHECK(with_unit(1e-5, Quantity::position, r) == "1×10^{−5} rad");
    CHECK(with_unit(-14.23, Quantity::rate, p) == "−14.2 1/s");
    CHECK(with_unit(999.96, Quantity::effort, p, 4) == "1 kN");
    CHECK(with_unit(0, Quantity::effort, p) == "0 N");
    CHECK(with_unit(NAN, Quantity::effort, p) == "–");
    CHECK(with_unit(95.1089, Quantity::inertia, p, 4) == "95.11 kg");
}

TEST_CASE("the ends of a range never read the same", "[text]")
{
    const Units p;
    const auto q = Quantity::stiffness;
    CHECK(range_text(2e3, 5e3, q, p) == "from 2 kN/m to 5 kN/m");
    CHECK(range_text(2027.38, 2027.41, q, p) == "from 2.02738 kN/m to 2.02741 kN/m");
    CHECK(range_text(2027.41, 2027.38, q, p, low_to_high) == "2.02741 kN/m … 2.02738 kN/m");
    CHECK(range_text(1e3, 1e3 * (1 + 1e-12), q, p) == "at 1 kN/m");
    CHECK(span_text(3.201, 3.202, q, p) == "at 3.2 N/m");
    CHECK(span_text(3.201, 3.212, q, p) == "between 3.2 N/m and 3.21 N/m");
    CHECK(reads_alike(-NAN, NAN, q, p, 3));
}

TEST_CASE("plain numbers and shares never round to a lie", "[text]")
{
    CHECK(plain_number(12345) == "12300");
    CHECK(plain_number(123456) == "1.23×10^{5}");
    CHECK(plain_number(1.5) == "1.5");
    CHECK(plain_number(-1e-7) == "−1×10^{−7}");
    CHECK(percent(0.3871) == "38.7 %");
    CHECK(percent(1e-6) == "< 0.1 %");
    CHECK(percent(0.99999) == "> 99.9 %");
    CHECK(percent(1) == "100 %");
    CHECK(percent(0) == "0 %");
}

TEST_CASE("counts read as words and large ones in groups")
{
    CHECK(stickslip::counted(1, "point") == "1 point");
    CHECK(stickslip::counted(0, "point") == "0 points");
    CHECK(stickslip::counted(401841, "point") == "401841 points");
    CHECK(stickslip::grouped(41) == "41");
    CHECK(stickslip::grouped(999) == "999");
    CHECK(stickslip::grouped(1000) == "1\u202f000");
    CHECK(stickslip::grouped(1234567) == "1\u202f234\u202f567");
}
