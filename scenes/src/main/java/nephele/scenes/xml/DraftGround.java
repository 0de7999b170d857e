package nephele.scenes.xml;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.engine.level.Camera;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.joml.Matrix4dc;
import org.joml.Vector3d;

/**
 * The additions that make a scene walkable: a floor below everything, and a start above the scene's own ground, or on
 * that floor if it has none.
 */
record DraftGround(Aabb bounds, List<Aabb> boxes, XmlScene.Eye eye) {
    static final String FLOOR = "floor";

    /** Gap below the lowest point, so that a plane there is not drawn inside the floor. */
    private static final double GAP_METRES = 0.02;

    private static final double THICKNESS_METRES = 1;
    private static final double MARGIN_METRES = 20;
    private static final double PLAYER_METRES = 2;

    /** Greatest extent of the floor; beyond, walking takes too long and the rest of a scene is sky. */
    private static final double FARTHEST_METRES = 1e5;

    /** Least width of a model on which a player starts. */
    private static final double GROUND_METRES = 4;

    /** Cosine of the greatest angle between the camera's direction and ground that it sees, from above. */
    private static final double IN_VIEW = 0.5;

    private static final int STEPS_ASIDE = 12;

    static DraftGround around(List<Aabb> boxes, XmlScene.Eye eye) {
        Aabb all = Aabb.EMPTY;
        for (Aabb box : boxes) {
            all = all.union(box);
        }
        return new DraftGround(all.isEmpty() ? Aabb.around(Vec3.ZERO, Vec3.ZERO) : within(all), boxes, eye);
    }

    private static Aabb within(Aabb box) {
        return new Aabb(
                clamped(box.minX(), FARTHEST_METRES),
                clamped(box.minY(), FARTHEST_METRES),
                clamped(box.minZ(), FARTHEST_METRES),
                clamped(box.maxX(), FARTHEST_METRES),
                clamped(box.maxY(), FARTHEST_METRES),
                clamped(box.maxZ(), FARTHEST_METRES));
    }

    private static double clamped(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }

    /** Returns the bounds of a model's box in the world. */
    static Aabb box(Aabb box, Matrix4dc worldFromModel) {
        Vector3d low = new Vector3d();
        Vector3d high = new Vector3d();
        worldFromModel.transformAab(
                new Vector3d(box.minX(), box.minY(), box.minZ()),
                new Vector3d(box.maxX(), box.maxY(), box.maxZ()),
                low,
                high);
        return low.isFinite() && high.isFinite() ? new Aabb(low.x, low.y, low.z, high.x, high.y, high.z) : Aabb.EMPTY;
    }

    double top() {
        return bounds.minY() - GAP_METRES;
    }

    Solid floor() {
        double x = bounds.maxX() - bounds.minX();
        double z = bounds.maxZ() - bounds.minZ();
        double around = 2 * MARGIN_METRES + Math.max(x, z) / 2;
        Vec3 middle = bounds.centre();
        return new Solid.Box(
                FLOOR,
                FLOOR,
                !hasGround(),
                TextureMapping.WORLD,
                new Vec3(middle.x(), top() - THICKNESS_METRES / 2, middle.z()),
                new Vec3(x + around, THICKNESS_METRES, z + around),
                Map.of());
    }

    Camera camera() {
        return new Camera(
                "scene",
                eye.position(),
                eye.lookAt(),
                eye.up(),
                0,
                eye.fovDegrees(),
                eye.near(),
                Math.min(1e7, eye.far()),
                List.of());
    }

    /** Returns true if a model is wide enough to walk on; the floor then only catches what falls. */
    boolean hasGround() {
        return boxes.stream().anyMatch(DraftGround::isWide);
    }

    private static boolean isWide(Aabb box) {
        return !box.isEmpty() && box.maxX() - box.minX() >= GROUND_METRES && box.maxZ() - box.minZ() >= GROUND_METRES;
    }

