package nephele.engine.scene;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.SpatialIndex;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.LightMapLayout;
import nephele.engine.scene.light.SkyVisibility;

/**
 * All solids as one static mesh, all models as another: what never moves is drawn from one vertex and one index buffer
 * each, and found by one index.
 *
 * <p>A solid's vertex takes {@link #VERTEX_BYTES}: position, three floats relative to its batch's cell origin; outward
 * normal, three 16-bit integers to be normalised, and with them the material's index within its block; texture
 * coordinates, two floats. With sky visibility {@link #LIGHT_MAP_BYTES} more: light map coordinates as two 16-bit integers
 * in sixteenths of a texel.
 *
 * <p>A model's vertex takes {@link #MODEL_VERTEX_BYTES}: the same, the normal being its triangle's, and the normal of the
 * surface that the mesh stands for as three 16-bit integers, with the sky visibility as a fourth, 0 to 32767.
 */
public final class SolidGeometry {
    public static final int VERTEX_BYTES = 28;

    public static final int LIGHT_MAP_BYTES = 4;

    public static final int MODEL_VERTEX_BYTES = 36;

    /** Materials per uniform block: 16 KiB, which every OpenGL allows, at 64 bytes a material. */
    public static final int MATERIALS_PER_BLOCK = 256;

    private final Triangles solids;
    private final Triangles models;
    private final List<SolidBatch> batches;
    private final SpatialIndex index;
    private final Vec3 origin;
    private final boolean lightMapped;

    /**
     * What one vertex array is made of; both direct, native byte order.
     *
     * @param indices triangles counter-clockwise seen from outside
     */
    public record Triangles(ByteBuffer vertices, IntBuffer indices) {
        public boolean isEmpty() {
            return indices.limit() == 0;
        }
    }

    private SolidGeometry(StaticShapes statics, SceneMaterials materials, SkyVisibility sky) {
        List<StaticShape> shapes = statics.all();
        List<Aabb> boxes = shapes.stream().map(StaticShape::bounds).toList();
        index = SpatialIndex.of(boxes);
        origin = boxes.stream().reduce(Aabb.EMPTY, Aabb::union).centre();
        lightMapped = sky != null;
        LightMapLayout lightMap = sky == null ? null : sky.layout();
        BatchBuilder solidBatches = new BatchBuilder(origin, index.size());
        BatchBuilder modelBatches = new BatchBuilder(origin, index.size());
        SolidMesher solidMesher = new SolidMesher(statics.solids(), materials, lightMap, solidBatches);
        ModelMesher modelMesher =
                new ModelMesher(statics.models().all(), materials, sky == null ? null : sky.ofModels(), modelBatches);
        StaticShape.Cases mesher = new StaticMesher(solidMesher, modelMesher);
        for (int slot = 0; slot < index.size(); slot++) {
            shapes.get(index.itemAt(slot)).select(mesher);
            solidBatches.endSlot(slot);
            modelBatches.endSlot(slot);
        }
        List<SolidBatch> all = new ArrayList<>();
        solids = solidMesher.finished(solidBatches.finish(all));
        models = modelMesher.finished(modelBatches.finish(all));
        batches = List.copyOf(all);
    }

    /** Adds each shape to the mesh of its kind. */
    private record StaticMesher(SolidMesher solids, ModelMesher models) implements StaticShape.Cases {
        @Override
        public void convexHull(StaticShape.ConvexHull hull) {
            solids.add(hull.index());
        }

        @Override
        public void triangleMesh(StaticShape.TriangleMesh mesh) {
            models.add(mesh.model().index());
        }

        @Override
        public void heightGrid(StaticShape.HeightGrid grid) {
            // Ground is not drawn yet.
        }
    }

    /** @param sky how much of it is seen where, or {@code null} where its light falls on nothing */
    public static SolidGeometry of(StaticShapes statics, SceneMaterials materials, SkyVisibility sky) {
        return new SolidGeometry(statics, materials, sky);
    }

    /** Middle of everything, which every cell's origin is a whole number of cells away from. */
    public Vec3 origin() {
        return origin;
    }

    /** Whether solids' vertices carry light map coordinates. */
    public boolean lightMapped() {
        return lightMapped;
    }

    public boolean isEmpty() {
        return batches.isEmpty();
    }

    public Triangles solids() {
        return solids;
    }

    public Triangles models() {
        return models;
    }

    /** Those of solids before those of models. */
    public List<SolidBatch> batches() {
        return batches;
    }

    /** Slots of the index, one for each solid and each model; no batch can be cut into more ranges. */
    public int slotCount() {
        return index.size();
    }

    SpatialIndex index() {
        return index;
    }
}
