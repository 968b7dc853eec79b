#include "sweep/words/signature_text.h"

#include "analysis/diagnosis/effects/catalogue.h"
#include "analysis/diagnosis/outcomes/rivals.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("every effect, and every friction law among outcomes, has its signature in words", "[words]")
{
    for (const auto& effect : gap::effects()) {
        const std::string name{effect.name};
        CHECK(signature_text({name}) != name);
    }
    for (const auto& law : gap::rival_laws()) {
        const std::string name = "law:" + std::string(law.law);
        CHECK(signature_text({name}) != name);
    }
    CHECK(signature_text({"numbers"}) != "numbers");
    CHECK(signature_text({"gravity", "inertia"}) == signature_text({"gravity"}) + "; " + signature_text({"inertia"}));
}

TEST_CASE("a number of a data sheet is called as files call it unless there are better words", "[words]")
{
    CHECK(sheet_label("viscous slope") == "viscous slope");
    CHECK(sheet_label("Coulomb level in the end") == "Coulomb level at the end");
}
