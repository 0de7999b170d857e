package nephele.scenes.view;

import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.joml.Vector4d;

/**
 * The viewer's third-person camera and the entity before it. The entity turns with the camera, and banks into a
 * sideways displacement.
 */
public record ThirdPersonCamera(Vec3 eye, ViewerAngles heading, Spring spring) {
    /** The distance from the camera to the entity's rest. */
    static final double REST_UNITS = 3;
    /** The distance that the entity moves from its rest before it tows the camera. */
    static final double MOST_FORCE_UNITS = 1;

    static final double MOST_BANK_DEGREES = 35;

    /** Returns a camera with an entity at its rest. */
    static ThirdPersonCamera towing(Vec3 eye, ViewerAngles heading) {
        return new ThirdPersonCamera(eye, heading, Spring.atRest(MOST_FORCE_UNITS));
    }

    /** Returns a camera without an entity: it follows the keys at once. */
    static ThirdPersonCamera alone(Vec3 eye, ViewerAngles heading) {
        return new ThirdPersonCamera(eye, heading, Spring.atRest(0));
    }

    /** Returns the camera a time later; a time that is not positive and finite changes nothing. */
    ThirdPersonCamera after(double seconds, Steering steering) {
        Spring.Step step = spring.after(seconds, steering);
        return new ThirdPersonCamera(along(step.cameraRight(), step.cameraAhead()), heading, step.spring());
    }

    ThirdPersonCamera turned(double leftDegrees, double upDegrees) {
        return new ThirdPersonCamera(eye, heading.turned(leftDegrees, upDegrees), spring);
    }

    /** Returns the entity's origin. */
    public Vec3 entity() {
        return along(spring.currentRight(), REST_UNITS + spring.currentAhead());
    }

    /** Returns the bank angle to the right, degrees. */
    public double bankDegrees() {
        return MOST_BANK_DEGREES * spring.currentRight();
    }

    /** Returns the entity's frame: its z axis points ahead, y up and x therefore to the left. */
    public Matrix4d worldFromEntity() {
        Basis view = heading.basis();
        Vec3 at = entity();
        return new Matrix4d()
                .setColumn(0, new Vector4d(view.right().toVector().negate(), 0))
                .setColumn(1, new Vector4d(view.up().toVector(), 0))
                .setColumn(2, new Vector4d(view.back().toVector().negate(), 0))
                .setColumn(3, new Vector4d(at.toVector(), 1))
                .rotateZ(StrictMath.toRadians(bankDegrees()));
    }

    private Vec3 along(double right, double ahead) {
        Basis view = heading.basis();
        return Vec3.of(eye.toVector()
                .fma(right, view.right().toVector())
                .fma(-ahead, view.back().toVector()));
    }
}
