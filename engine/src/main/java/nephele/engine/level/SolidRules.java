package nephele.engine.level;

import java.util.Set;
import java.util.function.Consumer;
import nephele.engine.math.Vec3;

/** Every solid encloses a bounded volume. */
final class SolidRules {
    private static final Set<String> WEDGE_FACES = Set.of("+x", "-x", "-y", "+z", "-z", "slope");

    static final LevelRule BOUNDED = (level, assets, report) -> {
        for (int i = 0; i < level.solids().size(); i++) {
            String path = "solids[" + i + "]";
            Solid solid = level.solids().get(i);
            if (solid instanceof Solid.Wedge wedge) {
                wedgeFaces(path, wedge, report);
            }
            // A box is bounded as soon as its size is positive: ten thousand shapes need not be made to know.
            if (!(solid instanceof Solid.Box box) || !positive(box.size())) {
                bounded(path, solid, report);
            }
        }
    };

    private SolidRules() {}

    private static boolean positive(Vec3 size) {
        return size.x() > 0 && size.y() > 0 && size.z() > 0;
    }

    private static void bounded(String path, Solid solid, Consumer<Problem> report) {
        if (solid instanceof Solid.Planes planes
                && planes.planes().stream().anyMatch(plane -> DirectionRules.isZero(plane.normal()))) {
            return;
        }
        try {
            Brush.of(solid);
        } catch (IllegalArgumentException problem) {
            report.accept(Problem.error(path, problem.getMessage()));
        }
    }

    private static void wedgeFaces(String path, Solid.Wedge wedge, Consumer<Problem> report) {
        for (String name : wedge.faces().keySet()) {
            if (!WEDGE_FACES.contains(name)) {
                report.accept(Problem.error(
                        path + ".faces." + name, "a wedge has no such face: +x, -x, -y, +z, -z and slope are known"));
            }
        }
    }
}
