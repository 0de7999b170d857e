package nephele.engine.scene;

import java.nio.IntBuffer;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.light.FaceFragment;
import nephele.engine.scene.light.FaceFragment.Cover;
import nephele.engine.scene.light.FaceFragments;
import nephele.engine.scene.light.LightMapLayout;

/** Turns solids into triangles. */
final class SolidMesher {
    private final SceneMaterials materials;
    private final LightMapLayout lightMap;
    private final List<Brush> brushes;
    private final List<List<List<FaceFragment>>> fragments;
    private final BatchBuilder batches;
    private final VertexBytes vertices;

    SolidMesher(List<Brush> brushes, SceneMaterials materials, LightMapLayout lightMap, BatchBuilder batches) {
        this.materials = materials;
        this.lightMap = lightMap;
        this.brushes = brushes;
        this.batches = batches;
        fragments = (lightMap == null ? FaceFragments.uncut(brushes) : lightMap.fragments()).byBrush();
        int bytes = SolidGeometry.VERTEX_BYTES + (lightMap == null ? 0 : SolidGeometry.LIGHT_MAP_BYTES);
        vertices = new VertexBytes(corners(), bytes);
    }

    private int corners() {
        return fragments.stream()
                .flatMap(List::stream)
                .flatMap(List::stream)
                .filter(part -> part.cover() != Cover.TOUCHING)
                .mapToInt(part -> part.corners().size())
                .sum();
    }

    void add(int brush) {
        for (int face = 0; face < brushes.get(brush).faces().size(); face++) {
            add(brush, face);
        }
    }

    private void add(int brush, int faceIndex) {
        BrushFace face = brushes.get(brush).faces().get(faceIndex);
        int material = materials.indexOf(face.material());
        Surface surface = materials.surfaces().get(material);
        BatchBuilder.Growing batch = batches.batch(
                SolidBatch.Form.SOLID, surface, material, face.polygon().get(0));
        List<FaceFragment> parts = fragments.get(brush).get(faceIndex);
        FaceTexture texture = FaceTexture.of(face, surface.material().textureMetres());
        for (int part = 0; part < parts.size(); part++) {
            // Nobody sees it, but where its edge is a wall's seam too its dark pixels would win at equal depth.
            if (parts.get(part).cover() == Cover.TOUCHING) {
                continue;
            }
            int first = vertices.count();
            for (Vec3 p : parts.get(part).corners()) {
                vertices.position(p, batch.cell());
                vertices.normal(face.plane().normal(), material % SolidGeometry.MATERIALS_PER_BLOCK);
                vertices.floats(texture.s(p), texture.t(p));
                if (lightMap != null) {
                    vertices.shorts(
                            lightMap.column(brush, faceIndex, part, p) * 16,
                            lightMap.row(brush, faceIndex, part, p) * 16);
                }
            }
            batch.triangles(first, parts.get(part).triangles());
        }
    }

    SolidGeometry.Triangles finished(IntBuffer indices) {
        return new SolidGeometry.Triangles(vertices.finished(), indices);
    }
}
