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
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.math.Aabb;
import nephele.engine.math.SpatialIndex;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.light.FaceFragment;
import nephele.engine.scene.light.FaceFragment.Cover;
import nephele.engine.scene.light.FaceFragments;
import nephele.engine.scene.light.LightMapLayout;

/** Turns solids into {@link SolidGeometry}: faces in the order of the spatial index, sorted into batches. */
final class SolidMesher {
    /** Side of a cell in metres: floats relative to its middle are at most 0.06 mm off. */
    private static final double CELL_METRES = 1024;

    private final SceneMaterials materials;
    private final LightMapLayout lightMap;
    private final List<Brush> brushes;
    private final List<List<List<FaceFragment>>> fragments;
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

        void triangles(int firstVertex, int[] corners) {
            if (size + corners.length > indices.length) {
                indices = Arrays.copyOf(indices, 2 * (size + corners.length));
            }
            for (int corner : corners) {
                indices[size++] = firstVertex + corner;
            }
        }
    }

    SolidMesher(List<Solid> solids, SceneMaterials materials, LightMapLayout lightMap) {
        this.materials = materials;
        this.lightMap = lightMap;
        this.brushes = solids.stream().map(Brush::of).toList();
        this.fragments = lightMap == null ? FaceFragments.uncut(brushes) : lightMap.fragments();
        List<Aabb> boxes = brushes.stream().map(b -> b.shape().bounds()).toList();
        this.index = SpatialIndex.of(boxes);
        this.origin = boxes.stream().reduce(Aabb.EMPTY, Aabb::union).centre();
    }

    SolidGeometry mesh() {
        int corners = 0;
        for (int brush = 0; brush < brushes.size(); brush++) {
            for (int face = 0; face < brushes.get(brush).faces().size(); face++) {
                for (FaceFragment part : parts(brush, face)) {
                    corners +=
                            part.cover() == Cover.TOUCHING ? 0 : part.corners().size();
                }
            }
        }
        vertices = ByteBuffer.allocateDirect(corners * vertexBytes()).order(ByteOrder.nativeOrder());
        for (int slot = 0; slot < index.size(); slot++) {
            int brush = index.itemAt(slot);
            for (int face = 0; face < brushes.get(brush).faces().size(); face++) {
                add(brush, face);
            }
            for (Growing batch : batches.values()) {
                batch.ends[slot] = batch.size;
            }
        }
        return finished();
    }

    private int vertexBytes() {
        return SolidGeometry.VERTEX_BYTES + (lightMap == null ? 0 : SolidGeometry.LIGHT_MAP_BYTES);
    }

    private List<FaceFragment> parts(int brush, int face) {
        return fragments.get(brush).get(face);
    }

    private void add(int brush, int faceIndex) {
        BrushFace face = brushes.get(brush).faces().get(faceIndex);
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
        List<FaceFragment> parts = parts(brush, faceIndex);
        FaceTexture texture = FaceTexture.of(face, surface.material().textureMetres());
        for (int part = 0; part < parts.size(); part++) {
            // Nobody sees it, but where its edge is a wall's seam too its dark pixels would win at equal depth.
            if (parts.get(part).cover() == Cover.TOUCHING) {
                continue;
            }
            int first = vertexCount;
            for (int i = 0; i < parts.get(part).corners().size(); i++) {
                Vec3 p = parts.get(part).corners().get(i);
                addCorner(face, material - block * SolidGeometry.MATERIALS_PER_BLOCK, p, cell);
                vertices.putFloat((float) texture.s(p));
                vertices.putFloat((float) texture.t(p));
                if (lightMap != null) {
                    vertices.putShort((short) Math.round(lightMap.column(brush, faceIndex, part, p) * 16));
                    vertices.putShort((short) Math.round(lightMap.row(brush, faceIndex, part, p) * 16));
                }
            }
            batch.triangles(first, parts.get(part).triangles());
        }
    }

    private Vec3 cellOf(Vec3 p) {
        return new Vec3(
                origin.x() + CELL_METRES * Math.rint((p.x() - origin.x()) / CELL_METRES),
                origin.y() + CELL_METRES * Math.rint((p.y() - origin.y()) / CELL_METRES),
                origin.z() + CELL_METRES * Math.rint((p.z() - origin.z()) / CELL_METRES));
    }

    private void addCorner(BrushFace face, int materialIndex, Vec3 p, Vec3 cell) {
        vertices.putFloat((float) (p.x() - cell.x()));
        vertices.putFloat((float) (p.y() - cell.y()));
        vertices.putFloat((float) (p.z() - cell.z()));
        vertices.putShort(unit16(face.plane().nx()));
        vertices.putShort(unit16(face.plane().ny()));
        vertices.putShort(unit16(face.plane().nz()));
        vertices.putShort((short) materialIndex);
        vertexCount++;
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
        return new SolidGeometry(vertices, indices, done, index, origin, lightMap != null);
    }
}
