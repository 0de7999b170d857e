package nephele.engine.rule;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.Consumer;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.HeightMap;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.Terrain;
import nephele.engine.level.json.NumberText;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.terrain.LayerPaint;
import nephele.engine.level.terrain.TerrainField;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightFieldSurface;

/** Rules for terrains: layers leave nothing bare, maps can be read, and what moves starts above them. */
final class TerrainRules {
    /** The height difference of two values of a map from which terraces are seen and felt. */
    private static final double STEP_METRES = 0.1;

    static final LevelRule LAYERS =
            LevelRule.ofRecords((level, report) -> LevelRule.each("terrains", level.terrains(), (path, terrain) -> {
                Terrain.HeightRange range = terrain.heightRangeMetres();
                if (range.low() > range.high()) {
                    report.accept(Problem.error(
                            path + ".heightRangeMetres", "the lowest height comes first: exchange the two"));
                    return;
                }
                int wrong = 0;
                for (int i = 0; i < terrain.layers().size(); i++) {
                    wrong += limits(path + ".layers[" + i + "]", terrain, i, report) ? 0 : 1;
                }
                if (wrong == 0 && !terrain.layers().isEmpty()) {
                    cover(path + ".layers", terrain, report);
                }
            }));

    static final LevelRule READABLE = new LevelRule(LevelRule.Stage.FILES, (level, assets, statics, report) -> {
        Map<String, String> objections = new HashMap<>();
        LevelRule.each("terrains", level.terrains(), (path, terrain) -> {
            readable(path, terrain, assets, objections, report);
            paintable(path, terrain, assets, report);
        });
    });

    /** The player and bodies start above terrains: below one there is nothing to stand on, and they fall for ever. */
    static final LevelRule ABOVE = new LevelRule(LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> {
        if (level.player() != null) {
            Vec3 feet = level.player().feet();
            double ground = above(statics, feet);
            if (feet.y() < ground - 1e-3) {
                report.accept(Problem.error("player.feet", "the player starts below the ground" + remedy(ground))
                        .about(Topic.ENTITY_IN_SOLID));
            }
        }
        for (int i = 0; i < level.bodies().size(); i++) {
            Vec3 centre = level.bodies().get(i).centre();
            double ground = above(statics, centre);
            if (centre.y() < ground) {
                report.accept(Problem.error(
                                "bodies[" + i + "].centre", "the body's middle is below the ground" + remedy(ground))
                        .about(Topic.ENTITY_IN_SOLID));
            }
        }
    });

    private TerrainRules() {}

    /** Returns false after it has reported an error. */
    private static boolean limits(String path, Terrain terrain, int index, Consumer<Problem> report) {
        Terrain.Layer layer = terrain.layers().get(index);
        Terrain.HeightRange range = terrain.heightRangeMetres();
        double metres = layer.toMetres() - layer.fromMetres();
        if (!(metres > 0)) {
            report.accept(
                    Problem.error(path + ".toMetres", "the layer ends where it begins: give it a greater height"));
            return false;
        }
        if (!(layer.maxSlopeDegrees() > layer.minSlopeDegrees())) {
            report.accept(Problem.error(
                    path + ".maxSlopeDegrees", "no slope is between the limits: make it greater than minSlopeDegrees"));
            return false;
        }
        if (layer.blendMetres() > metres) {
            report.accept(Problem.error(
                    path + ".blendMetres",
                    "the layer is " + text(metres) + " m high and never reaches its full share: blend over less"));
            return false;
        }
        double half = layer.blendMetres() / 2;
        boolean isOutside = layer.fromMetres() - half > range.high() || layer.toMetres() + half < range.low();
        if (isOutside && terrain.layerMap() == null) {
            report.accept(Problem.warning(
                    path,
                    "it is above or below all of the terrain's heights, " + text(range.low()) + " m to "
                            + text(range.high()) + " m: change its limits, paint it, or delete it"));
        }
        return true;
    }

    /** Reports the first rectangle of heights and slopes without a layer, and the first with two whole ones. */
    private static void cover(String path, Terrain terrain, Consumer<Problem> report) {
        Terrain.HeightRange range = terrain.heightRangeMetres();
        double[] heights = limits(terrain, range.low(), range.high(), true);
        double[] slopes = limits(terrain, 0, 90, false);
        boolean isReported = false;
        for (int h = 0; h + 1 < heights.length; h++) {
            for (int s = 0; s + 1 < slopes.length; s++) {
                List<Integer> there = at(terrain, (heights[h] + heights[h + 1]) / 2, (slopes[s] + slopes[s + 1]) / 2);
                String where = "heights of " + text(heights[h]) + " m to " + text(heights[h + 1]) + " m with slopes of "
                        + text(slopes[s]) + "° to " + text(slopes[s + 1]) + "°";
                if (there.isEmpty()) {
                    report.accept(
                            Problem.error(path, where + " have no layer: widen the limits of one, or add a layer"));
                    return;
                }
                if (there.size() > 1 && !isReported) {
                    isReported = true;
                    report.accept(Problem.warning(
                            path + "[" + there.get(1) + "]",
                            where + " also have layers[" + there.get(0)
                                    + "], in equal shares: let one begin where the other ends"));
                }
            }
        }
    }

