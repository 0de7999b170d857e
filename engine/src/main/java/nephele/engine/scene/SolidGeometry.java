package nephele.engine.scene;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.IdentityDiff;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.SpatialIndex;
import nephele.engine.scene.light.LightMapLookup;
import nephele.engine.scene.light.bake.FaceFragments;
import nephele.engine.scene.light.bake.SkyVisibility;

/**
 * The static geometry as two meshes, one of all solids and one of all models, each with one vertex buffer and one index
 * buffer, and a spatial index over both.
 *
 * <p>A solid's vertex has {@link #VERTEX_BYTES} bytes: position, three floats relative to its batch's cell origin;
 * outward normal, three 16-bit integers to be normalised, followed by the material's index within its block; texture
 * coordinates, two floats. With sky visibility there are {@link #LIGHT_MAP_BYTES} more: light map coordinates as two
 * 16-bit integers in sixteenths of a texel.
 *
 * <p>A model's vertex has {@link #MODEL_VERTEX_BYTES} bytes: the same with the triangle's normal, then the normal of
 * the surface that the mesh approximates as three 16-bit integers, followed by the sky visibility, 0 to 32767.
 */
public final class SolidGeometry {
    public static final int VERTEX_BYTES = 28;

    public static final int LIGHT_MAP_BYTES = 4;

    public static final int MODEL_VERTEX_BYTES = 36;

    /**
     * Materials per uniform block: 16 KiB, the size that every OpenGL implementation supports, at 64 bytes a material.
     */
    public static final int MATERIALS_PER_BLOCK = 256;

    private final StaticShapes statics;
    private final StaticShapes drawn;
    private final SceneMaterials materials;
    private final SkyVisibility sky;
    private final LightMapLookup light;
    private final short[] skyOfModels;
    /** The faces that were meshed; {@code null} until the first edit in a level without a light map, to save memory. */
    private final FaceFragments fragments;

    private final VertexBytes solidVertices;
    private final VertexBytes modelVertices;
    private final Triangles solids;
    private final Triangles models;
    private final List<SolidBatch> batches;
    private final SpatialIndex index;
    private final Vec3 origin;

    /**
     * The contents of one vertex array; both buffers are direct and in native byte order.
     *
     * @param indices triangles, counter-clockwise seen from outside
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
                : isUnderOldSky ? before.light.edited(drawn.solids()) : new LightMapLookup(sky, drawn.solids());
        SolidGeometry copied = isAtOldPlace ? before : null;
        SolidMesher solidMesher = new SolidMesher(
                drawn.solids(),
                parts.byBrush(),
                materials,
                light,
                solidBatches,
                known(copied, parts),
                copied == null
                        ? null
                        : new MeshCopy(copied.solidVertices, copied.solids.indices(), copied.batches(false)));
        ModelMesher modelMesher = new ModelMesher(
                drawn.models().all(),
                materials,
                skyOfModels,
                modelBatches,
                isAtOldPlace && hasOldModels ? before.knownModels(materials) : null);
        for (int i = 0; i < index.size(); i++) {
            int slot = i;
            // Another pass draws height grids.
            shapes.get(index.itemAt(slot))
                    .select(
                            hull -> solidMesher.add(hull.index(), slot),
                            mesh -> modelMesher.add(mesh.model().index(), slot),
                            grid -> {});
            solidBatches.endSlot(slot);
            modelBatches.endSlot(slot);
        }
        List<SolidBatch> all = new ArrayList<>();
        solids = solidMesher.finished(solidBatches.finish(all));
        models = modelMesher.finished(modelBatches.finish(all));
        solidVertices = solidMesher.vertices();
        modelVertices = modelMesher.vertices();
        fragments = before != null || sky != null ? parts : null;
        batches = List.copyOf(all);
    }

    /**
     * Returns for each solid its number in the mesh to copy, {@link IdentityDiff#NEW} if it has to be meshed.
     *
     * @param copied {@code null} for none
     */
    private int[] known(SolidGeometry copied, FaceFragments parts) {
        List<Brush> brushes = drawn.solids();
        int[] known = IdentityDiff.previousIndices(copied == null ? List.of() : copied.drawn.solids(), brushes);
        Set<String> changed = copied == null ? Set.of() : materials.changedSince(copied.materials);
        for (int i = 0; i < known.length; i++) {
            boolean isSame = known[i] != IdentityDiff.NEW
                    && copied.fragments.byBrush().get(known[i])
                            == parts.byBrush().get(i)
                    && brushes.get(i).faces().stream().noneMatch(face -> changed.contains(face.material()));
            known[i] = isSame ? known[i] : IdentityDiff.NEW;
        }
        return known;
    }

    /** Returns {@code null} if the material of a model has changed. */
    private MeshCopy knownModels(SceneMaterials now) {
        Set<String> changed = now.changedSince(materials);
        boolean isOneChanged = drawn.models().all().stream()
                .anyMatch(model -> changed.contains(model.authored().material()));
        return isOneChanged ? null : new MeshCopy(modelVertices, models.indices(), batches(true));
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

    /**
     * Meshes the static geometry.
     *
     * @param sky baked, or {@code null} for none; its light map is also that of other baked light
     * @param cut the solids' faces, read only if {@code sky} is not {@code null}
     */
    static SolidGeometry of(StaticShapes statics, SceneMaterials materials, SkyVisibility sky, FaceFragments cut) {
        return new SolidGeometry(statics, materials, sky, cut, null);
    }

    /** Returns the geometry of an edited level, or this object if nothing drawn has changed. */
    SolidGeometry edited(
            StaticShapes others, SceneMaterials otherMaterials, SkyVisibility otherSky, FaceFragments cut) {
        boolean isSame = others == statics
                && otherSky == sky
                && (otherMaterials == materials
                        || otherMaterials.changedSince(materials).isEmpty());
        return isSame ? this : new SolidGeometry(others, otherMaterials, otherSky, cut, this);
    }

    /** Returns the centre of all shapes; cell origins differ from it by whole numbers of cells. */
    public Vec3 origin() {
        return origin;
    }

    /** Returns true if the solids' vertices have light map coordinates. */
    public boolean lightMapped() {
        return sky != null;
    }

    public boolean isEmpty() {
        return batches.isEmpty();
    }

    /** Returns the mesh of all solids. */
    public Triangles solids() {
        return solids;
    }

    /** Returns the mesh of all models. */
    public Triangles models() {
        return models;
    }

    /** Returns all batches, those of solids before those of models. */
    public List<SolidBatch> batches() {
        return batches;
    }

    /** Returns the number of slots of the index, one per solid and model; a batch has at most as many ranges. */
    public int slotCount() {
        return index.size();
    }

    /**
     * Returns for each vertex of {@link #models} the number that it has among those of {@link StaticShapes#models}, split if
     * there is a light map.
     */
    public int[] modelVertices() {
        int[] numbers = new int[models.vertices().limit() / MODEL_VERTEX_BYTES];
        int first = 0;
        for (PlacedModel model : drawn.models().all()) {
            int at = modelVertices.first(model.index());
            for (int i = 0; i < modelVertices.count(model.index()); i++) {
                numbers[at + i] = first + model.triangles().vertices()[i];
            }
            first += model.triangles().positions().length / 3;
        }
        return numbers;
    }

    /** Returns the models as they are drawn. */
    public PlacedModels drawnModels() {
        return drawn.models();
    }

    SpatialIndex index() {
        return index;
    }
}