    /** Returns a start that looks at the middle, above the highest ground in view, else on the floor. */
    PlayerStart player() {
        return boxes.stream()
                .filter(DraftGround::isWide)
                .filter(box -> box.maxY() <= eye.position().y() && isInView(box))
                .sorted(Comparator.comparingDouble(box -> -box.maxY()))
                .flatMap(box -> above(box).stream())
                .findFirst()
                .orElseGet(this::onFloor);
    }

    private boolean isInView(Aabb box) {
        Vec3 forward = eye.lookAt().minus(eye.position());
        Vec3 towards = box.centre().minus(eye.position());
        double cosine = forward.x() * towards.x() + forward.z() * towards.z();
        double lengths = Math.hypot(forward.x(), forward.z()) * Math.hypot(towards.x(), towards.z());
        return cosine >= IN_VIEW * lengths;
    }

    /** Returns a free place on a model, from its middle towards the camera. */
    private Optional<PlayerStart> above(Aabb box) {
        Vec3 middle = box.centre();
        double nearX =
                Math.max(box.minX() + 1, Math.min(box.maxX() - 1, eye.position().x()));
        double nearZ =
                Math.max(box.minZ() + 1, Math.min(box.maxZ() - 1, eye.position().z()));
        for (int step = 0; step <= STEPS_ASIDE; step++) {
            double fraction = (double) step / STEPS_ASIDE;
            double x = middle.x() + fraction * (nearX - middle.x());
            double z = middle.z() + fraction * (nearZ - middle.z());
            if (!isTaken(x, box.maxY() + GAP_METRES, z)) {
                return Optional.of(new PlayerStart(new Vec3(x, box.maxY() + GAP_METRES, z), yaw(x, z), 0));
            }
        }
        return Optional.empty();
    }

    private double yaw(double x, double z) {
        Vec3 middle = bounds.centre();
        return Math.toDegrees(StrictMath.atan2(x - middle.x(), z - middle.z()));
    }

    /** Returns a start below the camera if there is room, else beside everything on the camera's side. */
    private PlayerStart onFloor() {
        Vec3 middle = bounds.centre();
        double x = clampedTo(eye.position().x(), bounds.minX(), bounds.maxX());
        double z = clampedTo(eye.position().z(), bounds.minZ(), bounds.maxZ());
        if (isTaken(x, top(), z)) {
            z = eye.position().z() < middle.z() ? bounds.minZ() - MARGIN_METRES / 4 : bounds.maxZ() + MARGIN_METRES / 4;
        }
        return new PlayerStart(new Vec3(x, top(), z), yaw(x, z), 0);
    }

    /** Clamps to the floor with a margin of a step. */
    private static double clampedTo(double value, double low, double high) {
        return Math.max(low - MARGIN_METRES + 1, Math.min(high + MARGIN_METRES - 1, value));
    }

    private boolean isTaken(double x, double feet, double z) {
        double half = PLAYER_METRES / 2;
        Aabb body = new Aabb(x - half, feet, z - half, x + half, feet + PLAYER_METRES, z + half);
        return boxes.stream().anyMatch(body::overlaps);
    }

    /**
     * Returns true if a light is inside a model, as in a bulb or a sun; a shadow-casting light there would light
     * nothing else.
     */
    boolean isEnclosed(Vec3 light) {
        Aabb point = Aabb.around(light, Vec3.ZERO);
        return boxes.stream().anyMatch(point::overlaps);
    }

    /** Returns the mean distance of a light to the models. */
    double meanDistanceMetres(Vec3 from) {
        return boxes.stream()
                .filter(box -> !box.isEmpty())
                .mapToDouble(box -> box.centre().toVector().distance(from.x(), from.y(), from.z()))
                .average()
                .orElse(1);
    }

    /** Returns the distance of a light to the farthest corner. */
    double reachMetres(Vec3 from) {
        double x = Math.max(Math.abs(bounds.minX() - from.x()), Math.abs(bounds.maxX() - from.x()));
        double y = Math.max(Math.abs(top() - from.y()), Math.abs(bounds.maxY() - from.y()));
        double z = Math.max(Math.abs(bounds.minZ() - from.z()), Math.abs(bounds.maxZ() - from.z()));
        return Math.sqrt(x * x + y * y + z * z);
    }
}