    /** Returns the limits of all layers from least to most, in order. */
    private static double[] limits(Terrain terrain, double least, double most, boolean ofHeights) {
        TreeSet<Double> limits = new TreeSet<>(List.of(least, most));
        for (Terrain.Layer layer : terrain.layers()) {
            for (double limit : ofHeights
                    ? new double[] {layer.fromMetres(), layer.toMetres()}
                    : new double[] {layer.minSlopeDegrees(), layer.maxSlopeDegrees()}) {
                if (limit > least && limit < most) {
                    limits.add(limit);
                }
            }
        }
        double[] all = limits.stream().mapToDouble(Double::doubleValue).toArray();
        return all.length == 1 ? new double[] {least, most} : all;
    }

    private static List<Integer> at(Terrain terrain, double height, double slope) {
        List<Integer> there = new ArrayList<>();
        for (int i = 0; i < terrain.layers().size(); i++) {
            Terrain.Layer layer = terrain.layers().get(i);
            boolean isHigh = height >= layer.fromMetres() && height <= layer.toMetres();
            if (isHigh && slope >= layer.minSlopeDegrees() && slope <= layer.maxSlopeDegrees()) {
                there.add(i);
            }
        }
        return there;
    }

    private static void readable(
            String path,
            Terrain terrain,
            AssetSource assets,
            Map<String, String> objections,
            Consumer<Problem> report) {
        String file = terrain.heightMap();
        try {
            if (!objections.containsKey(file)) {
                HeightMap map = HeightMap.read(file, assets.bytes(file));
                TerrainField.requireSize(terrain, map);
                steps(path, terrain, map, report);
                if (map.seemsSwapped()) {
                    report.accept(Problem.warning(path + ".heightMap", swapped(file)));
                }
            }
        } catch (AssetException problem) {
            objections.put(file, problem.getMessage());
        }
        if (objections.containsKey(file)) {
            report.accept(
                    Problem.error(path + ".heightMap", objections.get(file)).about(Topic.MISSING_ASSET));
        }
    }

    private static void paintable(String path, Terrain terrain, AssetSource assets, Consumer<Problem> report) {
        try {
            LayerPaint.read(terrain, assets);
        } catch (AssetException problem) {
            report.accept(
                    Problem.error(path + ".layerMap", problem.getMessage()).about(Topic.MISSING_ASSET));
        }
    }

    private static void steps(String path, Terrain terrain, HeightMap map, Consumer<Problem> report) {
        Terrain.HeightRange range = terrain.heightRangeMetres();
        double step = (range.high() - range.low()) / 255;
        if (map.bits() == 8 && step > STEP_METRES) {
            report.accept(Problem.warning(
                    path + ".heightMap",
                    terrain.heightMap() + " has 8 bits: over " + text(range.high() - range.low())
                            + " m the ground has steps of " + text(Math.rint(step * 100) / 100)
                            + " m; save it with 16 bits, or make heightRangeMetres smaller"));
        }
    }

    private static String swapped(String file) {
        return file + " is as rough as noise, and would be smooth with the two bytes of each number exchanged: "
                + (HeightMap.isRaw(file) ? "write it with the low byte first" : "save it again from its source");
    }

    private static String text(double number) {
        return NumberText.of(number);
    }

    private static String remedy(double ground) {
        return ", which is at y = " + NumberText.of(Math.rint(ground * 100) / 100) + " there: move it up";
    }

    /** Returns the y of the lowest ground above a point; negative infinity without. */
    private static double above(StaticShapes statics, Vec3 point) {
        double lowest = Double.POSITIVE_INFINITY;
        for (var grid : statics.ground()) {
            double y = HeightFieldSurface.y(grid.field(), point.x(), point.z());
            if (y <= point.y()) {
                return Double.NEGATIVE_INFINITY;
            }
            lowest = y < lowest ? y : lowest;
        }
        return lowest == Double.POSITIVE_INFINITY ? Double.NEGATIVE_INFINITY : lowest;
    }
}
