package nephele.engine.scene;

import nephele.engine.math.Vec3;

/**
 * Faces that are drawn with one program and one set of bindings.
 *
 * @param form decides the vertex layout
 * @param kind decides the shader variant and the bindings
 * @param cellOrigin world position that the vertices' floats are relative to, metres
 * @param firstIndex position of the batch's first index in the index buffer of its form
 * @param indexEnds for slot i of the spatial index, the number of the batch's indices up to and including the slot; the
 *     indices of the slots [a, b) are contiguous
 */
public record SolidBatch(Form form, Kind kind, Vec3 cellOrigin, int firstIndex, int[] indexEnds) {
    /** The kind of shape that a face belongs to, which decides the contents of its vertices. */
    public enum Form {
        SOLID,
        /** Solids' faces with a normal map that is turned or mirrored on them; vertices as for {@link #SOLID}. */
        TURNED_SOLID,
        /** A model with flat-shaded triangles. */
        FACETED_MODEL,
        /** A model with triangles that approximate a curved surface. */
        CURVED_MODEL;

        public boolean isModel() {
            return this == FACETED_MODEL || this == CURVED_MODEL;
        }
    }

    /** The properties of a material that need another shader variant or binding, beyond uniform values. */
    public record Kind(boolean lambert, int colourArray, int normalArray, int materialBlock) {
        public boolean isTextured() {
            return colourArray >= 0;
        }

        public boolean isNormalMapped() {
            return normalArray >= 0;
        }
    }

    /** Returns the position in the index buffer at which {@code slot} ends. */
    int end(int slot) {
        return firstIndex + indexEnds[slot];
    }

    /** Returns the position in the index buffer at which {@code slot} begins. */
    int start(int slot) {
        return firstIndex + (slot == 0 ? 0 : indexEnds[slot - 1]);
    }
}
