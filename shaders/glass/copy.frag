// Paths that went on, back to where all are kept.
void main() {
    store_path(load_path());
}
