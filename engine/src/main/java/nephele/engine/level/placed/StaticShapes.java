package nephele.engine.level.placed;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.HeightMap;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.level.terrain.LayerPaint;
import nephele.engine.level.terrain.TerrainField;
import nephele.engine.math.Aabb;
import nephele.engine.math.IdentityDiff;
import nephele.engine.math.heightfield.HeightField;

/**
 * The static shapes of a level, in the world; immutable. Built once for scene, simulation and reference path tracer.
 *
 * @param solids in the level's order
 */
public record StaticShapes(List<Brush> solids, PlacedModels models, List<StaticShape.HeightGrid> ground) {
    public StaticShapes {
        solids = List.copyOf(solids);
        ground = List.copyOf(ground);
    }

    /**
     * Derives the shapes and reads the level's meshes and height maps.
     *
     * @throws nephele.engine.asset.AssetException that names a mesh or height map that is missing or cannot be used
     */
    public static StaticShapes of(Level level, AssetSource assets) {
        return new StaticShapes(brushes(level), PlacedModels.of(level, assets), grounds(level, assets));
    }

    /**
     * Derives the shapes of a level without models and terrains.
     *
     * @throws IllegalArgumentException if it has any, which need their files
     */
    public static StaticShapes of(Level level) {
        if (!level.models().isEmpty() || !level.terrains().isEmpty()) {
            throw new IllegalArgumentException("a level with models or terrains is nothing without their files");
        }
        return of(brushes(level));
    }

    public static StaticShapes of(List<Brush> solids) {
        return new StaticShapes(solids, PlacedModels.NONE, List.of());
    }

    private static List<Brush> brushes(Level level) {
        Set<String> mirrors = MirrorFaces.materials(level.materials());
        return level.solids().stream().map(solid -> brush(solid, mirrors)).toList();
    }

    private static Brush brush(Solid solid, Set<String> mirrors) {
        return Brush.of(solid).refusingPortalsOn(mirrors);
    }

    /**
     * Returns the shapes of an edited level; reuses those of unchanged records.
     *
     * @param before the level of these shapes
     */
    StaticShapes edited(Level before, Level level, AssetSource assets) {
        Set<String> mirrors = MirrorFaces.materials(level.materials());
        boolean areMirrorsSame = MirrorFaces.materials(before.materials()).equals(mirrors);
        int[] places = IdentityDiff.previousIndices(areMirrorsSame ? before.solids() : List.of(), level.solids());
        List<Brush> brushes = new ArrayList<>(places.length);
        for (int i = 0; i < places.length; i++) {
            brushes.add(places[i] == IdentityDiff.NEW ? brush(level.solids().get(i), mirrors) : solids.get(places[i]));
        }
        List<Brush> others = IdentityDiff.list(solids, brushes);
        PlacedModels placed = models.edited(level, assets);
        List<StaticShape.HeightGrid> grids = editedGrounds(ground, level, assets);
        return others == solids && placed == models && grids == ground ? this : new StaticShapes(others, placed, grids);
    }

    /** Returns these shapes with other models. */
    public StaticShapes with(PlacedModels others) {
        return new StaticShapes(solids, others, ground);
    }

    /** Returns these shapes with the triangles of models subdivided as by {@link PlacedModels#split}. */
    public StaticShapes split(double edgeMetres) {
        return models.isEmpty() ? this : with(models.split(edgeMetres));
    }

    /** Returns every shape: solids, models, height fields. */
    public List<StaticShape> all() {
        List<StaticShape> all = new ArrayList<>(solids.size() + models.all().size() + ground.size());
        for (int i = 0; i < solids.size(); i++) {
            all.add(new StaticShape.ConvexHull(i, solids.get(i)));
        }
        models.all().forEach(model -> all.add(new StaticShape.TriangleMesh(model)));
        all.addAll(ground);
        return all;
    }

    /** Calls for each shape the function for its kind, in the order of {@link #all}. */
    public void forEach(
            Consumer<StaticShape.ConvexHull> hull,
            Consumer<StaticShape.TriangleMesh> mesh,
            Consumer<StaticShape.HeightGrid> grid) {
        all().forEach(shape -> shape.select(hull, mesh, grid));
    }

    /** Returns the bounds of all shapes; empty if there are none. */
    public Aabb bounds() {
        return all().stream().map(StaticShape::bounds).reduce(Aabb.EMPTY, Aabb::union);
    }

    private static List<StaticShape.HeightGrid> grounds(Level level, AssetSource assets) {
        return editedGrounds(List.of(), level, assets);
    }

    /**
     * Returns the grids of an edited level; the list itself if nothing has changed, and the heights of terrains that only
     * look different or lie elsewhere.
     *
     * @throws nephele.engine.asset.AssetException that names a height or layer map that is missing or cannot be used
     */
    private static List<StaticShape.HeightGrid> editedGrounds(
            List<StaticShape.HeightGrid> before, Level level, AssetSource assets) {
        List<Terrain> terrains = level.terrains();
        Map<String, HeightMap> maps = new HashMap<>();
        List<StaticShape.HeightGrid> grids = new ArrayList<>(terrains.size());
        for (int i = 0; i < terrains.size(); i++) {
            grids.add(grid(i, terrains.get(i), before, maps, assets));
        }
        return grids.equals(before) ? before : List.copyOf(grids);
    }

    private static StaticShape.HeightGrid grid(
            int index,
            Terrain authored,
            List<StaticShape.HeightGrid> before,
            Map<String, HeightMap> maps,
            AssetSource assets) {
        for (StaticShape.HeightGrid known : before) {
            if (TerrainField.isSameShape(known.authored(), authored)) {
                boolean isAtSamePlace = known.authored().centre().equals(authored.centre());
                HeightField field = isAtSamePlace ? known.field() : TerrainField.moved(known.field(), authored);
                boolean isSame = isAtSamePlace && known.index() == index && known.authored() == authored;
                return isSame
                        ? known
                        : new StaticShape.HeightGrid(index, authored, field, painted(authored, known, assets));
            }
        }
        HeightMap map = maps.computeIfAbsent(
                authored.heightMap(), file -> assets.decoded(file, HeightMap.class, HeightMap::read));
        return editedGrid(index, authored, map, before, assets);
    }

    /** Returns a grid of other heights, from those of the same terrain before if there are some. */
    private static StaticShape.HeightGrid editedGrid(
            int index, Terrain authored, HeightMap map, List<StaticShape.HeightGrid> before, AssetSource assets) {
        for (StaticShape.HeightGrid known : before) {
            if (known.id().equals(authored.id())) {
                HeightField field = TerrainField.edited(known.field(), authored, map);
                return new StaticShape.HeightGrid(index, authored, field, painted(authored, known, assets));
            }
        }
        return new StaticShape.HeightGrid(
                index, authored, TerrainField.of(authored, map), LayerPaint.read(authored, assets));
    }

    /** Returns the layer map of a terrain, if possible the object that it had before. */
    private static Optional<LayerMap> painted(Terrain authored, StaticShape.HeightGrid known, AssetSource assets) {
        boolean isSame = Objects.equals(authored.layerMap(), known.authored().layerMap())
                && authored.layers().size() == known.authored().layers().size();
        return isSame ? known.painted() : LayerPaint.read(authored, assets);
    }
}
