package nephele.engine.level.placed;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.level.ModelPlacement.TransformStep.Rotate;
import nephele.engine.level.ModelPlacement.TransformStep.Scale;
import nephele.engine.level.ModelPlacement.TransformStep.Translate;
import nephele.engine.math.Aabb;
import nephele.engine.math.IdentityDiff;
import nephele.engine.math.Rotations;
import nephele.engine.math.bvh.SpatialIndex;
import nephele.engine.model.Mesh;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;

/** A level's models, each file read once; immutable. */
public record PlacedModels(List<PlacedModel> all) {
    public static final PlacedModels NONE = new PlacedModels(List.of());

    /** Upper bound of the triangles of all models together; each is drawn, casts shadows and is solid. */
    public static final int MOST_TRIANGLES = 200_000;

    /** Above this mean, a tick takes a tenth of a second or more. A closed mesh of small triangles has 10 to 30. */
    private static final int MOST_OVERLAPS = 4_000;

    private static final int OVERLAP_SAMPLES = 64;

    /** The size of the world, as for everything placed in a level. */
    private static final double FARTHEST_METRES = 1e7;

    /**
     * Reads and places the models.
     *
     * @throws AssetException that names a file that is missing or cannot be used, also for its size in the world
     * @throws IllegalArgumentException if parents are missing or in a cycle; a level rule reports that first
     */
    public static PlacedModels of(Level level, AssetSource assets) {
        return of(level, new MeshAssets(assets)::mesh);
    }

    /**
     * Places the models.
     *
     * @param meshOf returns a file's mesh; called once for each file
     */
    public static PlacedModels of(Level level, Function<String, Mesh> meshOf) {
        return level.models().isEmpty() ? NONE : NONE.edited(level, meshOf);
    }

    /** Returns the models of an edited level; a model with the same placement and file stays the same object. */
    PlacedModels edited(Level level, AssetSource assets) {
        List<ModelPlacement> authored = all.stream().map(PlacedModel::authored).toList();
        return IdentityDiff.list(authored, level.models()) == authored
                ? this
                : edited(level, new MeshAssets(assets)::mesh);
    }

    private PlacedModels edited(Level level, Function<String, Mesh> meshOf) {
        List<Matrix4dc> frames = ModelFrames.of(level.models());
        Map<String, Mesh> meshes = new HashMap<>();
        Map<ModelPlacement, PlacedModel> known = new IdentityHashMap<>();
        for (PlacedModel model : all) {
            meshes.put(model.authored().file(), model.mesh());
            known.put(model.authored(), model);
        }
        List<PlacedModel> placed = new ArrayList<>();
        long triangles = 0;
        for (int i = 0; i < level.models().size(); i++) {
            ModelPlacement authored = level.models().get(i);
            Mesh mesh = meshes.computeIfAbsent(authored.file(), meshOf);
            triangles += mesh.triangleCount();
            requireFew(authored, triangles);
            PlacedModel model = known.get(authored);
            if (model == null || !model.worldFromModel().equals(frames.get(i))) {
                model = PlacedModel.of(i, authored, mesh, frames.get(i));
                requireNear(model);
            }
            placed.add(model.at(i));
        }
        requireSparse(placed);
        return new PlacedModels(List.copyOf(placed));
    }

    private static void requireSparse(List<PlacedModel> placed) {
        long overlaps = meanOverlaps(placed);
        if (overlaps > MOST_OVERLAPS) {
            PlacedModel most = Collections.max(
                    placed, Comparator.comparingInt(model -> model.triangles().count()));
            throw new AssetException(
                    most.authored().file(),
                    "the models' triangles lie in each other: the box around one meets " + overlaps
                            + " others on average, of " + MOST_OVERLAPS + " that are quick enough; '"
                            + most.authored().id() + "' has the most triangles",
                    "split its long triangles, or leave some out");
        }
    }

    /**
     * Returns how many triangle bounds each triangle's bounds overlap on average, estimated from the same samples in every
     * run: the number of triangles that rays and sweeps must test there. Convex solids are single shapes and do not count.
     */
    private static long meanOverlaps(List<PlacedModel> models) {
        List<Aabb> boxes = new ArrayList<>();
        for (PlacedModel model : models) {
            WorldTriangles triangles = model.triangles();
            for (int i = 0; model.solid() == null && i < triangles.count(); i++) {
                boxes.add(Aabb.of(List.of(triangles.corner(i, 0), triangles.corner(i, 1), triangles.corner(i, 2))));
            }
        }
        if (boxes.size() <= MOST_OVERLAPS) {
            return 0;
        }
        SpatialIndex index = SpatialIndex.of(boxes);
        long[] overlaps = {0};
        for (int i = 0; i < OVERLAP_SAMPLES; i++) {
            index.overlapping(boxes.get((int) ((i + 0.5) * boxes.size() / OVERLAP_SAMPLES)), other -> overlaps[0]++);
        }
        return overlaps[0] / OVERLAP_SAMPLES;
    }

