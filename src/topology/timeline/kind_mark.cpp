#include "topology/timeline/kind_mark.h"

#include <algorithm>

namespace isomotion::topology {
namespace {

constexpr KindMark marks[] = {
    {Kind::birth, "#009e73", 1},        {Kind::death, "#cc79a7", -1},
    {Kind::merge, "#0072b2", -1},       {Kind::split, "#d55e00", 1},
    {Kind::tunnel_forms, "#56b4e9", 1}, {Kind::tunnel_closes, "#e69f00", -1},
    {Kind::tunnel_opens, "#117733", 1}, {Kind::tunnel_breaks, "#882255", -1},
    {Kind::void_forms, "#332288", 1},   {Kind::void_fills, "#999933", -1},
    {Kind::void_opens, "#aa4499", -1},  {Kind::void_born, "#44aa99", 1},
    {Kind::unknown, "#666666", 0},      {Kind::none, "#999999", 0},
};

} // namespace

std::span<const KindMark> kind_marks() { return marks; }

const KindMark& mark_of(Kind kind) { return *std::ranges::find(marks, kind, &KindMark::kind); }

} // namespace isomotion::topology
