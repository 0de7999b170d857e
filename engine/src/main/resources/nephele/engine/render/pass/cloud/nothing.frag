// Changes the stencil alone.
void main() {
}
