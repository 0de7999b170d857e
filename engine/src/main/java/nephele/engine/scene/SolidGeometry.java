package nephele.engine.scene;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.SpatialIndex;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.FaceFragments;
import nephele.engine.scene.light.FaceLight;
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

    private final StaticShapes statics;
    private final StaticShapes drawn;
    private final SceneMaterials materials;
    private final SkyVisibility sky;
    private final FaceLight light;
    private final short[] skyOfModels;
    /** How the vertices came about; {@code null} in a level without a light map until it is edited, to save memory. */
    private final FaceFragments fragments;

    private final MeshSpans solidSpans;
    private final MeshSpans modelSpans;
    private final Triangles solids;
    private final Triangles models;
    private final List<SolidBatch> batches;
    private final SpatialIndex index;
    private final Vec3 origin;

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

    private SolidGeometry(
            StaticShapes statics,
            SceneMaterials materials,
            SkyVisibility sky,
            FaceFragments cut,
            SolidGeometry before) {
        boolean isUnderOldSky = before != null && before.sky == sky;
        boolean hasOldModels = isUnderOldSky && before.statics.models() == statics.models();
        this.statics = statics;
        this.materials = materials;
        this.sky = sky;
        FaceFragments parts = sky == null ? whole(statics, before) : cut;
        drawn = hasOldModels ? statics.with(before.drawn.models()) : drawn(statics, sky);
        skyOfModels = hasOldModels ? before.skyOfModels : sky == null ? null : sky.ofModels(drawn.models());
        List<StaticShape> shapes = drawn.all();
        List<Aabb> boxes = shapes.stream().map(StaticShape::bounds).toList();
        index = before == null ? SpatialIndex.of(boxes) : before.index.edited(boxes);
        origin = boxes.stream().reduce(Aabb.EMPTY, Aabb::union).centre();
        BatchBuilder solidBatches = new BatchBuilder(origin, index.size());
        BatchBuilder modelBatches = new BatchBuilder(origin, index.size());
        boolean isAtOldPlace = isUnderOldSky && before.fragments != null && before.origin.equals(origin);
        light = sky == null
                ? null
                : isUnderOldSky ? before.light.edited(drawn.solids()) : new FaceLight(sky, drawn.solids());
        SolidMesher solidMesher = new SolidMesher(
                drawn.solids(),
                parts.byBrush(),
                materials,
                light,
                solidBatches,
                isAtOldPlace ? before.knownSolids(materials) : null);
        ModelMesher modelMesher = new ModelMesher(
                drawn.models().all(),
                materials,
                skyOfModels,
                modelBatches,
                isAtOldPlace && hasOldModels ? before.knownModels(materials) : null);
        for (int slot = 0; slot < index.size(); slot++) {
            shapes.get(index.itemAt(slot)).select(new StaticMesher(solidMesher, modelMesher, slot));
            solidBatches.endSlot(slot);
            modelBatches.endSlot(slot);
        }
        List<SolidBatch> all = new ArrayList<>();
        solids = solidMesher.finished(solidBatches.finish(all));
        models = modelMesher.finished(modelBatches.finish(all));
        solidSpans = solidMesher.spans();
        modelSpans = modelMesher.spans();
        fragments = before != null || sky != null ? parts : null;
        batches = List.copyOf(all);
    }

    private SolidMesher.Before knownSolids(SceneMaterials now) {
        MeshCopy copy = new MeshCopy(solidSpans, solids, batches(false));
        return new SolidMesher.Before(drawn.solids(), fragments.byBrush(), now.changedSince(materials), copy);
    }

    /** {@code null} where one of them looks otherwise. */
    private MeshCopy knownModels(SceneMaterials now) {
        Set<String> changed = now.changedSince(materials);
        boolean isOneChanged = drawn.models().all().stream()
                .anyMatch(model -> changed.contains(model.said().material()));
        return isOneChanged ? null : new MeshCopy(modelSpans, models, batches(true));
    }

    private List<SolidBatch> batches(boolean ofModels) {
        return batches.stream()
                .filter(batch -> batch.form().isModel() == ofModels)
                .toList();
    }

    private static FaceFragments whole(StaticShapes statics, SolidGeometry before) {
        return before == null || before.sky != null || before.fragments == null
                ? FaceFragments.uncut(statics.solids())
                : before.fragments.edited(statics.solids());
    }

    private static StaticShapes drawn(StaticShapes statics, SkyVisibility sky) {
        return sky == null ? statics : statics.split(SkyVisibility.MODEL_EDGE_METRES);
    }

    /** Adds each shape to the mesh of its kind. */
    private record StaticMesher(SolidMesher solids, ModelMesher models, int slot) implements StaticShape.Cases {
        @Override
        public void convexHull(StaticShape.ConvexHull hull) {
            solids.add(hull.index(), slot);
        }

        @Override
        public void triangleMesh(StaticShape.TriangleMesh mesh) {
            models.add(mesh.model().index(), slot);
        }

        @Override
        public void heightGrid(StaticShape.HeightGrid grid) {
            // Ground is not drawn yet.
        }
    }

    /**
     * Meshes what never moves.
     *
     * @param sky how much of it is seen where, or {@code null} where its light falls on nothing
     * @param cut the solids' faces, read where {@code sky} falls on them
     */
    static SolidGeometry of(StaticShapes statics, SceneMaterials materials, SkyVisibility sky, FaceFragments cut) {
        return new SolidGeometry(statics, materials, sky, cut, null);
    }

    /** The same of an edited level, or this where nothing of it is drawn otherwise. */
    SolidGeometry edited(
            StaticShapes others, SceneMaterials otherMaterials, SkyVisibility otherSky, FaceFragments cut) {
        boolean isSame = others == statics
                && otherSky == sky
                && (otherMaterials == materials
                        || otherMaterials.changedSince(materials).isEmpty());
        return isSame ? this : new SolidGeometry(others, otherMaterials, otherSky, cut, this);
    }

    /** Middle of everything, which every cell's origin is a whole number of cells away from. */
    public Vec3 origin() {
        return origin;
    }

    /** Whether solids' vertices carry light map coordinates. */
    public boolean lightMapped() {
        return sky != null;
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
