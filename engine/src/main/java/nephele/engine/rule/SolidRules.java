package nephele.engine.rule;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Subject;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.Solid;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.level.layout.BrushIndex;
import nephele.engine.level.layout.FacePath;
import nephele.engine.level.layout.FirstProblems;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;

/** Rules for solids: they enclose volumes, have an effect, and are not too many. */
final class SolidRules {
    private static final Set<String> WEDGE_FACES = Set.of("+x", "-x", "-y", "+z", "-z", "slope");

    /** Number of triples of planes whose intersections are examined before the rule stops: about a second of work. */
    private static final long MOST_TRIPLES = 5_000_000;

    static final LevelRule BOUNDED = LevelRule.ofRecords((level, report) -> {
        long triples = 0;
        for (int i = 0; i < level.solids().size(); i++) {
            String path = "solids[" + i + "]";
            Solid solid = level.solids().get(i);
            if (solid instanceof Solid.Wedge wedge) {
                wedgeFaces(path, wedge, report);
            } else if (solid instanceof Solid.Prism prism) {
                prismFaces(path, prism, report);
            }
            triples += triples(solid);
            if (triples > MOST_TRIPLES) {
                report.accept(Problem.warning(path, "so many planes: this solid and those after it are not checked"));
                return;
            }
            if (triples(solid) > 0) {
                bounded(path, solid, report);
            }
        }
    });

    /** CPU time of a first picture above which {@code check} warns. */
    private static final double LONG_SECONDS = 10;

    /** CPU time to mesh, bake and draw one face, measured on one core of a machine of 2024. */
    private static final double SECONDS_PER_FACE = 8e-5;

    /** CPU time to intersect three planes of a solid, which finds its corners. */
    private static final double SECONDS_PER_TRIPLE = 8e-8;

    /** The solids are not so many that a picture of them takes long. */
    static final LevelRule COST = LevelRule.ofRecords((level, report) -> {
        long faces = level.solids().stream().mapToLong(SolidRules::faces).sum();
        long triples = level.solids().stream().mapToLong(SolidRules::triples).sum();
        double seconds = faces * SECONDS_PER_FACE + triples * SECONDS_PER_TRIPLE;
        if (seconds > LONG_SECONDS) {
            report.accept(Problem.warning(
                    "solids",
                    level.solids().size() + " solids of " + faces + " faces need some " + Math.round(seconds)
                            + " s of a processor's time before the first picture: use fewer of them, or simpler ones"));
        }
    });

    /** Surfaces closer than this count as one everywhere in the engine. */
    private static final double THINNEST_METRES = 1e-3;

    /** Greatest number of comparisons of solids: a second of work. */
    private static final long MOST_PAIRS = 5_000_000;

    private static final double SAME_NORMAL = 1 - 1e-9;

    /** No solid is thinner than the engine's tolerance. */
    static final LevelRule THICK = new LevelRule(LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> {
        FirstProblems reported = new FirstProblems("solids", report);
        for (int i = 0; i < statics.solids().size() && !reported.isFull(); i++) {
            double thickness = statics.solids().get(i).shape().thicknessMetres();
            if (thickness < THINNEST_METRES) {
                String message = "is only " + Math.round(thickness * 1e5) / 100.0
                        + " mm thick, and surfaces closer than 1 mm count as one: make it thicker or delete it";
                reported.accept(Problem.warning(FacePath.of(i), message).about(Topic.TOO_THIN));
            }
        }
    });

    /** No solid is wholly inside another. */
    static final LevelRule IN_SIGHT = new LevelRule(LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> {
        BrushIndex index = new BrushIndex(statics);
        FirstProblems reported = new FirstProblems("solids", report);
        long pairs = 0;
        for (int i = 0; i < statics.solids().size() && !reported.isFull() && pairs < MOST_PAIRS; i++) {
            ItemList near = index.near(statics.solids().get(i).shape().bounds());
            pairs += near.size();
            int around = around(index, near, i, statics.solids().size());
            if (around >= 0) {
                String message = "lies wholly inside " + FacePath.named(level, around)
                        + " and changes nothing: delete it or move it out";
                reported.accept(Problem.warning(FacePath.of(i), message)
                        .about(new Subject(Topic.INSIDE_ANOTHER, List.of(FacePath.of(around)), List.of())));
            }
        }
    });

