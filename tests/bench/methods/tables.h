// Contests and growth as tables: for reading (Markdown) and for further work (CSV).
#pragma once

#include <string>
#include <vector>

#include "methods/coherence.h"
#include "methods/contest.h"
#include "methods/growth.h"

namespace isomotion::bench {

struct Results {
    std::string machine, date;
    double peak = 0; // operations a second of which it is capable
    int repeat = 0;
    int most_halvings = 0; // of the sign test's step
    std::vector<Contest> surfaces, animations;
    std::vector<Growth> growth;
    std::vector<Coherence> coherence;
};

std::string contests_csv(const Results& results);
std::string growth_csv(const Results& results);
std::string coherence_csv(const Results& results);
std::string markdown(const Results& results);

} // namespace isomotion::bench
