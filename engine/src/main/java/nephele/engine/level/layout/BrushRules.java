package nephele.engine.level.layout;

import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Subject;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.PolyhedronMeasure;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;

/** Rules for solids without effect: thinner than the engine's tolerance, or wholly inside another. */
public final class BrushRules {
    /** Surfaces closer than this count as one everywhere in the engine. */
    private static final double THINNEST_METRES = 1e-3;

    /** Greatest number of comparisons of solids: a second of work. */
    private static final long MOST_PAIRS = 5_000_000;

    private static final double SAME_NORMAL = 1 - 1e-9;

    public static final LevelRule THICK = new LevelRule(LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> {
        FirstProblems reported = new FirstProblems("solids", report);
        for (int i = 0; i < statics.solids().size() && !reported.isFull(); i++) {
            double thickness =
                    PolyhedronMeasure.thicknessMetres(statics.solids().get(i).shape());
            if (thickness < THINNEST_METRES) {
                String message = "is only " + Math.round(thickness * 1e5) / 100.0
                        + " mm thick, and surfaces closer than 1 mm count as one: make it thicker or delete it";
                reported.accept(Problem.warning(FacePath.of(i), message).about(Topic.TOO_THIN));
            }
        }
    });

    public static final LevelRule IN_SIGHT = new LevelRule(LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> {
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

    private BrushRules() {}

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
        if (!contains(outer.shape().bounds().grown(BoxSide.TOUCHING_METRES), in)) {
            return false;
        }
        for (BrushFace face : outer.faces()) {
            for (Vec3 corner : inner.shape().vertices()) {
                if (face.plane().signedDistance(corner) > BoxSide.TOUCHING_METRES) {
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
