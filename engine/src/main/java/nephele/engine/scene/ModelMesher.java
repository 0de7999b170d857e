package nephele.engine.scene;

import java.nio.IntBuffer;
import java.util.List;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials.Surface;

/**
 * Turns placed models into triangles, except those that are drawn as impostors. Triangles share no vertices, because a
 * vertex also holds its triangle's normal.
 */
final class ModelMesher {
    private static final int[] TRIANGLE = {0, 1, 2};

    private final List<PlacedModel> models;
    private final SceneMaterials materials;
    private final BatchBuilder batches;
    private final VertexBytes vertices;
    private final short[] skyVisibility;
    private final int[] firstValue;
    private final MeshCopy copy;
    private final MeshCopy.MeshSpans spans;

    /**
     * Makes a mesher for all models of a level.
     *
     * @param skyVisibility for every vertex of every mesh in order, 0–65535, or {@code null}
     * @param copy the mesh of the same models with the same origin and the same light; {@code null} if there is none
     */
    ModelMesher(
            List<PlacedModel> models,
            SceneMaterials materials,
            short[] skyVisibility,
            BatchBuilder batches,
            MeshCopy copy) {
        this.models = models;
        this.materials = materials;
        this.batches = batches;
        this.skyVisibility = skyVisibility;
        this.copy = copy;
        spans = MeshCopy.MeshSpans.of(models.size());
        firstValue = new int[models.size()];
        int corners = 0;
        int values = 0;
        for (int i = 0; i < firstValue.length; i++) {
            firstValue[i] = values;
            values += models.get(i).triangles().positions().length / 3;
            corners += 3 * models.get(i).triangles().count();
        }
        vertices = new VertexBytes(corners, SolidGeometry.MODEL_VERTEX_BYTES);
    }

    void add(int model, int slot) {
        spans.begin(model, slot, vertices.count());
        boolean isMeshed =
                !models.get(model).isEmpty() && !models.get(model).authored().impostor();
        if (isMeshed && (copy == null || !copy.copy(model, vertices, batches))) {
            add(model);
        }
        spans.end(model, vertices.count());
    }

    private void add(int model) {
        PlacedModel placed = models.get(model);
        int material = materials.indexOf(placed.authored().material());
        Surface surface = materials.surfaces().get(material);
        WorldTriangles mesh = placed.triangles();
        SolidBatch.Form form = mesh.isFaceted() ? SolidBatch.Form.FACETED_MODEL : SolidBatch.Form.CURVED_MODEL;
        BatchBuilder.Growing batch =
                batches.batch(form, surface, material, placed.bounds().centre());
        for (int triangle = 0; triangle < mesh.count(); triangle++) {
            int first = vertices.count();
            Vec3 face = mesh.faceNormal(triangle);
            for (int corner = 0; corner < 3; corner++) {
                vertices.position(mesh.corner(triangle, corner), batch.cell());
                vertices.normal(face, material % SolidGeometry.MATERIALS_PER_BLOCK);
                vertices.floats(mesh.s(triangle, corner), mesh.t(triangle, corner));
                int sky = skyVisibility == null
                        ? 0
                        : skyVisibility[firstValue[model] + mesh.vertices()[3 * triangle + corner]] & 0xffff;
                vertices.normal(mesh.normal(triangle, corner), sky / 2);
            }
            batch.triangles(first, TRIANGLE);
        }
    }

    MeshCopy.MeshSpans spans() {
        return spans;
    }

    SolidGeometry.Triangles finished(IntBuffer indices) {
        return new SolidGeometry.Triangles(vertices.finished(), indices);
    }
}
