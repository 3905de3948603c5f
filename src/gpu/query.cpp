#include "gpu/query.h"

#include "gpu/context.h"

#include <glad/gl.h>

namespace isomotion::gpu {
namespace {

GLuint result(GLuint query, GLenum what) {
    GLuint value = 0;
    glGetQueryObjectuiv(query, what, &value);
    return value;
}

} // namespace

void SamplesQuery::begin() { glBeginQuery(GL_SAMPLES_PASSED, name_.get()); }

void SamplesQuery::end() { glEndQuery(GL_SAMPLES_PASSED); }

bool SamplesQuery::ready() const { return result(name_.get(), GL_QUERY_RESULT_AVAILABLE) != 0; }

std::uint32_t SamplesQuery::passed() const { return result(name_.get(), GL_QUERY_RESULT); }

Timer::Timer()
    : on_the_wall_(Context::current()->info().software) {}

void Timer::begin() {
    if (on_the_wall_) {
        glFinish();
        begun_ = Clock::now();
    } else {
        glBeginQuery(GL_TIME_ELAPSED, name_.get());
    }
}

void Timer::end() {
    if (on_the_wall_) {
        glFinish();
        ended_ = Clock::now();
    } else {
        glEndQuery(GL_TIME_ELAPSED);
    }
}

bool Timer::ready() const {
    return on_the_wall_ || result(name_.get(), GL_QUERY_RESULT_AVAILABLE) != 0;
}

std::uint64_t Timer::nanoseconds() const {
    if (on_the_wall_) {
        const std::chrono::nanoseconds span = ended_ - begun_;
        return std::uint64_t(span.count());
    }
    GLuint64 value = 0;
    glGetQueryObjectui64v(name_.get(), GL_QUERY_RESULT, &value);
    return value;
}

} // namespace isomotion::gpu
