package nephele.engine.scene;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials.Surface;

/** Sorts triangles into {@link SolidBatch}es, one slot of the spatial index after the other. */
final class BatchBuilder {
    /** The side of a cell in metres: floats relative to its centre have an error of at most 0.06 mm. */
    private static final double CELL_METRES = 1024;

    private final Vec3 origin;
    private final int slots;
    private final List<Growing> batches = new ArrayList<>();

    private Growing last;
    private int lastMaterial;

    /** A batch to which triangles are still being added. */
    static final class Growing {
        private final SolidBatch.Form form;
        private final SolidBatch.Kind kind;
        private final Vec3 cell;
        private int[] indices = new int[64];
        private int size;
        private final int[] ends;

        private Growing(SolidBatch.Form form, SolidBatch.Kind kind, Vec3 cell, int slots) {
            this.form = form;
            this.kind = kind;
            this.cell = cell;
            ends = new int[slots];
        }

        /** Returns the world position that the vertices' positions are relative to. */
        Vec3 cell() {
            return cell;
        }

        /** Copies indices of another mesh; in this mesh the number of each vertex is greater by {@code shift}. */
        void indices(IntBuffer from, int first, int end, int shift) {
            reserve(end - first);
            for (int i = first; i < end; i++) {
                indices[size++] = from.get(i) + shift;
            }
        }

        private void reserve(int more) {
            if (size + more > indices.length) {
                indices = Arrays.copyOf(indices, 2 * (size + more));
            }
        }

        /**
         * Appends triangles.
         *
         * @param corners vertex numbers relative to {@code firstVertex}
         */
        void triangles(int firstVertex, int[] corners) {
            reserve(corners.length);
            for (int corner : corners) {
                indices[size++] = firstVertex + corner;
            }
        }
    }

    /** Returns the batch that corresponds to one of another mesh, or {@code null} if it is still empty. */
    Growing known(SolidBatch like) {
        return known(like.form(), like.kind(), like.cellOrigin());
    }

    private Growing known(SolidBatch.Form form, SolidBatch.Kind kind, Vec3 cell) {
        for (Growing batch : batches) {
            if (batch.form == form && batch.kind.equals(kind) && batch.cell.equals(cell)) {
                return batch;
            }
        }
        return null;
    }

    /**
     * Makes a builder without batches.
     *
     * @param origin cell origins differ from it by whole numbers of cells
     * @param slots number of slots of the spatial index
     */
    BatchBuilder(Vec3 origin, int slots) {
        this.origin = origin;
        this.slots = slots;
    }

    /** Returns the batch for faces of a material near a position. */
    Growing batch(SolidBatch.Form form, Surface surface, int material, Vec3 place) {
        Vec3 cell = cellOf(place);
        if (last == null || last.form != form || lastMaterial != material || !last.cell.equals(cell)) {
            last = found(form, surface, material, cell);
            lastMaterial = material;
        }
        return last;
    }

    private Growing found(SolidBatch.Form form, Surface surface, int material, Vec3 cell) {
        SolidBatch.Kind kind = new SolidBatch.Kind(
                surface.material().lambert(),
                surface.colour().array(),
                surface.normal().array(),
                material / SolidGeometry.MATERIALS_PER_BLOCK);
        Growing known = known(form, kind, cell);
        if (known != null) {
            return known;
        }
        Growing made = new Growing(form, kind, cell, slots);
        batches.add(made);
        return made;
    }

    private Vec3 cellOf(Vec3 p) {
        return new Vec3(
                origin.x() + CELL_METRES * Math.rint((p.x() - origin.x()) / CELL_METRES),
                origin.y() + CELL_METRES * Math.rint((p.y() - origin.y()) / CELL_METRES),
                origin.z() + CELL_METRES * Math.rint((p.z() - origin.z()) / CELL_METRES));
    }

    /** Ends a slot; call it for each slot in order, after all its triangles have been added. */
    void endSlot(int slot) {
        for (Growing batch : batches) {
            batch.ends[slot] = batch.size;
        }
    }

    /** Returns the indices of all batches, one batch after the other, and appends the batches to {@code done}. */
    IntBuffer finish(List<SolidBatch> done) {
        int total = batches.stream().mapToInt(b -> b.size).sum();
        IntBuffer indices = ByteBuffer.allocateDirect(4 * total)
                .order(ByteOrder.nativeOrder())
                .asIntBuffer();
        List<SolidBatch> finished = new ArrayList<>();
        for (Growing batch : batches) {
            finished.add(new SolidBatch(batch.form, batch.kind, batch.cell, indices.position(), batch.ends));
            indices.put(batch.indices, 0, batch.size);
        }
        done.addAll(finished);
        return indices.flip();
    }
}
