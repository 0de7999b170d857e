package nephele.engine.scene;

import java.util.List;

/** Copies the vertices and triangles of shapes from the mesh that the level had before an edit. */
final class MeshCopy {
    private final MeshSpans spans;
    private final SolidGeometry.Triangles triangles;
    private final List<SolidBatch> batches;
    private final BatchBuilder.Growing[] grown;

    /**
     * Makes a copier for one mesh.
     *
     * @param spans the vertex ranges of the mesh's shapes
     * @param batches the batches of the mesh
     */
    MeshCopy(MeshSpans spans, SolidGeometry.Triangles triangles, List<SolidBatch> batches) {
        this.spans = spans;
        this.triangles = triangles;
        this.batches = batches;
        grown = new BatchBuilder.Growing[batches.size()];
    }

    int vertices(int number) {
        return spans.ends()[number] - spans.firsts()[number];
    }

    /**
     * Copies the mesh of a shape. Returns false and copies nothing if one of its batches does not exist yet, because
     * the order of the batches has to be that of meshing.
     */
    boolean copy(int number, VertexBytes vertices, BatchBuilder builder) {
        int slot = spans.slots()[number];
        for (int i = 0; i < grown.length; i++) {
            if (grown[i] == null && batches.get(i).start(slot) < batches.get(i).end(slot)) {
                grown[i] = builder.known(batches.get(i));
                if (grown[i] == null) {
                    return false;
                }
            }
        }
        int shift = vertices.count() - spans.firsts()[number];
        vertices.copy(triangles.vertices(), spans.firsts()[number], vertices(number));
        for (int i = 0; i < grown.length; i++) {
            SolidBatch batch = batches.get(i);
            if (batch.start(slot) < batch.end(slot)) {
                grown[i].indices(triangles.indices(), batch.start(slot), batch.end(slot), shift);
            }
        }
        return true;
    }

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
}
