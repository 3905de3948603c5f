// Copies the paths that went on back to the textures of all paths.
void main() {
    store_path(load_path());
}
