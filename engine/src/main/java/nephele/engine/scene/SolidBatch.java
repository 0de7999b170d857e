package nephele.engine.scene;

import nephele.engine.math.Vec3;

/**
 * Faces that are drawn with one program and one set of bindings.
 *
 * @param form whose faces they are
 * @param kind what the shader must be able to do for them
 * @param cellOrigin world position that the vertices' floats are relative to
 * @param firstIndex where the batch's indices begin in the index buffer of its form
 * @param indexEnds for slot i of the spatial index the number of the batch's indices up to and including it: what the
 *     slots [a, b) contribute is contiguous
 */
public record SolidBatch(Form form, Kind kind, Vec3 cellOrigin, int firstIndex, int[] indexEnds) {
    /** What a face belongs to, which decides what its vertices hold. */
    public enum Form {
        SOLID,
        /** A model whose every triangle looks as flat as it is. */
        FACETED_MODEL,
        /** A model whose triangles stand for a curved surface. */
        CURVED_MODEL;

        public boolean isModel() {
            return this != SOLID;
        }
    }

    /** Materials that differ in more than numbers are of different kinds. */
    public record Kind(boolean lambert, int colourArray, int normalArray, int materialBlock) {
        public boolean isTextured() {
            return colourArray >= 0;
        }

        public boolean isNormalMapped() {
            return normalArray >= 0;
        }
    }

    /** Index in the index buffer at which {@code slot} ends. */
    int end(int slot) {
        return firstIndex + indexEnds[slot];
    }

    /** Index in the index buffer at which {@code slot} begins. */
    int start(int slot) {
        return firstIndex + (slot == 0 ? 0 : indexEnds[slot - 1]);
    }
}
