package nephele.engine.level.placed;

import java.util.List;
import java.util.Set;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.MirrorFaces;
import nephele.engine.math.Aabb;

/** What of a level never moves, as shapes in the world: its solids in their order, and its models. */
public record StaticShapes(List<Brush> solids, PlacedModels models) {
    /** @throws nephele.engine.asset.AssetException naming a mesh that is missing or cannot be used */
    public static StaticShapes of(Level level, AssetSource assets) {
        return new StaticShapes(brushes(level), PlacedModels.of(level, assets));
    }

    /**
     * Of a level without models.
     *
     * @throws IllegalArgumentException when it has some: their files are needed
     */
    public static StaticShapes of(Level level) {
        if (!level.models().isEmpty()) {
            throw new IllegalArgumentException("a level with models is nothing without their files");
        }
        return of(brushes(level));
    }

    public static StaticShapes of(List<Brush> solids) {
        return new StaticShapes(solids, PlacedModels.NONE);
    }

    private static List<Brush> brushes(Level level) {
        Set<String> mirrors = MirrorFaces.materials(level.materials());
        return level.solids().stream()
                .map(solid -> Brush.of(solid).refusingPortalsOn(mirrors))
                .toList();
    }

    /** As {@link PlacedModels#split}. */
    public StaticShapes split(double edgeMetres) {
        return models.isEmpty() ? this : new StaticShapes(solids, models.split(edgeMetres));
    }

    /** Around everything; empty for nothing. */
    public Aabb bounds() {
        Aabb all = Aabb.EMPTY;
        for (Brush solid : solids) {
            all = all.union(solid.shape().bounds());
        }
        for (PlacedModel model : models.all()) {
            all = all.union(model.bounds());
        }
        return all;
    }
}
