package nephele.engine.level;

import java.util.List;
import java.util.function.Consumer;
import nephele.engine.math.Vec3;

/** Directions need not have unit length, but some length: there is no rotation without an axis. */
final class DirectionRules {
    /** Below it the square of a length is no longer a normal number to divide by. */
    private static final double SHORTEST = 1e-9;

    static final LevelRule NOT_ZERO = (level, assets, report) -> {
        Check check = new Check(report);
        if (level.environment().sun() != null) {
            check.direction(
                    "environment.sun.directionTowardsSun",
                    level.environment().sun().directionTowardsSun());
        }
        for (int i = 0; i < level.cameras().size(); i++) {
            check.direction("cameras[" + i + "].up", level.cameras().get(i).up());
        }
        for (int i = 0; i < level.solids().size(); i++) {
            if (level.solids().get(i) instanceof Solid.Planes planes) {
                check.planes("solids[" + i + "].planes", planes.planes());
            }
        }
        for (int i = 0; i < level.lights().size(); i++) {
            if (level.lights().get(i) instanceof Light.Spot spot) {
                check.direction("lights[" + i + "].direction", spot.direction());
            }
        }
        for (int i = 0; i < level.portals().size(); i++) {
            check.direction("portals[" + i + "].normal", level.portals().get(i).normal());
            check.direction("portals[" + i + "].up", level.portals().get(i).up());
        }
        for (int i = 0; i < level.models().size(); i++) {
            check.steps("models[" + i + "].transform", level.models().get(i).transform());
        }
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

        void planes(String path, List<Solid.PlaneFace> planes) {
            for (int i = 0; i < planes.size(); i++) {
                direction(path + "[" + i + "].normal", planes.get(i).normal());
            }
        }

        void steps(String path, List<ModelPlacement.TransformStep> steps) {
            for (int i = 0; i < steps.size(); i++) {
                if (steps.get(i) instanceof ModelPlacement.TransformStep.Rotate rotate) {
                    direction(path + "[" + i + "].axis", rotate.axis());
                } else if (steps.get(i) instanceof ModelPlacement.TransformStep.Scale scale) {
                    scale(path + "[" + i + "].by", scale.by());
                }
            }
        }

        private void scale(String path, Vec3 by) {
            if (Math.min(Math.abs(by.x()), Math.min(Math.abs(by.y()), Math.abs(by.z()))) < SHORTEST) {
                report.accept(Problem.error(path, "a scale of zero leaves nothing: give three factors other than 0"));
            }
        }
    }
}
