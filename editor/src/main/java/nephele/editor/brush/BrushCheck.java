package nephele.editor.brush;

import java.util.Optional;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;

/** Checks that a level may contain a solid. Every result of this package passes. */
public final class BrushCheck {
    /** The least extent of a brush perpendicular to a face, and the least size that a level file admits. */
    public static final double LEAST_THICKNESS_METRES = 1e-4;

    private static final double FARTHEST_METRES = 1e7;

    /** Shorter normals are refused by the rules of a level. */
    private static final double SHORTEST_NORMAL = 1e-9;

    /** Fraction by which rounding may make a brush of just the least thickness thinner. */
    private static final double ROUNDING = 1e-9;

    private BrushCheck() {}

    /** Returns why a solid is degenerate; empty for a valid one. */
    public static Optional<BrushText> refusal(Solid solid) {
        ConvexPolyhedron shape;
        try {
            shape = Brush.of(solid).shape();
        } catch (IllegalArgumentException notSolid) {
            return Optional.of(BrushText.NOT_SOLID);
        }
        if (hasShortNormal(solid)) {
            return Optional.of(BrushText.NOT_SOLID);
        } else if (!isInWorld(shape.bounds())) {
            return Optional.of(BrushText.OUT_OF_WORLD);
        }
        return isThick(solid, shape) ? Optional.empty() : Optional.of(BrushText.TOO_THIN);
    }

    /** Returns the solid, or why it is degenerate. */
    static BrushEdit<Solid> checked(Solid solid) {
        return refusal(solid).<BrushEdit<Solid>>map(BrushEdit::refused).orElseGet(() -> BrushEdit.done(solid));
    }

    /** Compares the numbers as written where a file limits them, so that rounding of corners does not matter. */
    private static boolean isThick(Solid solid, ConvexPolyhedron shape) {
        if (solid instanceof Solid.Box box) {
            return isThick(box.size());
        } else if (solid instanceof Solid.Wedge wedge && !isThick(wedge.size())) {
            return false;
        } else if (solid instanceof Solid.Prism prism
                && Math.min(prism.radiusMetres(), prism.heightMetres()) < LEAST_THICKNESS_METRES) {
            return false;
        }
        return shape.thicknessMetres() >= LEAST_THICKNESS_METRES * (1 - ROUNDING);
    }

    private static boolean isThick(Vec3 size) {
        return Math.min(size.x(), Math.min(size.y(), size.z())) >= LEAST_THICKNESS_METRES;
    }

    private static boolean hasShortNormal(Solid solid) {
        return solid instanceof Solid.Planes planes
                && planes.planes().stream().anyMatch(face -> face.normal().length() < SHORTEST_NORMAL);
    }

    private static boolean isInWorld(Aabb b) {
        double least = Math.min(b.minX(), Math.min(b.minY(), b.minZ()));
        double most = Math.max(b.maxX(), Math.max(b.maxY(), b.maxZ()));
        return least >= -FARTHEST_METRES && most <= FARTHEST_METRES;
    }
}
