package nephele.engine.math.heightfield;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

class DetailViewTest {
    private static final int VIEWS = 400;
    private static final int PLACES = 200;
    private static final double ROUNDING = 1e-9;

    /** A view at the origin with its axes. */
    private record Eye(DetailView view, Vec3 right, Vec3 up, Vec3 forward, double halfWidth, double halfHeight) {
        static Eye of(double pitch, double yaw, double roll, double halfWidth, double halfHeight) {
            Vec3 forward = new Vec3(Math.cos(pitch) * Math.cos(yaw), Math.sin(pitch), Math.cos(pitch) * Math.sin(yaw));
            Vec3 level = new Vec3(-Math.sin(yaw), 0, Math.cos(yaw));
            Vec3 above = level.cross(forward);
            Vec3 right = level.scaled(Math.cos(roll)).plus(above.scaled(Math.sin(roll)));
            Vec3 up = right.cross(forward);
            DetailView view = DetailView.of(Vec3.ZERO, right, up, forward, halfWidth, halfHeight);
            return new Eye(view, right, up, forward, halfWidth, halfHeight);
        }

        static Eye random(SplittableRandom random) {
            double pitch = Math.PI / 2 * (2 * random.nextDouble() - 1);
            double roll = random.nextInt(3) == 0 ? 7 * random.nextDouble() : 0;
            double half = 0.1 + random.nextDouble();
            return of(pitch, 7 * random.nextDouble(), roll, half * (1 + random.nextDouble()), half);
        }

        Vec3 inPicture(SplittableRandom random) {
            double x = halfWidth * (2 * random.nextDouble() - 1);
            double y = halfHeight * (2 * random.nextDouble() - 1);
            double depth = 0.1 + 100 * random.nextDouble();
            return forward.plus(right.scaled(x)).plus(up.scaled(y)).scaled(depth);
        }

        double range(Vec3 at) {
            return view.range(at.x(), at.y(), at.z());
        }
    }

    /** A point of the picture that rises by a millionth of its distance moves by that way divided by the range, at most. */
    @Test
    void theRangeBoundsWhatAVerticalWayShows() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < VIEWS * PLACES; i++) {
            Eye eye = Eye.random(random);
            Vec3 at = eye.inPicture(random);
            double depth = at.dot(eye.forward);
            Vec3 moved = new Vec3(0, depth, 0).minus(at.scaled(eye.forward.y()));
            double shown = moved.length() / (depth * depth);
            assertTrue(shown * eye.range(at) <= 1 + ROUNDING, () -> eye + ": " + at);
        }
    }

    /** A level view's range is the depth, also at the sides, where d² / r is less. */
    @Test
    void aLevelViewTakesTheDepth() {
        Eye eye = Eye.of(0, 0.3, 0, 1.1, 0.6);
        Vec3 side = eye.forward.plus(eye.right.scaled(1.1)).scaled(50);
        assertEquals(50, eye.range(side), ROUNDING);
        Eye tilted = Eye.of(-0.25, 0.3, 0, 1.03, 0.58);
        Vec3 low =
                tilted.forward.plus(tilted.right).plus(tilted.up.scaled(-0.3)).scaled(50);
        assertTrue(tilted.range(low) > 0.95 * 50, "range: " + tilted.range(low));
    }

    @Test
    void rangesChangeByTheSteepnessAtMost() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < VIEWS * PLACES; i++) {
            Eye eye = Eye.random(random);
            Vec3 from = new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
            Vec3 to =
                    from.plus(new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5)
                            .scaled(random.nextDouble()));
            double change = Math.abs(eye.range(from) - eye.range(to));
            assertTrue(change <= DetailView.STEEPNESS * to.minus(from).length() + ROUNDING, eye::toString);
        }
    }

    /** While a view turns over the nadir and rolls, no range jumps. */
    @Test
    void turningMovesRangesEvenly() {
        Vec3 place = new Vec3(3, -8, 2);
        double coarse = greatestStep(place, 500);
        double fine = greatestStep(place, 5000);
        assertTrue(fine < 0.15 * coarse, "a tenth of the step: " + fine + " after " + coarse);
    }

    private static double greatestStep(Vec3 place, int steps) {
        double greatest = 0;
        for (int i = 0; i < steps; i++) {
            double turn = Math.PI * i / steps;
            double next = Math.PI * (i + 1) / steps;
            double before = Eye.of(-turn, 0.7, 2 * turn, 1.03, 0.58).range(place);
            double after = Eye.of(-next, 0.7, 2 * next, 1.03, 0.58).range(place);
            greatest = Math.max(greatest, Math.abs(after - before));
        }
        return greatest;
    }

    @Test
    void noRangeInABoxIsLess() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < VIEWS; i++) {
            Eye eye = Eye.random(random);
            Vec3 centre = eye.inPicture(random);
            double half = 0.5 * centre.length() * random.nextDouble();
            double[] box = {
                centre.x() - half,
                centre.y() - half / 3,
                centre.z() - half,
                centre.x() + half,
                centre.y() + half / 3,
                centre.z() + half
            };
            double least = eye.view.leastRange(box);
            for (int place = 0; place < PLACES; place++) {
                double x = box[0] + (box[3] - box[0]) * random.nextInt(5) / 4;
                double y = box[1] + (box[4] - box[1]) * random.nextInt(5) / 4;
                double z = box[2] + (box[5] - box[2]) * random.nextInt(5) / 4;
                assertTrue(least <= eye.view.range(x, y, z) + ROUNDING, eye::toString);
            }
        }
    }
}
