package nephele.engine.scene;

/**
 * The vertex range and the slot of each shape of a mesh.
 *
 * @param firsts the first vertex of each shape
 * @param ends one past the last vertex of each shape
 * @param slots the slot of each shape in the spatial index
 */
record MeshSpans(int[] firsts, int[] ends, int[] slots) {
    static MeshSpans of(int shapes) {
        return new MeshSpans(new int[shapes], new int[shapes], new int[shapes]);
    }

    void begin(int shape, int slot, int vertex) {
        firsts[shape] = vertex;
        slots[shape] = slot;
    }

    void end(int shape, int vertex) {
        ends[shape] = vertex;
    }
}
