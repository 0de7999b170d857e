package nephele.engine.level.rule;

import java.util.function.Consumer;
import nephele.engine.level.Environment;
import nephele.engine.level.Light;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Problem;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;

/** Directions need not have unit length, but must not be zero: a rotation needs an axis. */
final class DirectionRules {
    /** Least length whose square is still a normal number. */
    private static final double SHORTEST = 1e-9;

    static final LevelRule NOT_ZERO = (level, assets, report) -> {
        Check check = new Check(report);
        if (level.environment().sun() != null) {
            check.sun(level.environment());
        }
        LevelRule.each("cameras", level.cameras(), (path, camera) -> check.direction(path + ".up", camera.up()));
        LevelRule.each("solids", level.solids(), check::solid);
        LevelRule.each("lights", level.lights(), check::light);
        LevelRule.each("portals", level.portals(), (path, portal) -> {
            check.direction(path + ".normal", portal.normal());
            check.direction(path + ".up", portal.up());
        });
        LevelRule.each(
                "models",
                level.models(),
                (path, model) -> LevelRule.each(path + ".transform", model.transform(), check::step));
    };

    private DirectionRules() {}

    static boolean isZero(Vec3 v) {
        return v.x() * v.x() + v.y() * v.y() + v.z() * v.z() < SHORTEST * SHORTEST;
    }

    private record Check(Consumer<Problem> report) {
        void direction(String path, Vec3 direction) {
            if (isZero(direction)) {
                report.accept(Problem.error(path, "this direction has no length: give one that points somewhere"));
            }
        }

        void sun(Environment environment) {
            Vec3 towards = environment.sun().directionTowardsSun();
            if (towards != null) {
                direction("environment.sun.directionTowardsSun", towards);
            } else if (!(environment.sky() instanceof Sky.Atmosphere)) {
                report.accept(Problem.error(
                        "environment.sun.directionTowardsSun",
                        "is missing: write a direction, such as [1, 2, 1]; only under a sky of the kind atmosphere the"
                                + " time of day gives one"));
            }
        }

        void solid(String path, Solid solid) {
            if (solid instanceof Solid.Planes planes) {
                LevelRule.each(
                        path + ".planes",
                        planes.planes(),
                        (face, plane) -> direction(face + ".normal", plane.normal()));
            }
        }

        void light(String path, Light light) {
            if (light instanceof Light.Spot spot) {
                direction(path + ".direction", spot.direction());
            }
        }

        void step(String path, ModelPlacement.TransformStep step) {
            if (step instanceof ModelPlacement.TransformStep.Rotate rotate) {
                direction(path + ".axis", rotate.axis());
            } else if (step instanceof ModelPlacement.TransformStep.Scale scale) {
                scale(path + ".by", scale.by());
            }
        }

        private void scale(String path, Vec3 by) {
            if (Math.min(Math.abs(by.x()), Math.min(Math.abs(by.y()), Math.abs(by.z()))) < SHORTEST) {
                report.accept(Problem.error(path, "a scale of zero leaves nothing: give three factors other than 0"));
            }
        }
    }
}
