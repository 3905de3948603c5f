#include "player/memory.h"
#include "player/watch.h"
namespace isomotion::player {
FileWatch::FileWatch(const std::vector<std::filesystem::path>&) {}
void FileWatch::watch(const std::vector<std::filesystem::path>&) {}
std::vector<std::filesystem::path> FileWatch::changed() { return {}; }
std::vector<std::filesystem::path> files_of(const scene::Scene&) { return {}; }
std::vector<std::filesystem::path> shader_files() { return {}; }
Memory::Memory(std::filesystem::path, Warn) {}
SceneMemory Memory::recall(const std::filesystem::path&) const { return {}; }
void Memory::remember(const std::filesystem::path&, const SceneMemory&) const {}
std::vector<std::filesystem::path> Memory::opened() const { return {}; }
void Memory::add_opened(const std::filesystem::path&) const {}
std::filesystem::path state_folder() { return {}; }
}