    private SolidRules() {}

    private static int faces(Solid solid) {
        if (solid instanceof Solid.Planes given) {
            return given.planes().size();
        }
        return solid instanceof Solid.Prism prism ? prism.sides() + 2 : solid instanceof Solid.Wedge ? 5 : 6;
    }

    /** Returns the work of deriving the shape; 0 for kinds that are bounded whenever their numbers are positive. */
    private static long triples(Solid solid) {
        if (solid instanceof Solid.Box box && positive(box.size())) {
            return 0;
        }
        if (solid instanceof Solid.Prism prism
                && prism.radiusMetres() > 0
                && prism.heightMetres() > 0
                && prism.sides() >= 3
                && prism.sides() <= ConvexPolyhedron.MAX_PLANES - 2) {
            return 0;
        }
        long planes = solid instanceof Solid.Planes given ? given.planes().size() : 6;
        return 1 + planes * (planes - 1) * (planes - 2) / 6;
    }

    private static boolean positive(Vec3 size) {
        return size.x() > 0 && size.y() > 0 && size.z() > 0;
    }

    private static void bounded(String path, Solid solid, Consumer<Problem> report) {
        try {
            Brush.of(solid);
        } catch (IllegalArgumentException problem) {
            report.accept(Problem.error(path, problem.getMessage()).about(Topic.NO_VOLUME));
        }
    }

    private static void prismFaces(String path, Solid.Prism prism, Consumer<Problem> report) {
        if (prism.faces().isEmpty()) {
            return;
        }
        List<String> names = SolidFaces.names(prism);
        for (String name : prism.faces().keySet()) {
            if (!names.contains(name)) {
                String last = names.get(names.size() - 1);
                report.accept(Problem.error(
                        path + ".faces." + name,
                        "this prism has no such face: +y, -y and side 0 to " + last + " are known"));
            }
        }
    }

    private static void wedgeFaces(String path, Solid.Wedge wedge, Consumer<Problem> report) {
        for (String name : wedge.faces().keySet()) {
            if (!WEDGE_FACES.contains(name)) {
                report.accept(Problem.error(
                        path + ".faces." + name, "a wedge has no such face: +x, -x, -y, +z, -z and slope are known"));
            }
        }
    }

    /** Returns the first solid that holds another without showing anything of it; −1 for none. */
    private static int around(BrushIndex index, ItemList near, int solid, int solids) {
        Brush inner = index.brushes().get(solid);
        for (int i = 0; i < near.size() && near.get(i) < solids; i++) {
            int other = near.get(i);
            Brush outer = index.brushes().get(other);
            boolean isSecond = other < solid || !holds(inner, outer);
            if (other != solid && isSecond && holds(outer, inner) && hides(outer, inner)) {
                return other;
            }
        }
        return -1;
    }

    private static boolean holds(Brush outer, Brush inner) {
        Aabb in = inner.shape().bounds();
        if (!contains(outer.shape().bounds().grown(BrushIndex.TOUCHING_METRES), in)) {
            return false;
        }
        for (BrushFace face : outer.faces()) {
            for (Vec3 corner : inner.shape().vertices()) {
                if (face.plane().signedDistance(corner) > BrushIndex.TOUCHING_METRES) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean contains(Aabb outer, Aabb inner) {
        return outer.minX() <= inner.minX()
                && outer.minY() <= inner.minY()
                && outer.minZ() <= inner.minZ()
                && outer.maxX() >= inner.maxX()
                && outer.maxY() >= inner.maxY()
                && outer.maxZ() >= inner.maxZ();
    }

    /** Returns false if a face of the inner one is flush with one of the outer one that has other properties. */
    private static boolean hides(Brush outer, Brush inner) {
        for (BrushFace in : inner.faces()) {
            for (BrushFace out : outer.faces()) {
                if (areFlush(in, out.plane()) && !areAlike(in, out)) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean areFlush(BrushFace face, Plane plane) {
        return face.plane().normal().dot(plane.normal()) > SAME_NORMAL
                && Math.abs(plane.signedDistance(face.polygon().get(0))) <= THINNEST_METRES;
    }

    private static boolean areAlike(BrushFace a, BrushFace b) {
        return String.valueOf(a.material()).equals(String.valueOf(b.material())) && a.portalable() == b.portalable();
    }
}
