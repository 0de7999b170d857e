package nephele.engine.scene;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.SpatialIndex;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials.Surface;

/** Turns solids into {@link SolidGeometry}: faces in the order of the spatial index, sorted into batches. */
final class SolidMesher {
    /** Side of a cell in metres: floats relative to its middle are at most 0.06 mm off. */
    private static final double CELL_METRES = 1024;

    private final SceneMaterials materials;
    private final List<Brush> brushes;
    private final SpatialIndex index;
    private final Vec3 origin;
    private final Map<BatchKey, Growing> batches = new LinkedHashMap<>();
    private ByteBuffer vertices;
    private int vertexCount;

    private record BatchKey(SolidBatch.Kind kind, Vec3 cellOrigin) {}

    /** A batch while its faces are added. */
    private static final class Growing {
        private int[] indices = new int[64];
        private int size;
        private final int[] ends;

        Growing(int slots) {
            ends = new int[slots];
        }

        void triangle(int a, int b, int c) {
            if (size + 3 > indices.length) {
                indices = Arrays.copyOf(indices, 2 * indices.length);
            }
            indices[size++] = a;
            indices[size++] = b;
            indices[size++] = c;
        }
    }

    SolidMesher(List<Solid> solids, SceneMaterials materials) {
        this.materials = materials;
        this.brushes = solids.stream().map(Brush::of).toList();
        List<Aabb> boxes = brushes.stream().map(b -> b.shape().bounds()).toList();
        this.index = SpatialIndex.of(boxes);
        this.origin = boxes.stream().reduce(Aabb.EMPTY, Aabb::union).centre();
    }

    SolidGeometry mesh() {
        int corners = brushes.stream()
                .flatMap(b -> b.faces().stream())
                .mapToInt(f -> f.polygon().size())
                .sum();
        vertices =
                ByteBuffer.allocateDirect(corners * SolidGeometry.VERTEX_BYTES).order(ByteOrder.nativeOrder());
        for (int slot = 0; slot < index.size(); slot++) {
            for (BrushFace face : brushes.get(index.itemAt(slot)).faces()) {
                add(face);
            }
            for (Growing batch : batches.values()) {
                batch.ends[slot] = batch.size;
            }
        }
        return finished();
    }

    private void add(BrushFace face) {
        int material = materials.indexOf(face.material());
        Surface surface = materials.surfaces().get(material);
        int block = material / SolidGeometry.MATERIALS_PER_BLOCK;
        SolidBatch.Kind kind = new SolidBatch.Kind(
                surface.material().lambert(),
                surface.colour().array(),
                surface.normal().array(),
                block);
        Vec3 cell = cellOf(face.polygon().get(0));
        Growing batch = batches.computeIfAbsent(new BatchKey(kind, cell), key -> new Growing(brushes.size()));
        int first = vertexCount;
        addCorners(face, surface, material - block * SolidGeometry.MATERIALS_PER_BLOCK, cell);
        for (int i = 2; i < face.polygon().size(); i++) {
            batch.triangle(first, first + i - 1, first + i);
        }
    }

    private Vec3 cellOf(Vec3 p) {
        return new Vec3(
                origin.x() + CELL_METRES * Math.rint((p.x() - origin.x()) / CELL_METRES),
                origin.y() + CELL_METRES * Math.rint((p.y() - origin.y()) / CELL_METRES),
                origin.z() + CELL_METRES * Math.rint((p.z() - origin.z()) / CELL_METRES));
    }

    private void addCorners(BrushFace face, Surface surface, int materialIndex, Vec3 cell) {
        double[] st = FaceBasis.coordinates(face, surface.material().textureMetres());
        for (int i = 0; i < face.polygon().size(); i++) {
            Vec3 p = face.polygon().get(i);
            vertices.putFloat((float) (p.x() - cell.x()));
            vertices.putFloat((float) (p.y() - cell.y()));
            vertices.putFloat((float) (p.z() - cell.z()));
            vertices.putShort(unit16(face.plane().nx()));
            vertices.putShort(unit16(face.plane().ny()));
            vertices.putShort(unit16(face.plane().nz()));
            vertices.putShort((short) materialIndex);
            vertices.putFloat((float) st[2 * i]);
            vertices.putFloat((float) st[2 * i + 1]);
            vertexCount++;
        }
    }

    private static short unit16(double x) {
        return (short) Math.round(x * Short.MAX_VALUE);
    }

    private SolidGeometry finished() {
        int total = batches.values().stream().mapToInt(b -> b.size).sum();
        IntBuffer indices = ByteBuffer.allocateDirect(4 * total)
                .order(ByteOrder.nativeOrder())
                .asIntBuffer();
        List<SolidBatch> done = new ArrayList<>();
        batches.forEach((key, batch) -> {
            done.add(new SolidBatch(key.kind, key.cellOrigin, indices.position(), batch.ends));
            indices.put(batch.indices, 0, batch.size);
        });
        indices.flip();
        vertices.flip();
        return new SolidGeometry(vertices, indices, done, index);
    }
}
