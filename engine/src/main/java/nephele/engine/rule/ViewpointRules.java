package nephele.engine.rule;

import java.util.List;
import java.util.function.Consumer;
import nephele.engine.level.Brush;
import nephele.engine.level.Camera;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.Solid;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** Rules for where somebody looks from: the player's start, cameras and the observer. */
final class ViewpointRules {
    /** Height of the body's axis without its ends, which may touch floor and ceiling. */
    private static final double AXIS_LOW_METRES = 0.02;

    private static final double AXIS_HIGH_METRES = 1.78;

    static final LevelRule FREE = LevelRule.ofRecords((level, report) -> {
        if (level.player() == null) {
            return;
        }
        Vec3 feet = level.player().feet();
        LevelRule.each("solids", level.solids(), (path, solid) -> {
            if (isStandingIn(solid, feet)) {
                report.accept(Problem.error(
                                "player.feet",
                                "the player starts inside " + path + " ('" + solid.id() + "'): move the start")
                        .about(Topic.ENTITY_IN_SOLID));
            }
        });
    });

    static final LevelRule SOMEWHERE = LevelRule.ofRecords((level, report) -> {
        if (level.player() == null && level.cameras().isEmpty()) {
            report.accept(Problem.warning("player", "there is neither a player nor a camera to look from")
                    .about(Topic.NO_VIEWPOINT));
        }
    });

    /** An observer has a camera that shows its sphere, and a player at whose feet it starts. */
    static final LevelRule OBSERVER = LevelRule.ofRecords((level, report) -> {
        if (level.observer() == null) {
            return;
        }
        String camera = level.observer().camera();
        if (level.cameras().isEmpty()) {
            report.accept(Problem.error("observer.camera", "the level has no camera that shows the sphere: add one"));
        } else if (camera != null && level.cameras().stream().noneMatch(one -> camera.equals(one.id()))) {
            report.accept(Problem.error(
                    "observer.camera",
                    "there is no camera '" + camera
                            + "': name one of the level, or leave it out for the first camera"));
        }
        if (level.player() == null) {
            report.accept(Problem.error(
                    "observer", "the sphere starts at the player's feet, but there is no player: add one"));
        }
    });

    /** Least ratio of far to near distance; below it the depth range is empty. */
    private static final double FAR_TO_NEAR = 1 + 1e-3;

    /** Sine of the angle between view and up below which the roll is undefined. */
    private static final double PARALLEL = 1e-6;

    static final LevelRule CAMERAS = LevelRule.ofRecords((level, report) ->
            LevelRule.each("cameras", level.cameras(), (path, camera) -> camera(path, camera, report)));

    private ViewpointRules() {}

    /** Reports models that are closed convex solids and contain the start, as {@link #FREE} does for solids. */
    static void reportInside(Level level, PlacedModels models, Consumer<Problem> report) {
        for (PlacedModel model : models.all()) {
            if (level.player() != null
                    && model.solid() != null
                    && holdsAxis(planes(model.solid()), level.player().feet())) {
                report.accept(Problem.error(
                                "player.feet",
                                "the player starts inside models[" + model.index() + "] ('"
                                        + model.authored().id() + "'): move the start")
                        .about(Topic.ENTITY_IN_SOLID));
            }
        }
    }

    private static List<Plane> planes(Brush brush) {
        return brush.shape().faces().stream().map(ConvexPolyhedron.Face::plane).toList();
    }

    /** Returns true if a player with the feet here would be inside a solid. */
    static boolean isStandingIn(Solid solid, Vec3 feet) {
        return mayReach(solid, feet, 0) && holdsAxis(solid, feet);
    }

    /** Returns false for most solids that are out of reach, without deriving their shape. */
    static boolean mayReach(Solid solid, Vec3 feet, double margin) {
        if (solid instanceof Solid.Box box) {
            return within(
                    feet, box.centre(), box.size().x() / 2 + margin, box.size().z() / 2 + margin);
        } else if (solid instanceof Solid.Wedge wedge) {
            return within(
                    feet,
                    wedge.centre(),
                    wedge.size().x() / 2 + margin,
                    wedge.size().z() / 2 + margin);
        } else if (solid instanceof Solid.Prism prism) {
            return within(feet, prism.centre(), prism.radiusMetres() + margin, prism.radiusMetres() + margin);
        }
        return true;
    }

    private static boolean within(Vec3 feet, Vec3 centre, double halfX, double halfZ) {
        return Math.abs(feet.x() - centre.x()) < halfX && Math.abs(feet.z() - centre.z()) < halfZ;
    }

    private static boolean holdsAxis(Solid solid, Vec3 feet) {
        try {
            // Planes that enclose nothing contain every point; deriving the shape rejects them.
            return holdsAxis(planes(solid), feet) && Brush.of(solid) != null;
        } catch (IllegalArgumentException reportedByAnotherRule) {
            return false;
        }
    }

    static List<Plane> planes(Solid solid) {
        return solid instanceof Solid.Planes given
                ? given.planes().stream()
                        .map(plane -> Plane.of(plane.normal(), plane.distanceMetres()))
                        .toList()
                : planes(Brush.of(solid));
    }

    /** Clips the upright segment by every plane (Cyrus and Beck 1978); the remainder is inside. */
    private static boolean holdsAxis(List<Plane> planes, Vec3 feet) {
        double low = AXIS_LOW_METRES;
        double high = AXIS_HIGH_METRES;
        for (Plane plane : planes) {
            double atFeet = plane.signedDistance(feet);
            if (plane.ny() > 0) {
                high = Math.min(high, -atFeet / plane.ny());
            } else if (plane.ny() < 0) {
                low = Math.max(low, -atFeet / plane.ny());
            } else if (atFeet >= 0) {
                return false;
            }
        }
        return low < high;
    }

    private static void camera(String path, Camera camera, Consumer<Problem> report) {
        looksSomewhere(path, camera.position(), camera.target(), report);
        LevelRule.each(
                path + ".path",
                camera.path(),
                (place, waypoint) -> looksSomewhere(place, waypoint.position(), waypoint.target(), report));
        if (camera.horizontalFovDegrees() != 0 && camera.verticalFovDegrees() != 0) {
            report.accept(Problem.error(
                    path + ".verticalFovDegrees", "the horizontal field of view is given already: delete one"));
        }
        if (camera.farMetres() < camera.nearMetres() * FAR_TO_NEAR) {
            report.accept(Problem.error(path + ".farMetres", "must be larger than nearMetres"));
        }
        Vector3d view = camera.target().toVector().sub(camera.position().toVector());
        double scale = view.length() * camera.up().toVector().length();
        if (scale > 0 && view.cross(camera.up().toVector()).length() < PARALLEL * scale) {
            report.accept(Problem.warning(path + ".up", "points along the view, so another one is used"));
        }
    }

    private static void looksSomewhere(String path, Vec3 position, Vec3 target, Consumer<Problem> report) {
        if (position.equals(target)) {
            report.accept(Problem.error(path + ".target", "equals position: a camera must look somewhere"));
        }
    }
}
