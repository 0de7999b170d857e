package nephele.engine.scene;

import java.nio.IntBuffer;
import java.util.List;

/** Copies the vertices and triangles of shapes from the mesh that the level had before an edit. */
final class MeshCopy {
    private final VertexBytes known;
    private final IntBuffer indices;
    private final List<SolidBatch> batches;
    private final BatchBuilder.Growing[] grown;

    /**
     * Makes a copier for one mesh.
     *
     * @param known the vertices of the mesh
     * @param batches the batches of the mesh
     */
    MeshCopy(VertexBytes known, IntBuffer indices, List<SolidBatch> batches) {
        this.known = known;
        this.indices = indices;
        this.batches = batches;
        grown = new BatchBuilder.Growing[batches.size()];
    }

    int vertices(int number) {
        return known.count(number);
    }

    /**
     * Copies the mesh of a shape. Returns false and copies nothing if one of its batches does not exist yet, because
     * the order of the batches has to be that of meshing.
     */
    boolean copy(int number, VertexBytes vertices, BatchBuilder builder) {
        int slot = known.slot(number);
        for (int i = 0; i < grown.length; i++) {
            if (grown[i] == null && batches.get(i).start(slot) < batches.get(i).end(slot)) {
                grown[i] = builder.known(batches.get(i));
                if (grown[i] == null) {
                    return false;
                }
            }
        }
        int shift = vertices.count() - known.first(number);
        vertices.copy(known, number);
        for (int i = 0; i < grown.length; i++) {
            SolidBatch batch = batches.get(i);
            if (batch.start(slot) < batch.end(slot)) {
                grown[i].indices(indices, batch.start(slot), batch.end(slot), shift);
            }
        }
        return true;
    }
}
