/* What else is looked up of an OSMesa, and never called once no context was made. */
void OSMesaDestroyContext(void* context) { (void)context; }
unsigned char OSMesaMakeCurrent(void* context, void* buffer, unsigned type, int width, int height) {
    (void)context, (void)buffer, (void)type, (void)width, (void)height;
    return 0;
}
void (*OSMesaGetProcAddress(const char* name))(void) {
    (void)name;
    return 0;
}
