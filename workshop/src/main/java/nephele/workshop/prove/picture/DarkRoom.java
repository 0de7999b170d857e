package nephele.workshop.prove.picture;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sun;
import nephele.engine.math.Vec3;

/**
 * A closed room of white walls of 10 cm, with an inner wall and with the sun or a light outside, determined by its
 * number. No light reaches its inside.
 */
final class DarkRoom {
    private static final double THICKNESS_METRES = 0.1;
    private static final Vec3 ONE = new Vec3(1, 1, 1);

    private final WhiteBoxes boxes = new WhiteBoxes();
    private final SplittableRandom random;
    private final double width;
    private final double height;
    private final double depth;

    /** @param gapMetres between the ceiling and the walls; 0 for a closed room */
    DarkRoom(long number, double gapMetres) {
        random = new SplittableRandom(number);
        width = 2 + 4 * random.nextDouble();
        height = 2 + random.nextDouble();
        depth = 2 + 4 * random.nextDouble();
        boxes.box(
                0,
                -THICKNESS_METRES / 2,
                0,
                width + 2 * THICKNESS_METRES,
                THICKNESS_METRES,
                depth + 2 * THICKNESS_METRES);
        boxes.box(
                0,
                height + THICKNESS_METRES / 2 + gapMetres,
                0,
                width + 2 * THICKNESS_METRES,
                THICKNESS_METRES,
                depth + 2 * THICKNESS_METRES);
        for (int side = -1; side <= 1; side += 2) {
            boxes.box(
                    side * (width + THICKNESS_METRES) / 2,
                    height / 2,
                    0,
                    THICKNESS_METRES,
                    height,
                    depth + 2 * THICKNESS_METRES);
            boxes.box(0, height / 2, side * (depth + THICKNESS_METRES) / 2, width, height, THICKNESS_METRES);
        }
        boxes.box(width / 4, height / 4, -depth / 4, THICKNESS_METRES, height / 2, depth / 2);
    }

    Level level() {
        double yaw = 2 * Math.PI * random.nextDouble();
        Vec3 towards = new Vec3(StrictMath.cos(yaw), 0.05 + 2 * random.nextDouble(), StrictMath.sin(yaw));
        boolean isSunny = random.nextInt(3) > 0;
        double away = width + depth;
        var outside = new Vec3(away * towards.x(), height * towards.y(), away * towards.z());
        List<Light> lights =
                isSunny ? List.of() : List.of(new Light.Point("lamp", outside, new Vec3(500, 500, 500), 40, true));
        Sun sun = isSunny ? new Sun(towards, ONE, true) : null;
        return boxes.lit(sun, lights);
    }

    /** Returns an eye inside the room and a corner of the room as its target. */
    Vec3[] camera(int number) {
        var choice = new SplittableRandom(number);
        var eye = new Vec3(-0.3 * width * choice.nextDouble(), height / 2, 0.3 * depth * choice.nextDouble());
        var corner = new Vec3(
                width * (choice.nextInt(2) - 0.5), height * choice.nextInt(2), depth * (choice.nextInt(2) - 0.5));
        return new Vec3[] {eye, corner};
    }
}