    private static void requireFew(ModelPlacement authored, long triangles) {
        if (triangles > MOST_TRIANGLES) {
            throw new AssetException(
                    authored.file(),
                    "with '" + authored.id() + "' the level's models have " + triangles + " triangles or more, of "
                            + MOST_TRIANGLES + " that a level may have",
                    "place fewer models or coarser ones");
        }
    }

    private static void requireNear(PlacedModel model) {
        // This also rejects overflow, which would otherwise be removed as a triangle without area.
        if (!Arrays.stream(model.triangles().positions()).allMatch(x -> Math.abs(x) <= FARTHEST_METRES)) {
            throw new AssetException(
                    model.authored().file(),
                    "as '" + model.authored().id() + "' it reaches farther than 10 000 km",
                    "scale it down or move it nearer");
        }
    }

    /**
     * Returns these models with the triangles of faceted ones subdivided until no edge is longer, or until their number
     * reaches the limit of a level.
     *
     * @param edgeMetres greatest edge length, if the limit permits it
     */
    public PlacedModels split(double edgeMetres) {
        int most = all.isEmpty() ? 0 : MOST_TRIANGLES / all.size();
        return new PlacedModels(all.stream()
                .map(model -> model.triangles().isFaceted() ? model.split(edgeMetres, most) : model)
                .toList());
    }

    /** Returns the number of vertices of all meshes. */
    public int vertexCount() {
        return all.stream()
                .mapToInt(model -> model.triangles().positions().length / 3)
                .sum();
    }

    public boolean isEmpty() {
        return all.isEmpty();
    }

    /** Returns the shapes of the models that are convex and closed. */
    public List<Brush> solids() {
        return all.stream()
                .filter(model -> model.solid() != null)
                .map(PlacedModel::solid)
                .toList();
    }

    /** Returns the other models: surfaces without an interior. */
    public List<PlacedModel> sheets() {
        return all.stream().filter(model -> model.solid() == null).toList();
    }

    /**
     * The frames of models in the world. They have the same bits on every machine, because collision shapes follow from
     * them.
     */
    static final class ModelFrames {
        private final List<ModelPlacement> models;
        private final Map<String, Integer> indexById = new HashMap<>();
        private final Matrix4d[] worldFromModel;

        private ModelFrames(List<ModelPlacement> models) {
            this.models = models;
            worldFromModel = new Matrix4d[models.size()];
            for (int i = 0; i < models.size(); i++) {
                indexById.put(models.get(i).id(), i);
            }
        }

        /**
         * Returns world-from-model of each model: the parent's frame outermost, then its own steps in order.
         *
         * @throws IllegalArgumentException if a parent is missing or in a cycle; a level rule reports that first
         */
        static List<Matrix4dc> of(List<ModelPlacement> models) {
            ModelFrames frames = new ModelFrames(models);
            for (int i = 0; i < models.size(); i++) {
                frames.find(i);
            }
            return List.copyOf(Arrays.asList(frames.worldFromModel));
        }

        /**
         * Goes up to the nearest ancestor with a frame, then down again, without recursion, so that chains may have any
         * length.
         */
        private void find(int model) {
            Deque<Integer> waiting = new ArrayDeque<>();
            int at = model;
            while (at >= 0 && worldFromModel[at] == null) {
                waiting.push(at);
                at = parent(at);
                if (waiting.size() > models.size()) {
                    throw new IllegalArgumentException("'" + models.get(model).id() + "' hangs below itself");
                }
            }
            Matrix4d frame = at < 0 ? new Matrix4d() : worldFromModel[at];
            while (!waiting.isEmpty()) {
                int next = waiting.pop();
                frame = new Matrix4d(frame);
                for (TransformStep step : models.get(next).transform()) {
                    apply(step, frame);
                }
                worldFromModel[next] = frame;
            }
        }

        private static void apply(TransformStep step, Matrix4d frame) {
            if (step instanceof Translate translate) {
                frame.translate(
                        translate.by().x(), translate.by().y(), translate.by().z());
            } else if (step instanceof Rotate rotate) {
                frame.rotate(Rotations.aroundAxis(rotate.axis(), StrictMath.toRadians(rotate.angleDegrees())));
            } else if (step instanceof Scale scale) {
                frame.scale(scale.by().x(), scale.by().y(), scale.by().z());
            }
        }

        /** Returns −1 for none. */
        private int parent(int model) {
            String id = models.get(model).parent();
            if (id == null) {
                return -1;
            }
            Integer parent = indexById.get(id);
            if (parent == null) {
                throw new IllegalArgumentException("there is no model '" + id + "'");
            }
            return parent;
        }
    }
}
