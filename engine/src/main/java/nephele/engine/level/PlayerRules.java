package nephele.engine.level;

import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** A start from which the player can move. */
final class PlayerRules {
    /** The body's axis without its ends, which may touch floor and ceiling (DESIGN section 3). */
    private static final double AXIS_LOW_METRES = 0.02;

    private static final double AXIS_HIGH_METRES = 1.78;

    static final LevelRule FREE = (level, assets, report) -> {
        if (level.player() == null) {
            return;
        }
        Vec3 feet = level.player().feet();
        for (int i = 0; i < level.solids().size(); i++) {
            Solid solid = level.solids().get(i);
            if (mayReach(solid, feet) && holdsAxis(solid, feet)) {
                report.accept(Problem.error(
                        "player.feet",
                        "the player starts inside solids[" + i + "] ('" + solid.id() + "'): move the start"));
            }
        }
    };

    static final LevelRule SOMEWHERE = (level, assets, report) -> {
        if (level.player() == null && level.cameras().isEmpty()) {
            report.accept(Problem.warning("player", "there is neither a player nor a camera to look from"));
        }
    };

    private PlayerRules() {}

    /** Boxes, of which there may be very many, are told apart without making their shape. */
    private static boolean mayReach(Solid solid, Vec3 feet) {
        return !(solid instanceof Solid.Box box)
                || Math.abs(feet.x() - box.centre().x()) < box.size().x() / 2
                        && Math.abs(feet.z() - box.centre().z()) < box.size().z() / 2;
    }

    /** Clips the upright segment by every plane (Cyrus and Beck 1978); what remains lies inside. */
    private static boolean holdsAxis(Solid solid, Vec3 feet) {
        double low = AXIS_LOW_METRES;
        double high = AXIS_HIGH_METRES;
        try {
            for (ConvexPolyhedron.Face face : Brush.of(solid).shape().faces()) {
                Plane plane = face.plane();
                double atFeet = plane.signedDistance(feet);
                if (plane.ny() > 0) {
                    high = Math.min(high, -atFeet / plane.ny());
                } else if (plane.ny() < 0) {
                    low = Math.max(low, -atFeet / plane.ny());
                } else if (atFeet >= 0) {
                    return false;
                }
            }
        } catch (IllegalArgumentException toldByAnotherRule) {
            return false;
        }
        return low < high;
    }
}
