#include "scene/reading/isolation.h"

#include "scene/key_tables.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {

void read_isolation(Section& sections, Isolation& isolation, GivenThresholds& given) {
    auto section = sections.section("isolation");
    if (!section) return;
    read_keys(keys::isolation_keys, *section, isolation);
    given.step |= section->has("step");
    given.near |= section->has("near");
    given.far |= section->has("far");
    given.horizon |= section->has("horizon");
    section->refuse_rest();
}

} // namespace isomotion::scene
