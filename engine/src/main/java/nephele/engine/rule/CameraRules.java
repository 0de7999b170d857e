package nephele.engine.rule;

import java.util.function.Consumer;
import nephele.engine.level.Camera;
import nephele.engine.level.Problem;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** Rules for cameras that cannot show a picture. */
final class CameraRules {
    /** Least ratio of far to near distance; below it the depth range is empty. */
    private static final double FAR_TO_NEAR = 1 + 1e-3;

    /** Sine of the angle between view and up below which the roll is undefined. */
    private static final double PARALLEL = 1e-6;

    static final LevelRule VIEW = LevelRule.ofRecords((level, report) ->
            LevelRule.each("cameras", level.cameras(), (path, camera) -> camera(path, camera, report)));

    private CameraRules() {}

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
