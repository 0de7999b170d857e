package nephele.engine.scene;

import java.nio.IntBuffer;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.math.IdentityDiff;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.light.LightMapLookup;
import nephele.engine.scene.light.bake.FaceFragment;
import nephele.engine.scene.light.bake.FaceFragment.Cover;

/** Turns solids into triangles. */
final class SolidMesher {
    private final List<Brush> brushes;
    private final List<List<List<FaceFragment>>> fragments;
    private final SceneMaterials materials;
    private final LightMapLookup light;
    private final BatchBuilder batches;
    private final MeshCopy.MeshSpans spans;
    private final MeshCopy copy;
    /** For each solid its number in the mesh that is copied, {@link IdentityDiff#NEW} if it has to be meshed. */
    private final int[] known;

    private final VertexBytes vertices;

    /**
     * Makes a mesher for all solids of a level.
     *
     * @param light {@code null} if vertices have no light map coordinates
     * @param known for each solid its number in the mesh that is copied, {@link IdentityDiff#NEW} if it has to be meshed
     * @param copy the mesh with the same origin and the same light; {@code null} if all solids have to be meshed
     */
    SolidMesher(
            List<Brush> brushes,
            List<List<List<FaceFragment>>> fragments,
            SceneMaterials materials,
            LightMapLookup light,
            BatchBuilder batches,
            int[] known,
            MeshCopy copy) {
        this.brushes = brushes;
        this.fragments = fragments;
        this.materials = materials;
        this.light = light;
        this.batches = batches;
        this.known = known;
        this.copy = copy;
        int bytes = SolidGeometry.VERTEX_BYTES + (light == null ? 0 : SolidGeometry.LIGHT_MAP_BYTES);
        vertices = new VertexBytes(corners(), bytes);
        spans = MeshCopy.MeshSpans.of(brushes.size());
    }

    private int corners() {
        int corners = 0;
        for (int i = 0; i < known.length; i++) {
            corners += known[i] != IdentityDiff.NEW ? copy.vertices(known[i]) : corners(fragments.get(i));
        }
        return corners;
    }

    private static int corners(List<List<FaceFragment>> faces) {
        return faces.stream()
                .flatMap(List::stream)
                .filter(SolidMesher::isDrawn)
                .mapToInt(part -> part.corners().size())
                .sum();
    }

    /**
     * Returns false for covered touching faces. They are invisible, but if one shares an edge with a visible face, its
     * dark pixels would win at equal depth there.
     */
    private static boolean isDrawn(FaceFragment part) {
        return part.cover() != Cover.TOUCHING;
    }

    void add(int number, int slot) {
        spans.begin(number, slot, vertices.count());
        if (known[number] == IdentityDiff.NEW || !copy.copy(known[number], vertices, batches)) {
            for (int face = 0; face < brushes.get(number).faces().size(); face++) {
                addFace(number, face);
            }
        }
        spans.end(number, vertices.count());
    }

    private void addFace(int brush, int faceIndex) {
        BrushFace face = brushes.get(brush).faces().get(faceIndex);
        int material = materials.indexOf(face.material());
        Surface surface = materials.surfaces().get(material);
        BatchBuilder.Growing batch = batches.batch(
                form(face, surface), surface, material, face.polygon().get(0));
        List<FaceFragment> parts = fragments.get(brush).get(faceIndex);
        FaceTexture texture = FaceTexture.of(face, surface.material().textureMetres());
        Vec3 normal = face.plane().normal();
        for (int part = 0; part < parts.size(); part++) {
            if (!isDrawn(parts.get(part))) {
                continue;
            }
            LightMapLookup.Spot spot = light == null ? null : light.of(brush, faceIndex, part, parts.get(part));
            int first = vertices.count();
            for (Vec3 p : parts.get(part).corners()) {
                vertices.position(p, batch.cell());
                vertices.normal(normal, material % SolidGeometry.MATERIALS_PER_BLOCK);
                vertices.floats(texture.s(p), texture.t(p));
                if (spot != null) {
                    vertices.shorts(spot.columnOf(p) * 16, spot.rowOf(p) * 16);
                }
            }
            batch.triangles(first, parts.get(part).triangles());
        }
    }

    private static SolidBatch.Form form(BrushFace face, Surface surface) {
        boolean isTurned = face.texture() != null && face.texture().isTurned();
        return isTurned && surface.material().normalTexture() != null
                ? SolidBatch.Form.TURNED_SOLID
                : SolidBatch.Form.SOLID;
    }

    MeshCopy.MeshSpans spans() {
        return spans;
    }

    SolidGeometry.Triangles finished(IntBuffer indices) {
        return new SolidGeometry.Triangles(vertices.finished(), indices);
    }
}
