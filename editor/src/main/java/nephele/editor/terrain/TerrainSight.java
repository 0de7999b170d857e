package nephele.editor.terrain;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import nephele.editor.document.BackgroundReading;
import nephele.editor.document.PlacedLevelCache;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.Terrain;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.heightfield.HeightField;

/** Finds the terrain that a ray of sight hits. The fields of terrains that an edit leaves as they are stay the same. */
public final class TerrainSight {
    private final PlacedLevelCache placement;
    private Level bare;
    private List<Terrain> bareOf = List.of();

    /** @param background runs what reads files */
    public TerrainSight(BackgroundReading background) {
        placement = new PlacedLevelCache(background);
    }

    /** A terrain and a point on it. */
    public record Hit(Terrain terrain, HeightField field, Vec3 point) {
        /** Returns where another ray of sight hits the same heights. */
        public Optional<Hit> under(Ray ray) {
            RayHit hit = new RayHit();
            return field.nearest(ray, Double.POSITIVE_INFINITY, sees(field), hit)
                    ? Optional.of(new Hit(terrain, field, ray.at(hit.distance())))
                    : Optional.empty();
        }
    }

    /** Returns the nearest hit of a terrain that is shown; empty without one, or if a map is missing. */
    public Optional<Hit> along(Ray ray, Level level, AssetSource assets) {
        Set<String> hidden = Set.copyOf(level.editor().hidden());
        Hit nearest = null;
        RayHit hit = new RayHit();
        double limit = Double.POSITIVE_INFINITY;
        for (StaticShape.HeightGrid grid : grids(level, assets)) {
            HeightField field = grid.field();
            boolean isVisible = !hidden.contains("terrains/" + grid.authored().id());
            if (isVisible && field.nearest(ray, limit, sees(field), hit)) {
                limit = hit.distance();
                nearest = new Hit(level.terrains().get(grid.index()), field, ray.at(limit));
            }
        }
        return Optional.ofNullable(nearest);
    }

    private static ItemRayTest sees(HeightField field) {
        return (ray, triangle, limit) -> field.entry(ray, triangle);
    }

    private List<StaticShape.HeightGrid> grids(Level level, AssetSource assets) {
        List<Terrain> terrains = level.terrains();
        if (terrains.isEmpty()) {
            return List.of();
        }
        if (terrains != bareOf) {
            // Sight needs no paint, so a layer map that cannot be read hides nothing.
            bare = Level.of("", "", level.environment(), List.of())
                    .withTerrains(terrains.stream()
                            .map(terrain -> terrain.withLayerMap(null))
                            .toList());
            bareOf = terrains;
        }
        try {
            return placement.of(bare, assets).statics().ground();
        } catch (AssetException unusable) {
            return List.of();
        }
    }
}
