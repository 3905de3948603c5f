#include "gpu/name.h"

#include "gpu/context.h"

#include <glad/gl.h>

#include <stdexcept>

namespace isomotion::gpu {
namespace {

unsigned make(Kind kind) {
    GLuint number = 0;
    switch (kind) {
    case Kind::buffer:
        glGenBuffers(1, &number);
        break;
    case Kind::framebuffer:
        glGenFramebuffers(1, &number);
        break;
    case Kind::program:
        number = glCreateProgram();
        break;
    case Kind::query:
        glGenQueries(1, &number);
        break;
    case Kind::texture:
        glGenTextures(1, &number);
        break;
    case Kind::vertex_array:
        glGenVertexArrays(1, &number);
        break;
    }
    return number;
}

void remove_one(Kind kind, GLuint number) {
    switch (kind) {
    case Kind::buffer:
        glDeleteBuffers(1, &number);
        break;
    case Kind::framebuffer:
        glDeleteFramebuffers(1, &number);
        break;
    case Kind::program:
        glDeleteProgram(number);
        break;
    case Kind::query:
        glDeleteQueries(1, &number);
        break;
    case Kind::texture:
        glDeleteTextures(1, &number);
        break;
    case Kind::vertex_array:
        glDeleteVertexArrays(1, &number);
        break;
    }
}

} // namespace

void Discarded::remove() {
    for (const auto& [kind, number] : names) remove_one(kind, number);
    names.clear();
}

Name::Name(Kind kind)
    : kind_(kind) {
    const Context* context = Context::current();
    if (!context) throw std::logic_error("a GL object needs a current context");
    context_ = context->discarded_;
    number_ = make(kind);
}

Name::Name(Name&& other) noexcept
    : context_(std::move(other.context_))
    , number_(std::exchange(other.number_, 0))
    , kind_(other.kind_) {}

Name& Name::operator=(Name&& other) noexcept {
    std::swap(context_, other.context_);
    std::swap(number_, other.number_);
    std::swap(kind_, other.kind_);
    return *this;
}

Name::~Name() {
    const auto discarded = context_.lock();
    if (!discarded || number_ == 0) return;
    const Context* context = Context::current();
    if (context && context->discarded_ == discarded)
        remove_one(kind_, number_);
    else
        discarded->names.emplace_back(kind_, number_);
}

} // namespace isomotion::gpu
