package nephele.engine.level.layout;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Subject;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Ray;
import nephele.engine.math.RayClip;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.SpatialIndex;

/** Finds the path from the player's start out of a level that seems to be closed: through a gap that somebody forgot. */
public final class Leak {
    /** The rule that a level without sun and sky, with nothing to see outside, has no gap to the outside. */
    public static final LevelRule CLOSED = new LevelRule(LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> {
        List<Vec3> line = hasOutside(level) ? List.of() : line(level, statics);
        if (!line.isEmpty()) {
            Vec3 gap = line.get(Math.max(0, line.size() - 2));
            String message = "the level leaks: from the start one gets out into the void, near " + rounded(gap)
                    + ": close the gap";
            report.accept(Problem.warning("player.feet", message).about(new Subject(Topic.LEAK, List.of(), line)));
        }
    });

    /** Height of the start's point above the feet. */
    private static final double MIDDLE_METRES = 0.9;

    /** Free space around all shapes; its sides are the outside. */
    private static final double MARGIN_METRES = 1;

    /** Fraction of the directions from the start that have to meet a shape; a level with fewer is open on purpose. */
    private static final double CLOSED_FRACTION = 0.8;

    private static final int DIRECTIONS = 400;

    /** The golden angle in radians: directions that turn by it are spread evenly (Vogel 1979). */
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

    /** Greatest number of shapes that are searched. */
    private static final int MOST_SHAPES = 20_000;

    /** The greatest depth to which a straightened line may enter a shape, in metres. */
    private static final double GRAZE_METRES = 2e-3;

    /** Number of parts into which each step of a path is divided before it is straightened. */
    private static final int PARTS = 12;

    private static final int MOST_POINTS = 1200;

    private Leak() {}

    /**
     * Returns the points of a short line from the start to the outside; empty if the level is closed, is open on
     * purpose, has no start, or has a start inside a shape. Triangles of models count as their bounding boxes.
     */
    public static List<Vec3> line(Level level, StaticShapes statics) {
        if (level.player() == null || !statics.ground().isEmpty()) {
            return List.of();
        }
        List<FreeCells.Shape> shapes = shapes(statics);
        Vec3 from = level.player().feet().plus(new Vec3(0, MIDDLE_METRES, 0));
        if (shapes.isEmpty() || shapes.size() > MOST_SHAPES || !seemsClosed(shapes, from)) {
            return List.of();
        }
        Aabb world = Aabb.EMPTY;
        for (FreeCells.Shape shape : shapes) {
            world = world.union(shape.bounds());
        }
        world = world.grown(MARGIN_METRES);
        List<Vec3> path = FreeCells.pathOut(shapes, world, from);
        return straightened(divided(path), new BrushIndex(statics));
    }

    private static List<FreeCells.Shape> shapes(StaticShapes statics) {
        List<FreeCells.Shape> shapes = new ArrayList<>();
        List<Brush> brushes = new ArrayList<>(statics.solids());
        brushes.addAll(statics.models().solids());
        for (Brush brush : brushes) {
            shapes.add(new FreeCells.Shape(
                    brush.shape().bounds(),
                    brush.shape().faces().stream()
                            .map(ConvexPolyhedron.Face::plane)
                            .toList()));
        }
        for (PlacedModel model : statics.models().sheets()) {
            for (int i = 0; i < model.triangles().count() && shapes.size() <= MOST_SHAPES; i++) {
                shapes.add(sheet(model.triangles(), i));
            }
        }
        return shapes;
    }

    /** Returns a triangle's bounds, thick enough to be a wall. */
    private static FreeCells.Shape sheet(WorldTriangles triangles, int triangle) {
        List<Vec3> corners =
                List.of(triangles.corner(triangle, 0), triangles.corner(triangle, 1), triangles.corner(triangle, 2));
        return new FreeCells.Shape(Aabb.of(corners).grown(2 * FreeCells.LEAST_GAP_METRES), List.of());
    }

    private static boolean seemsClosed(List<FreeCells.Shape> shapes, Vec3 from) {
        SpatialIndex index =
                SpatialIndex.of(shapes.stream().map(FreeCells.Shape::bounds).toList());
        int met = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            double y = 1 - (2 * i + 1.0) / DIRECTIONS;
            double across = Math.sqrt(1 - y * y);
            double turn = i * GOLDEN_ANGLE;
            Vec3 direction = new Vec3(across * StrictMath.cos(turn), y, across * StrictMath.sin(turn));
            boolean isMet = index.anyHit(
                    Ray.of(from, direction),
                    Double.POSITIVE_INFINITY,
                    (ray, item, limit) -> entry(shapes.get(item), ray));
            met += isMet ? 1 : 0;
        }
        return met >= CLOSED_FRACTION * DIRECTIONS;
    }

    /** Clips the ray by the shape's half-spaces; a shape without planes is its bounds. */
    private static double entry(FreeCells.Shape shape, Ray ray) {
        double within = ray.boxEntry(shape.bounds(), Double.POSITIVE_INFINITY);
        RayClip clip = new RayClip(ray, within, Double.POSITIVE_INFINITY);
        shape.planes().forEach(clip::keepBehind);
        return clip.enter() <= clip.leave() ? clip.enter() : Double.POSITIVE_INFINITY;
    }

    /** Adds points between those of a path, so that it can be straightened past a corner in the middle of a cell. */
    private static List<Vec3> divided(List<Vec3> path) {
        if (path.isEmpty() || path.size() * PARTS > MOST_POINTS) {
            return path;
        }
        List<Vec3> points = new ArrayList<>(List.of(path.get(0)));
        for (int i = 1; i < path.size(); i++) {
            for (int part = 1; part <= PARTS; part++) {
                points.add(path.get(i - 1).lerp(path.get(i), (double) part / PARTS));
            }
        }
        return points;
    }

    /** Leaves points out as long as the straight line past them is free. */
    private static List<Vec3> straightened(List<Vec3> path, BrushIndex index) {
        List<Vec3> kept = new ArrayList<>();
        int at = 0;
        while (at < path.size()) {
            kept.add(path.get(at));
            int next = Math.min(at + 1, path.size() - 1);
            for (int i = path.size() - 1; i > next; i--) {
                if (!index.isBlocked(path.get(at), path.get(i), GRAZE_METRES)) {
                    next = i;
                }
            }
            at = at == path.size() - 1 ? path.size() : next;
        }
        return kept;
    }

    private static boolean hasOutside(Level level) {
        return level.environment().sky() != null || level.environment().sun() != null;
    }

    private static String rounded(Vec3 p) {
        return "[" + rounded(p.x()) + ", " + rounded(p.y()) + ", " + rounded(p.z()) + "]";
    }

    private static double rounded(double metres) {
        return Math.rint(metres * 100) / 100 + 0.0;
    }
}
