package nephele.engine.scene;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials.Surface;

/** Sorts triangles into {@link SolidBatch}es, slot after slot of the spatial index. */
final class BatchBuilder {
    /** Side of a cell in metres: floats relative to its middle are at most 0.06 mm off. */
    private static final double CELL_METRES = 1024;

    private final Vec3 origin;
    private final int slots;
    private final Map<Key, Growing> batches = new LinkedHashMap<>();

    private Growing last;
    private SolidBatch.Form lastForm;
    private int lastMaterial;

    private record Key(SolidBatch.Form form, SolidBatch.Kind kind, Vec3 cellOrigin) {}

    /** A batch while its triangles are added. */
    static final class Growing {
        private final Vec3 cell;
        private int[] indices = new int[64];
        private int size;
        private final int[] ends;

        private Growing(Vec3 cell, int slots) {
            this.cell = cell;
            ends = new int[slots];
        }

        /** What the positions of its vertices are relative to. */
        Vec3 cell() {
            return cell;
        }

        /** Copies indices of another mesh, whose vertices stand {@code shift} farther on in this one. */
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

        /** @param corners numbers of vertices from {@code firstVertex} on */
        void triangles(int firstVertex, int[] corners) {
            reserve(corners.length);
            for (int corner : corners) {
                indices[size++] = firstVertex + corner;
            }
        }
    }

    /** The batch like one of another mesh, or {@code null} where nothing is in it yet. */
    Growing known(SolidBatch like) {
        return batches.get(new Key(like.form(), like.kind(), like.cellOrigin()));
    }

    /** @param origin what every cell's origin is a whole number of cells away from */
    BatchBuilder(Vec3 origin, int slots) {
        this.origin = origin;
        this.slots = slots;
    }

    /** The batch for what is made of a material, near a place. */
    Growing batch(SolidBatch.Form form, Surface surface, int material, Vec3 place) {
        Vec3 cell = cellOf(place);
        if (last == null || lastForm != form || lastMaterial != material || !last.cell.equals(cell)) {
            last = found(form, surface, material, cell);
            lastForm = form;
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
        return batches.computeIfAbsent(new Key(form, kind, cell), key -> new Growing(cell, slots));
    }

    private Vec3 cellOf(Vec3 p) {
        return new Vec3(
                origin.x() + CELL_METRES * Math.rint((p.x() - origin.x()) / CELL_METRES),
                origin.y() + CELL_METRES * Math.rint((p.y() - origin.y()) / CELL_METRES),
                origin.z() + CELL_METRES * Math.rint((p.z() - origin.z()) / CELL_METRES));
    }

    /** To be called for each slot in turn, when all of it has been added. */
    void endSlot(int slot) {
        for (Growing batch : batches.values()) {
            batch.ends[slot] = batch.size;
        }
    }

    /** All indices, batch after batch; appends the batches to {@code done}. */
    IntBuffer finish(List<SolidBatch> done) {
        int total = batches.values().stream().mapToInt(b -> b.size).sum();
        IntBuffer indices = ByteBuffer.allocateDirect(4 * total)
                .order(ByteOrder.nativeOrder())
                .asIntBuffer();
        List<SolidBatch> finished = new ArrayList<>();
        batches.forEach((key, batch) -> {
            finished.add(new SolidBatch(key.form, key.kind, key.cellOrigin, indices.position(), batch.ends));
            indices.put(batch.indices, 0, batch.size);
        });
        done.addAll(finished);
        return indices.flip();
    }
}
