package nephele.workshop.prove.picture;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sun;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.light.LightShadowLayers;
import nephele.engine.scene.light.ShadowCasters;
import nephele.engine.scene.light.ShadowFrame;

/**
 * A scene of white walls of 10 cm that meet in joints, on a floor and partly under a roof, with posts and a board. It
 * is lit by a sun of any height, sometimes grazing a wall, by a point light or by a spot light. The scene's number
 * determines it.
 */
final class ShadowScene {
    private static final double THICKNESS_METRES = 0.1;
    private static final double OUTER_DEGREES = 40;
    private static final Vec3 ONE = new Vec3(1, 1, 1);
    private static final Vec3 FIVE = new Vec3(5, 5, 5);

    private final WhiteBoxes boxes = new WhiteBoxes();
    private final Vec3 towardsSun;
    private final Vec3 light;
    /** The axis of a spot light's cone; {@code null} for a point light. */
    private final Vec3 axis;

    private final double half;
    /** The side in metres of the sun's texels, after {@link #fitted}. */
    private double sunTexel;

    ShadowScene(long number) {
        var random = new SplittableRandom(number);
        half = 2 + 2 * random.nextDouble();
        double high = 2 + random.nextDouble();
        boxes.box(0, -THICKNESS_METRES / 2, 0, 2 * half + 4, THICKNESS_METRES, 2 * half + 4);
        boxes.box(-half, high / 2, 0, THICKNESS_METRES, high, 2 * half + THICKNESS_METRES);
        boxes.box(0, high / 2, -half, 2 * half - THICKNESS_METRES, high, THICKNESS_METRES);
        boxes.box(
                half * (random.nextDouble() - 0.5),
                high / 2,
                -half / 2,
                THICKNESS_METRES,
                high,
                half - THICKNESS_METRES);
        boxes.box(
                -half / 2,
                high + THICKNESS_METRES / 2,
                -half / 2,
                half + THICKNESS_METRES,
                THICKNESS_METRES,
                half + THICKNESS_METRES);
        for (int i = 0; i < 3; i++) {
            double tall = 0.3 + 1.5 * random.nextDouble();
            boxes.box(half * random.nextDouble(), tall / 2, half * (random.nextDouble() - 0.3), 0.2, tall, 0.2);
        }
        boolean isSunny = random.nextInt(3) > 0;
        double yaw = random.nextInt(2) == 0 ? Math.PI / 2 * random.nextInt(4) + 0.05 : 7 * random.nextDouble();
        Vec3 direction = new Vec3(StrictMath.cos(yaw), 0.05 + 1.5 * random.nextDouble(), StrictMath.sin(yaw));
        towardsSun = isSunny ? direction : null;
        light = isSunny
                ? null
                : new Vec3(half * (random.nextDouble() - 0.3), 0.5 + random.nextDouble(), half * random.nextDouble());
        axis = isSunny || random.nextBoolean() ? null : new Vec3(-half - light.x(), -light.y(), -half / 2 - light.z());
    }

    Level level() {
        return level(true);
    }

    Level levelWithoutShadows() {
        return level(false);
    }

    private Level level(boolean casts) {
        Sun sun = towardsSun == null ? null : new Sun(towardsSun, ONE, casts);
        List<Light> lights = light == null ? List.of() : List.of(light(casts));
        return boxes.lit(sun, lights);
    }

    private Light light(boolean casts) {
        return axis == null
                ? new Light.Point("lamp", light, FIVE, 30, casts)
                : new Light.Spot("lamp", light, axis, FIVE, 30, OUTER_DEGREES - 5, OUTER_DEGREES, casts);
    }

    /** Returns the vector from a place to the light; a unit vector for the sun. */
    Vec3 towardsLight(Vec3 place) {
        if (light == null) {
            double length = towardsSun.toVector().length();
            return new Vec3(towardsSun.x() / length, towardsSun.y() / length, towardsSun.z() / length);
        }
        return light.minus(place);
    }

    /** Returns the multiple of {@link #towardsLight} within which something may cast a shadow. */
    double limit() {
        return light == null ? Double.POSITIVE_INFINITY : 1;
    }

    /** Returns the side in metres of the shadow map's texel at a place. */
    double texelMetres(Vec3 place) {
        if (axis != null) {
            Vec3 towards = towardsLight(place);
            double depth = -towards.dot(Directions.unit(axis));
            return 2 * depth * Math.tan(Math.toRadians(OUTER_DEGREES)) / LightShadowLayers.MAX_SIDE_TEXELS;
        }
        if (light != null) {
            Vec3 towards = towardsLight(place);
            double depth = Math.max(Math.abs(towards.x()), Math.max(Math.abs(towards.y()), Math.abs(towards.z())));
            return 2 * depth / LightShadowLayers.MAX_SIDE_TEXELS;
        }
        return sunTexel;
    }

    /** Returns true if the lit part of the face at a place may fall between the shadow map's texels. */
    boolean isTooNarrow(Vec3 place) {
        Vec3 towards = towardsLight(place);
        double length = towards.length();
        var unit = new Vec3(towards.x() / length, towards.y() / length, towards.z() / length);
        List<Brush> brushes = boxes.brushes();
        return LitPart.at(brushes, place, unit, Math.min(length * limit(), 1e3))
                .isNarrowerThan(Math.sqrt(2) * texelMetres(place));
    }

    /** Fits the sun's shadow map as the engine does. */
    ShadowScene fitted(Quality quality) {
        if (light == null) {
            List<Brush> brushes = boxes.brushes();
            List<Vec3> corners = ShadowCasters.of(brushes, towardsSun).stream()
                    .flatMap(brush -> brush.shape().vertices().stream())
                    .toList();
            sunTexel = ShadowFrame.fit(corners, towardsSun, Vec3.ZERO, quality.shadowTexels())
                    .texelMetres();
        }
        return this;
    }

    /** Returns an eye above the open corner and a target. */
    Vec3[] camera(int number) {
        var random = new SplittableRandom(31 * number + Math.round(1000 * half));
        Vec3 eye = new Vec3(half * random.nextDouble(), 0.3 + 1.6 * random.nextDouble(), half * random.nextDouble());
        Vec3 target = new Vec3(-half * random.nextDouble(), 1.5 * random.nextDouble(), -half * random.nextDouble());
        return new Vec3[] {eye, target};
    }
}
