// Windows for tests where nobody sits: a display for as long as this lives.
#pragma once

namespace isomotion::display {

// DISPLAY, where it is set, stays: it may be a graphics card's. Otherwise it names an Xvfb, which
// the process starts once; where there is none, it stays unset.
class OnDisplay {
public:
    OnDisplay();
    ~OnDisplay();
    OnDisplay(const OnDisplay&) = delete;
    OnDisplay& operator=(const OnDisplay&) = delete;

private:
    bool is_ours_ = false;
};

} // namespace isomotion::display
