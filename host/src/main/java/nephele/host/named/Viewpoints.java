package nephele.host.named;

import java.util.function.IntFunction;
import java.util.stream.Collectors;
import nephele.engine.level.Camera;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.host.terminal.CommandFailure;

/** Creates the views from which pictures are rendered. Aspect is width over height. */
public final class Viewpoints {
    /** Vertical field of view of the player, the same for every aspect. */
    public static final double PLAYER_FOV_DEGREES = 60;

    private static final double NEAR_METRES = 0.05;
    private static final double EYE_METRES = 1.65;

    private Viewpoints() {}

    /**
     * Returns the view of each frame of the first camera's path, otherwise of the player's start.
     *
     * @param file the level's name for messages
     * @throws CommandFailure if the level has neither
     */
    public static IntFunction<View> standard(Level level, String file, double aspect) {
        if (!level.cameras().isEmpty()) {
            return ofCamera(level.cameras().get(0), aspect);
        }
        if (level.player() == null) {
            throw CommandFailure.input(file + ": cameras: the level has neither a camera nor a player;"
                    + " add one, or say --eye x,y,z --target x,y,z");
        }
        var view = ofPlayer(level.player(), aspect);
        return frame -> view;
    }

    /**
     * Returns the view of each frame of a camera's path.
     *
     * @param file the level's name for messages
     * @throws CommandFailure if there is no such camera
     */
    public static IntFunction<View> named(Level level, String file, String id, double aspect) {
        return level.cameras().stream()
                .filter(camera -> id.equals(camera.id()))
                .findFirst()
                .map(camera -> ofCamera(camera, aspect))
                .orElseThrow(() -> CommandFailure.input(
                        file + ": cameras: there is no camera `" + id + "`; there are: " + ids(level)));
    }

    /**
     * Returns a view that looks from {@code eye} at {@code target} with y up.
     *
     * @param horizontalFovDegrees {@code null} for the player's field of view
     * @throws CommandFailure if both points are equal
     */
    public static View between(Vec3 eye, Vec3 target, Double horizontalFovDegrees, double aspect) {
        if (eye.equals(target)) {
            throw CommandFailure.usage("--eye and --target are the same point");
        }
        double verticalFovRadians = horizontalFovDegrees == null
                ? Math.toRadians(PLAYER_FOV_DEGREES)
                : 2 * Math.atan(Math.tan(Math.toRadians(horizontalFovDegrees) / 2) / aspect);
        return View.lookAt(eye, target, new Vec3(0, 1, 0), projection(verticalFovRadians, aspect));
    }

    /** Returns the view of a player with this eye and view frame. */
    public static View ofEye(Vec3 eye, Basis basis, double verticalFovDegrees, double aspect) {
        return new View(
                eye, basis.right(), basis.up(), basis.back(), projection(Math.toRadians(verticalFovDegrees), aspect));
    }

    private static View ofPlayer(PlayerStart start, double aspect) {
        var eye = new Vec3(
                start.feet().x(), start.feet().y() + EYE_METRES, start.feet().z());
        return ofEye(
                eye,
                Basis.ofYawPitch(Math.toRadians(start.yawDegrees()), Math.toRadians(start.pitchDegrees())),
                PLAYER_FOV_DEGREES,
                aspect);
    }

    private static IntFunction<View> ofCamera(Camera camera, double aspect) {
        return frame -> View.ofCamera(camera, frame, aspect);
    }

    private static Projection projection(double verticalFovRadians, double aspect) {
        return new Projection(verticalFovRadians, aspect, NEAR_METRES, Double.POSITIVE_INFINITY);
    }

    private static String ids(Level level) {
        return level.cameras().isEmpty()
                ? "none"
                : level.cameras().stream().map(Camera::id).collect(Collectors.joining(", "));
    }
}
