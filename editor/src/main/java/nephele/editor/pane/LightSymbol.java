package nephele.editor.pane;

import java.util.List;
import nephele.engine.level.Light;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;

/** A lamp: a small star; if selected, its range, and a spot's two cones. */
final class LightSymbol {
    private static final double STAR_METRES = 0.18;
    private static final double AXIS_METRES = 0.6;

    private LightSymbol() {}

    static void add(Light light, Wires wires) {
        Vec3 at = light.position();
        for (int corner = 0; corner < 4; corner++) {
            double y = (corner & 1) == 0 ? 1 : -1;
            double z = (corner & 2) == 0 ? 1 : -1;
            Vec3 ray = new Vec3(1, y, z).scaled(STAR_METRES / Math.sqrt(3));
            wires.line(at.minus(ray), at.plus(ray));
        }
        double half = STAR_METRES * 0.6;
        Vec3 up = new Vec3(0, half, 0);
        wires.outline(
                List.of(at.plus(up), at.plus(new Vec3(half, 0, 0)), at.minus(up), at.minus(new Vec3(half, 0, 0))));
        wires.outline(
                List.of(at.plus(up), at.plus(new Vec3(0, 0, half)), at.minus(up), at.minus(new Vec3(0, 0, half))));
        if (light instanceof Light.Spot spot && spot.direction().length() > 0) {
            Basis frame = facing(spot);
            wires.arrow(at, at.addScaled(-AXIS_METRES, frame.back()), frame.right());
        }
    }

    private static Basis facing(Light.Spot spot) {
        return Basis.lookAt(Vec3.ZERO, spot.direction(), new Vec3(0, 1, 0), Basis.WORLD);
    }

    /** Adds where the light reaches. */
    static void addReach(Light light, Wires wires) {
        if (light instanceof Light.Spot spot && spot.direction().length() > 0) {
            cone(spot, spot.outerConeDegrees(), wires);
            cone(spot, spot.innerConeDegrees(), wires);
        } else {
            wires.sphere(light.position(), light.rangeMetres());
        }
    }

    private static void cone(Light.Spot spot, double halfAngleDegrees, Wires wires) {
        Basis frame = facing(spot);
        double range = spot.rangeMetres();
        double along = range * Math.cos(Math.toRadians(halfAngleDegrees));
        double radius = range * Math.sin(Math.toRadians(halfAngleDegrees));
        Vec3 centre = spot.position().addScaled(-along, frame.back());
        Vec3 right = frame.right().scaled(radius);
        Vec3 up = frame.up().scaled(radius);
        wires.circle(centre, right, up);
        for (Vec3 side : List.of(right, up, right.negated(), up.negated())) {
            wires.line(spot.position(), centre.plus(side));
        }
    }
}
